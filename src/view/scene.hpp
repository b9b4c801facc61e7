// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/point_cloud.hpp"
#include "view/up.hpp"

namespace deburr::view {

/// A cloud to look at, and what is known of its points. Spans are empty, or have one value per
/// point.
struct ShownCloud {
  std::string name;                          ///< shown as it is, e.g. the name of its file
  const PointCloud* cloud = nullptr;         ///< never null
  std::span<const Feature> labels{};         ///< without them, those in the attributes
  std::span<const std::uint8_t> outliers{};  ///< without them, those in the attributes
  std::span<const double> truth_distance{};  ///< distance from a true surface, input units
};

/// What is to be seen.
struct Request {
  ShownCloud before;
  std::optional<ShownCloud> after{};  ///< without it one cloud is shown
  /// For each point of `after` the index of the same point in `before`. Empty: clouds of one size
  /// hold the same points in the same order, unless they lie so far apart that this cannot be. A
  /// smaller one is matched with the first where its deburr_displacement tells how.
  std::span<const std::uint32_t> origin{};
};

struct SceneOptions {
  std::size_t max_bytes = 12'000'000;  ///< of a whole page
  std::size_t normal_neighbors = 12;   ///< for normals, where a cloud has none
  Up up = Up::Z;                       ///< axis that points up at first
};

/// Points as a page holds them.
struct Scene {
  std::string description{};         ///< JSON object; docs/view.md names the keys
  std::string data{};                ///< the arrays that it describes, one after the other
  bool paired = false;               ///< whether the movement of points is known
  std::vector<std::size_t> shown{};  ///< points of each cloud
  std::vector<std::string> warnings{};
};

/// Chooses the points that a page shows, and packs what is known of them. Points that are not
/// finite cannot be shown. Where normals are missing they are estimated.
///
/// @param room  bytes of the page that are left for points
/// @throws std::invalid_argument  for spans of another length than the cloud, or an index in
///                                `origin` that is none
/// @throws Cancelled  when execution.cancelled says so
[[nodiscard]] Scene make_scene(const Request& request, std::size_t room,
                               const SceneOptions& options = {}, const Execution& execution = {});

}  // namespace deburr::view
