// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "console.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr::cli {

/// A box with sides along the axes.
struct Box {
  Vec3 low;
  Vec3 high;
};

/// One quantity that a file holds, e.g. "red", "uint8".
struct FieldInfo {
  std::string name;
  std::string type;  ///< of one value
  bool list = false;
};

/// Something in a file other than points.
struct ElementInfo {
  std::string name;
  std::size_t size = 0;
  std::vector<FieldInfo> fields;
};

/// What `deburr info` has to tell of a point cloud. Lengths are in input units.
struct CloudInfo {
  std::size_t points = 0;
  std::size_t non_finite = 0;
  std::size_t duplicates = 0;  ///< points at the very place of another one
  std::optional<Box> box;      ///< of the finite points, where there are some
  double spacing = 0;          ///< mean distance to the 12 nearest points at other places
  double noise = 0;            ///< estimated standard deviation across the surface
  std::vector<FieldInfo> fields;
  std::vector<ElementInfo> elements;
  std::vector<std::string> blocks;  ///< what only the format of the file understands
  std::size_t comments = 0;

  [[nodiscard]] double noise_in_spacings() const { return spacing > 0 ? noise / spacing : 0; }
};

[[nodiscard]] CloudInfo measure(const PointCloud& cloud, int threads, ProgressBar& bar);

[[nodiscard]] nlohmann::ordered_json to_json(const CloudInfo& info);

/// A table for people.
[[nodiscard]] std::string to_text(const CloudInfo& info);

}  // namespace deburr::cli
