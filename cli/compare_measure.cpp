// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "interrupt.hpp"

namespace deburr::cli {
namespace {

/// The part of a cloud that is compared.
struct Selection {
  std::vector<std::size_t> indices;

  template <typename Value>
  [[nodiscard]] std::vector<Value> of(const std::vector<Value>& all) const {
    if (indices.size() == all.size()) return all;
    std::vector<Value> some;
    some.reserve(indices.size());
    for (const std::size_t i : indices) some.push_back(all[i]);
    return some;
  }
};

/// Whole numbers of a field with one number per point; those out of 0 to 255 become 255.
std::optional<std::vector<std::uint8_t>> read_field(const PointCloud& cloud,
                                                    const std::string& name) {
  const auto found = std::ranges::find(cloud.attributes, name, &Attribute::name);
  if (found == cloud.attributes.end() || found->is_list()) return std::nullopt;
  return std::visit(
      [](const auto& values) -> std::optional<std::vector<std::uint8_t>> {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_arithmetic_v<Value>) {
          std::vector<std::uint8_t> numbers;
          numbers.reserve(values.size());
          for (const Value value : values) {
            const auto number = static_cast<double>(value);
            numbers.push_back(number >= 0 && number <= 255 ? static_cast<std::uint8_t>(number)
                                                           : std::uint8_t{255});
          }
          return numbers;
        } else {
          return std::nullopt;
        }
      },
      found->values);
}

std::vector<Feature> to_labels(const std::vector<std::uint8_t>& numbers) {
  std::vector<Feature> labels;
  labels.reserve(numbers.size());
  for (const std::uint8_t number : numbers) {
    labels.push_back(number <= static_cast<std::uint8_t>(Feature::Isolated)
                         ? static_cast<Feature>(number)
                         : Feature::Surface);
  }
  return labels;
}

Selection select(std::size_t size, const std::optional<std::vector<std::uint8_t>>& left_out) {
  Selection selection;
  for (std::size_t i = 0; i < size; ++i) {
    if (!left_out || (*left_out)[i] == 0) selection.indices.push_back(i);
  }
  return selection;
}

class Comparer {
 public:
  Comparer(const PointCloud& cloud, const CompareOptions& options, ProgressBar& bar)
      : cloud_(cloud), options_(options), bar_(bar), flags_(read_field(cloud, "deburr_outlier")) {
    const bool skip = options.skip_outliers && flags_;
    if (options.skip_outliers && !flags_) {
      result_.warnings.emplace_back("no field deburr_outlier tells what to skip");
    }
    selection_ = select(cloud.size(), skip ? flags_ : std::nullopt);
    points_ = selection_.of(cloud.points);
    if (!cloud.normals.empty()) normals_ = selection_.of(cloud.normals);
    result_.points = points_.size();
    result_.skipped = cloud.size() - points_.size();
  }

  void with_surface(const TriangleMesh& surface) {
    result_.to_mesh = true;
    result_.error = compare_to_surface(points_, surface, part("distances", 0, 0.4));
    if (result_.error.count == 0) return;
    result_.coverage =
        surface_coverage(points_, surface, options_.coverage, part("coverage", 0.4, 0.6));
    if (!normals_.empty()) {
      result_.normals = normal_error(points_, normals_, surface, part("normals", 0.6, 0.8));
    }
    const double spacing = mean_spacing(surface, result_.error.count);
    if (spacing > 0) {
      result_.spacing = spacing;
      with_features(surface, spacing);
    }
  }

  void with_cloud(const PointCloud& truth) {
    const CloudError error = compare_to_cloud(points_, truth.points, part("distances", 0, 0.7));
    result_.error = error.to_truth;
    result_.coverage = error.coverage;
    if (result_.error.count == 0) return;
    result_.chamfer = error.chamfer;
    if (!normals_.empty() && !truth.normals.empty()) {
      result_.normals =
          normal_error(points_, normals_, truth.points, truth.normals, part("normals", 0.7, 1));
    }
  }

  void with_clean(const PointCloud& clean) {
    if (clean.size() != cloud_.size()) {
      result_.warnings.push_back(
          fmt::format("--clean has {} points, the cloud {}: they are not compared one by one",
                      clean.size(), cloud_.size()));
      return;
    }
    const auto outliers = read_field(clean, "outlier");
    if (outliers && flags_) result_.outliers = score_outliers(*flags_, *outliers);
    if (clean.normals.empty()) {
      result_.warnings.emplace_back("--clean has no normals: offsets along them are not measured");
      return;
    }
    // An outlier has no place without noise.
    std::vector<Vec3> normals = clean.normals;
    for (std::size_t i = 0; outliers && i < normals.size(); ++i) {
      if ((*outliers)[i] != 0) normals[i] = {};
    }
    const double far =
        result_.spacing ? far_offset * *result_.spacing : std::numeric_limits<double>::infinity();
    result_.offsets =
        offset_error(points_, selection_.of(clean.points), selection_.of(normals), far);
  }

  [[nodiscard]] Comparison result() && { return std::move(result_); }

 private:
  [[nodiscard]] Execution part(std::string_view stage, double from, double to) const {
    return {.threads = options_.threads,
            .progress = bar_.part(stage, from, to),
            .cancelled = interrupted};
  }

  void with_features(const TriangleMesh& surface, double spacing) {
    const SharpFeatures sharp = find_sharp_features(surface);
    if (sharp.edges.empty()) return;
    FeatureFigures figures{sharp.edges.size(), sharp.corners.size(), {}, {}};
    figures.zone = edge_error(points_, surface, sharp, spacing, part("edges", 0.8, 0.9));
    if (const auto numbers = read_field(cloud_, "deburr_label")) {
      figures.labels = score_features(points_, selection_.of(to_labels(*numbers)), sharp, spacing,
                                      part("labels", 0.9, 1));
    }
    result_.features = figures;
  }

  const PointCloud& cloud_;
  const CompareOptions& options_;
  ProgressBar& bar_;
  std::optional<std::vector<std::uint8_t>> flags_;
  Selection selection_;
  std::vector<Vec3> points_;
  std::vector<Vec3> normals_;
  Comparison result_;
};

}  // namespace

Comparison compare(const PointCloud& cloud, const Truth& truth,
                   const std::optional<PointCloud>& clean, const CompareOptions& options,
                   ProgressBar& bar) {
  Comparer comparer(cloud, options, bar);
  if (const auto* const surface = std::get_if<TriangleMesh>(&truth)) {
    comparer.with_surface(*surface);
  } else {
    comparer.with_cloud(std::get<PointCloud>(truth));
  }
  if (clean) comparer.with_clean(*clean);
  return std::move(comparer).result();
}

}  // namespace deburr::cli
