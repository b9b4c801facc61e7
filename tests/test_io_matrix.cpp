// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "deburr/error.hpp"
#include "support/cloud_files.hpp"
#include "support/same_cloud.hpp"
#include "support/say_the_same.hpp"

// The table of docs/formats.md: what of a cloud survives in which format, found out by trying.

namespace deburr {
namespace {

namespace fs = std::filesystem;

/// Something that a cloud can have.
struct Kind {
  std::string label;
  std::function<void(PointCloud&)> add;
  std::vector<std::string> names{};  ///< of attributes, elements, or what warnings call it
};

/// Four points and two faces, in the order in which the faces use the points.
PointCloud square() {
  PointCloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};
  cloud.layout.elements = {
      {"face",
       2,
       {{"vertex_indices", std::vector<std::int32_t>{0, 1, 2, 0, 2, 3}, {0, 3, 6}}},
       false}};
  return cloud;
}

Element& faces_of(PointCloud& cloud) { return cloud.layout.elements[0]; }

template <typename T>
void add(PointCloud& cloud, const std::string& name, const std::vector<T>& values,
         std::vector<std::size_t> offsets = {}) {
  cloud.attributes.push_back({name, values, std::move(offsets)});
}

template <typename T>
void add_extremes(PointCloud& cloud, const std::string& name) {
  using Limits = std::numeric_limits<T>;
  add<T>(cloud, name, {Limits::min(), Limits::max(), 0, 1});
}

template <typename T>
void add_colors(PointCloud& cloud, T low, T high) {
  for (const char* name : {"red", "green", "blue"}) add<T>(cloud, name, {low, high, T{0}, T{1}});
}

std::vector<Kind> all_kinds() {
  const std::vector<std::string> rgb{"red", "green", "blue"};
  return {
      {"order of points",
       [](PointCloud& c) {
         faces_of(c).attributes[0].values = std::vector<std::int32_t>{3, 2, 1, 1, 0, 3};
       }},
      {"coordinates",
       [](PointCloud& c) {
         c.points[1] = {500000.123456789, 1.0 / 3, 1};
       }},
      {"coordinates that are floats",
       [](PointCloud& c) {
         for (const char* name : {"x", "y", "z"}) {
           c.layout.fields.push_back({name, ScalarType::Float32});
         }
         c.points[1].x = 1.1F;
       }},
      {"NaN and infinite coordinates",
       [](PointCloud& c) {
         c.points[1] = {std::nan(""), -std::numeric_limits<double>::infinity(), 1};
       }},
      {"normals",
       [](PointCloud& c) {
         c.normals.assign(4, {0, 0.6, 0.8});
       },
       {"normals"}},
      {"integers of 8 to 32 bits",
       [](PointCloud& c) {
         add_extremes<std::int8_t>(c, "a");
         add_extremes<std::uint8_t>(c, "b");
         add_extremes<std::int16_t>(c, "c");
         add_extremes<std::uint16_t>(c, "d");
         add_extremes<std::int32_t>(c, "e");
         add_extremes<std::uint32_t>(c, "f");
       },
       {"a", "b", "c", "d", "e", "f"}},
      {"integers of 64 bits, up to 2^53",
       [](PointCloud& c) {
         add<std::int64_t>(c, "a", {-1, std::int64_t{1} << 53, 2, 3});
       },
       {"a"}},
      {"larger integers", [](PointCloud& c) { add_extremes<std::int64_t>(c, "a"); }, {"a"}},
      {"floats and doubles",
       [](PointCloud& c) {
         add<float>(c, "a", {0.1F, std::nanf(""), 1, 2});
         add<double>(c, "b", {0.1, std::numeric_limits<double>::infinity(), 1e-300, 2});
       },
       {"a", "b"}},
      {"text",
       [](PointCloud& c) {
         add<std::string>(c, "a", {"x", "", "y z", "\"1,2\""});
       },
       {"a"}},
      {"lists of one length",
       [](PointCloud& c) {
         add<float>(c, "a", {0, 1, 2, 3, 4, 5, 6, 7}, {0, 2, 4, 6, 8});
       },
       {"a"}},
      {"other lists",
       [](PointCloud& c) {
         add<float>(c, "a", {0, 1, 2, 3}, {0, 0, 3, 3, 4});
       },
       {"a"}},
      {"red green blue of 8 bits", [](PointCloud& c) { add_colors<std::uint8_t>(c, 2, 255); }, rgb},
      {"red green blue of 16 bits", [](PointCloud& c) { add_colors<std::uint16_t>(c, 2, 65535); },
       rgb},
      {"red green blue from 0 to 1", [](PointCloud& c) { add_colors<float>(c, 0.1F, 0.7F); }, rgb},
      {"faces", [](PointCloud&) {}, {"face"}},
      {"faces of more than three corners",
       [](PointCloud& c) {
         faces_of(c).size = 1;
         faces_of(c).attributes[0].values = std::vector<std::int32_t>{0, 1, 2, 3};
         faces_of(c).attributes[0].offsets = {0, 4};
       },
       {"face"}},
      {"numbers of faces",
       [](PointCloud& c) {
         faces_of(c).attributes.push_back({"quality", std::vector<float>{1, 2}, {}});
       },
       {"quality"}},
      {"other elements",
       [](PointCloud& c) {
         c.layout.elements.push_back({"camera", 1, {{"a", std::vector<float>{1}, {}}}, false});
       },
       {"camera"}},
      {"comments", [](PointCloud& c) { c.layout.comments = {"by hand"}; }, {"comments"}},
  };
}

/// How much is left of something, from best to worst.
enum Left { same, value, rounded, lost, refused };
constexpr const char* words[] = {"yes", "value", "rounded", "no", "refused"};

Left left_of(const Attribute& before, const Attribute* after) {
  if (after == nullptr) return lost;
  if (!say_the_same(before, *after)) return rounded;
  return after->type() == before.type() ? same : value;
}

Left left_of_points(const PointCloud& before, const PointCloud& after) {
  if (same_values(after.points, before.points)) return same;
  if (after.size() != before.size()) return lost;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (norm(after.points[i] - before.points[i]) > 1) return lost;
  }
  return rounded;
}

