// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/cloud_packer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "deburr/neighborhoods.hpp"
#include "deburr/normals.hpp"
#include "spatial_order.hpp"

namespace deburr::view {
namespace {

using Json = nlohmann::ordered_json;

// A page is no place for a book.
constexpr std::size_t most_comments = 20;
constexpr std::size_t longest_comment = 200;

std::vector<std::uint32_t> finite_points(Points points) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) indices.push_back(static_cast<std::uint32_t>(i));
  }
  return indices;
}

std::vector<std::uint8_t> flags_of(const ShownCloud& shown) {
  const std::size_t size = shown.cloud->size();
  std::vector<std::uint8_t> labels;
  for (const Feature label : shown.labels) labels.push_back(static_cast<std::uint8_t>(label));
  if (labels.empty()) labels = labels_of(*shown.cloud);
  std::vector<std::uint8_t> outliers(shown.outliers.begin(), shown.outliers.end());
  if (outliers.empty()) outliers = outliers_of(*shown.cloud);
  if (labels.empty() && outliers.empty()) return {};
  std::vector<std::uint8_t> flags(size, unknown_label);
  for (std::size_t i = 0; i < size; ++i) {
    if (!labels.empty()) flags[i] = std::min(labels[i], unknown_label);
    if (!outliers.empty() && outliers[i] != 0) flags[i] |= outlier_flag;
  }
  return flags;
}

Json comments_of(const PointCloud& cloud) {
  Json comments = Json::array();
  for (const std::string& comment : cloud.layout.comments) {
    if (comments.size() == most_comments) break;
    comments.push_back(comment.substr(0, longest_comment));
  }
  return comments;
}

template <typename Value>
void check_size(const ShownCloud& shown, std::span<const Value> values, const char* what) {
  if (values.empty() || values.size() == shown.cloud->size()) return;
  throw std::invalid_argument(fmt::format("{} must have one value per point, got {} for {} points",
                                          what, values.size(), shown.cloud->size()));
}

}  // namespace

CloudPacker::CloudPacker(const ShownCloud& shown, const SceneOptions& options,
                         const Execution& execution)
    : shown_(shown),
      colours_(ColourField::of(*shown.cloud)),
      intensity_(intensity_field(*shown.cloud)) {
  check_size(shown, shown.labels, "labels");
  check_size(shown, shown.outliers, "outliers");
  check_size(shown, shown.truth_distance, "truth_distance");
  flags_ = flags_of(shown);
  if (shown.cloud->normals.empty()) estimate_normals(options, execution);
}

void CloudPacker::estimate_normals(const SceneOptions& options, const Execution& execution) {
  const std::vector<std::uint32_t> finite = finite_points(shown_.cloud->points);
  const std::vector<Vec3> points = gather<Vec3>(shown_.cloud->points, finite);
  const std::vector<Vec3> normals = deburr::estimate_normals(
      points, find_neighbors(points, {.max_count = options.normal_neighbors}, execution),
      execution);
  estimated_.resize(shown_.cloud->size());
  for (std::size_t k = 0; k < finite.size(); ++k) estimated_[finite[k]] = normals[k];
}

void CloudPacker::adopt_flags(const CloudPacker& other, std::span<const std::uint32_t> origin) {
  std::vector<bool> alone(cloud().size(), true);
  for (const std::uint32_t i : origin) alone[i] = false;
  const bool any_alone = std::ranges::find(alone, true) != alone.end();
  if (flags_.empty()) {
    if (other.flags_.empty() && !any_alone) return;
    flags_.assign(cloud().size(), unknown_label);
    for (std::size_t i = 0; i < origin.size() && !other.flags_.empty(); ++i) {
      flags_[origin[i]] = other.flags_[i];
    }
  }
  for (std::size_t i = 0; i < flags_.size(); ++i) {
    if (alone[i]) flags_[i] |= outlier_flag;
  }
}

std::size_t CloudPacker::bytes_per_point() const {
  return PointBytes::position + PointBytes::direction + (colours_ ? PointBytes::colour : 0) +
         (intensity_ != nullptr ? PointBytes::number : 0) +
         (flags_.empty() ? 0 : PointBytes::flags) +
         (displacement_.empty() ? 0 : PointBytes::number) +
         (shown_.truth_distance.empty() ? 0 : PointBytes::number);
}

Json CloudPacker::pack(std::span<const std::uint32_t> chosen, const Box& box,
                       PackedArrays& arrays) const {
  const PointCloud& cloud = *shown_.cloud;
  Json packed = Json::object();
  packed["position"] = arrays.add_positions(gather<Vec3>(cloud.points, chosen), box);
  const std::vector<Vec3>& normals = cloud.normals.empty() ? estimated_ : cloud.normals;
  packed["normal"] = arrays.add_directions(gather<Vec3>(normals, chosen));
  if (colours_) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * chosen.size());
    for (const std::uint32_t i : chosen) {
      for (const std::uint8_t channel : (*colours_)[i]) bytes.push_back(channel);
    }
    packed["colour"] = arrays.add_bytes(bytes, 3);
  }
  if (intensity_ != nullptr) {
    std::vector<double> values;
    values.reserve(chosen.size());
    for (const std::uint32_t i : chosen) values.push_back(number_at(*intensity_, i));
    packed["intensity"] = arrays.add_numbers(values);
  }
  if (!flags_.empty()) packed["flags"] = arrays.add_bytes(gather<std::uint8_t>(flags_, chosen), 1);
  if (!displacement_.empty()) {
    packed["displacement"] = arrays.add_numbers(gather<double>(displacement_, chosen));
  }
  if (!shown_.truth_distance.empty()) {
    packed["truth"] = arrays.add_numbers(gather<double>(shown_.truth_distance, chosen));
  }
  return {{"name", shown_.name},
          {"points", cloud.size()},
          {"nonFinite", cloud.size() - finite_points(cloud.points).size()},
          {"shown", chosen.size()},
          {"comments", comments_of(cloud)},
          {"estimatedNormals", cloud.normals.empty()},
          {"arrays", packed}};
}

}  // namespace deburr::view
