// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "deburr/denoise.hpp"
#include "deburr/normal_filter.hpp"
#include "deburr/normals.hpp"
#include "deburr/outliers.hpp"
#include "deburr/position_update.hpp"

// The pages say what the code does: defaults are those of the structs, links lead somewhere.

namespace deburr {
namespace {

namespace fs = std::filesystem;

fs::path root() { return DEBURR_SOURCE_DIR; }

std::string read(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> pages_under(const fs::path& folder) {
  std::vector<fs::path> pages;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  return pages;
}

std::vector<std::smatch> matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), {}};
}

template <typename Value>
std::string shown(const Value& value) {
  std::ostringstream text;
  text << std::boolalpha << value;
  return text.str();
}
std::string shown(Offset v) { return v == Offset::Symmetric ? "Symmetric" : "Projected"; }
std::string shown(Quadric v) { return v == Quadric::Guarded ? "Guarded" : "Plain"; }
std::string shown(Bound v) { return v == Bound::Clamp ? "Clamp" : "Reject"; }
std::string shown(Method v) { return v == Method::Auto ? "Auto" : "Yadav2018"; }
std::string shown(OutlierAction v) { return v == OutlierAction::Label ? "Label" : "another"; }
std::string shown(NormalSource v) { return v == NormalSource::Auto ? "Auto" : "another"; }

/// Converts to whatever a field of a struct is.
struct Anything {
  template <typename Value>
  operator Value() const;  // NOLINT(google-explicit-constructor)
};

/// Number of fields of an aggregate.
template <typename Struct, typename... Fields>
constexpr std::size_t field_count() {
  if constexpr (requires { Struct{Fields{}..., Anything{}}; }) {
    return field_count<Struct, Fields..., Anything>();
  } else {
    return sizeof...(Fields);
  }
}

/// Defaults by the names that error messages use.
using Defaults = std::map<std::string, std::string>;

/// The defaults of one struct; all of its fields have to be there.
template <typename Struct>
void add(Defaults& all, const std::string& name, const Defaults& fields) {
  EXPECT_EQ(fields.size(), field_count<Struct>()) << "a field of " << name << " has no line here";
  const std::string prefix = name + ".";
  for (const auto& [field, value] : fields) all.emplace(prefix + field, value);
}

Defaults defaults() {
  Defaults all;
  const NeighborOptions neighbors;
  add<NeighborOptions>(
      all, "neighbors",
      {{"max_count", shown(neighbors.max_count)}, {"radius", shown(neighbors.radius)}});
  const NormalRefitOptions refit;
  add<NormalRefitOptions>(all, "normal_refit",
                          {{"position_scale", shown(refit.position_scale)},
                           {"normal_scale", shown(refit.normal_scale)},
                           {"blend", shown(refit.blend)}});
  const NormalFilterOptions filter;
  add<NormalFilterOptions>(all, "normal_filter",
                           {{"rho", shown(filter.rho)},
                            {"tau", shown(filter.tau)},
                            {"damping", shown(filter.damping)},
                            {"eigen_tolerance", shown(filter.eigen_tolerance)}});
  const FeatureOptions features;
  add<FeatureOptions>(all, "features",
                      {{"rho", shown(features.rho)},
                       {"tau", shown(features.tau)},
                       {"eigen_tolerance", shown(features.eigen_tolerance)}});
  const OutlierOptions outliers;
  add<OutlierOptions>(all, "outliers", {{"tolerance", shown(outliers.tolerance)}});
  const PositionUpdateOptions update;
  add<PositionUpdateOptions>(all, "position_update",
                             {{"position_scale", shown(update.position_scale)},
                              {"normal_scale", shown(update.normal_scale)},
                              {"step", shown(update.step)},
                              {"feature_step", shown(update.feature_step)},
                              {"max_move", shown(update.max_move)},
                              {"offset", shown(update.offset)},
                              {"quadric", shown(update.quadric)},
                              {"bound", shown(update.bound)}});
  const DenoiseOptions denoise;
  add<DenoiseOptions>(all, "denoise",
                      {{"method", shown(denoise.method)},
                       {"normals", shown(denoise.normals)},
                       {"automatic", "below"},
                       {"yadav2018", "below"}});
  const AutoOptions& automatic = denoise.automatic;
  add<AutoOptions>(all, "automatic",
                   {{"strength", shown(automatic.strength)},
                    {"noise", shown(automatic.noise)},
                    {"max_move", shown(automatic.max_move)},
                    {"outliers", shown(automatic.outliers)}});
  const Yadav2018Options& yadav = denoise.yadav2018;
  add<Yadav2018Options>(all, "yadav2018",
                        {{"k", shown(yadav.k)},
                         {"rounds", shown(yadav.rounds)},
                         {"rho", shown(yadav.rho)},
                         {"tau", shown(yadav.tau)},
                         {"damping", shown(yadav.damping)},
                         {"alpha", shown(yadav.alpha)},
                         {"epsilon", shown(yadav.epsilon)},
                         {"radius", shown(yadav.radius)},
                         {"rebuild", shown(yadav.rebuild)},
                         {"in_place", shown(yadav.in_place)}});
  return all;
}

// Rows look like: | `struct.field` | default | unit | ...
TEST(MethodPages, StateTheDefaultOfEveryOption) {
  Defaults missing = defaults();
  const std::regex row(R"(\| `([a-z0-9_]+\.[a-z0-9_]+)` \| ([^|]*) \|)");
  for (const fs::path& page : pages_under(root() / "docs/method")) {
    const std::string text = read(page);
    for (const std::smatch& match : matches(text, row)) {
      const auto option = missing.extract(match[1]);
      ASSERT_FALSE(option.empty()) << match[1] << " in " << page << ": unknown, or a second time";
      EXPECT_EQ(match[2], option.mapped()) << match[1] << " in " << page;
    }
  }
  for (const auto& [name, value] : missing) ADD_FAILURE() << "no page has " << name;
}

TEST(Pages, LinkToFilesThatExist) {
  std::vector<fs::path> pages = pages_under(root() / "docs");
  pages.push_back(root() / "README.md");
  for (const fs::path& page : pages) {
    const std::string text = read(page);
    for (const std::smatch& match : matches(text, std::regex(R"(\]\((?!http)([^)#]+))"))) {
      EXPECT_TRUE(fs::exists(page.parent_path() / match[1].str())) << match[1] << " in " << page;
    }
    for (const std::smatch& match :
         matches(text, std::regex(R"(`((include|src|tests)/[^` *]+)`)"))) {
      EXPECT_TRUE(fs::exists(root() / match[1].str())) << match[1] << " in " << page;
    }
  }
}

}  // namespace
}  // namespace deburr