Left left_of_element(const std::string& name, const PointCloud& before, const PointCloud& after) {
  const auto find = [&](const PointCloud& c) {
    return std::ranges::find(c.layout.elements, name, &Element::name);
  };
  const auto found = find(after);
  if (found == after.layout.elements.end()) return lost;
  const bool is_whole = found->size == find(before)->size &&
                        say_the_same(find(before)->attributes[0], found->attributes[0]);
  return is_whole ? same : value;
}

Left left_of(const std::string& name, const PointCloud& before, const PointCloud& after) {
  if (name == "normals") return after.normals == before.normals ? same : lost;
  if (name == "comments") return after.layout.comments == before.layout.comments ? same : lost;
  if (name == "face" || name == "camera") return left_of_element(name, before, after);
  if (name == "quality") {
    if (after.layout.elements.empty()) return lost;
    const auto& all = after.layout.elements[0].attributes;
    const auto found = std::ranges::find(all, name, &Attribute::name);
    return left_of(before.layout.elements[0].attributes[1], found != all.end() ? &*found : nullptr);
  }
  return left_of(*find_attribute(before, name), find_attribute(after, name));
}

/// What a format leaves of a kind. Whatever is lost has to be named.
Left left_in(const TempDir& dir, const Kind& kind, const std::string& format) {
  SCOPED_TRACE(kind.label + " in " + format);
  PointCloud cloud = square();
  kind.add(cloud);
  std::vector<std::string> warnings;
  std::string file;
  try {
    file = written_as(dir, cloud, "a." + format, &warnings);
  } catch (const DataError&) {
    return refused;
  }
  const PointCloud again = parsed(file, format);
  if (kind.names.empty()) return left_of_points(cloud, again);
  Left worst = same;
  for (const std::string& name : kind.names) {
    const Left left = left_of(name, cloud, again);
    worst = std::max(worst, left);
    const bool with_all_faces = name == "quality" && are_named(warnings, "'face'");
    EXPECT_TRUE(left < rounded || with_all_faces || are_named(warnings, name)) << name;
  }
  return worst;
}

std::string table(const TempDir& dir) {
  const std::vector<std::string> formats{"ply", "las", "pcd", "csv", "obj", "off", "stl"};
  std::string text =
      "| | PLY | LAS | PCD | text | OBJ | OFF | STL |\n|---|---|---|---|---|---|---|---|\n";
  for (const Kind& kind : all_kinds()) {
    text += "| " + kind.label + " |";
    for (const std::string& format : formats) {
      text += std::string(" ") + words[left_in(dir, kind, format)] + " |";
    }
    text += "\n";
  }
  return text;
}

TEST(Matrix, IsThatOfTheDocumentation) {
  const TempDir dir;
  const std::string now = table(dir);
  EXPECT_THAT(get(fs::path(DEBURR_SOURCE_DIR) / "docs/formats.md"), testing::HasSubstr("\n" + now))
      << "docs/formats.md should have this table:\n"
      << now;
}

}  // namespace
}  // namespace deburr
