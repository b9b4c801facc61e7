// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "view/fields.hpp"
#include "view/packed_arrays.hpp"
#include "view/scene.hpp"

namespace deburr::view {

/// Numbers of the byte `flags`: the label of a point, and whether it is an outlier.
inline constexpr std::uint8_t unknown_label = 7;
inline constexpr std::uint8_t outlier_flag = 8;

/// One cloud of a page: its points and everything that is known of them.
class CloudPacker {
 public:
  /// @throws std::invalid_argument  for spans of another length than the cloud
  CloudPacker(const ShownCloud& shown, const SceneOptions& options, const Execution& execution);

  /// Gives the points a displacement, one number per point.
  void set_displacement(std::span<const double> values) { displacement_ = values; }
  /// Labels that stand with the same points of another cloud; used where there are no own ones.
  /// Points that the other cloud has not were left out of it, as outliers are: they are marked so.
  /// @param origin  of every point of the other cloud, its index in this one
  void adopt_flags(const CloudPacker& other, std::span<const std::uint32_t> origin);

  [[nodiscard]] std::size_t bytes_per_point() const;
  [[nodiscard]] const PointCloud& cloud() const { return *shown_.cloud; }
  /// Packs the chosen points and describes them.
  /// @param box  holds the chosen points
  [[nodiscard]] nlohmann::ordered_json pack(std::span<const std::uint32_t> chosen, const Box& box,
                                            PackedArrays& arrays) const;

 private:
  void estimate_normals(const SceneOptions& options, const Execution& execution);

  ShownCloud shown_;
  std::optional<ColourField> colours_;
  const Attribute* intensity_ = nullptr;
  std::vector<std::uint8_t> flags_;  ///< empty where nothing is known
  std::vector<Vec3> estimated_;      ///< normals, where the cloud has none
  std::span<const double> displacement_{};
};

}  // namespace deburr::view
