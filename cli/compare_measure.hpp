// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "console.hpp"
#include "deburr/clean_metrics.hpp"
#include "deburr/cloud_metrics.hpp"
#include "deburr/feature_metrics.hpp"
#include "deburr/normal_metrics.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr::cli {

using Truth = std::variant<TriangleMesh, PointCloud>;

/// What `deburr compare` can be told about the comparison.
struct CompareOptions {
  CoverageOptions coverage;
  bool skip_outliers = false;  ///< leave out points whose field deburr_outlier is not 0
  int threads = 0;
};

/// The sharp features of the truth, and how points and labels do there.
struct FeatureFigures {
  std::size_t edges = 0;
  std::size_t corners = 0;
  DistanceError zone;                  ///< of the points near an edge
  std::optional<FeatureScore> labels;  ///< where the cloud has labels
};

/// All figures; what cannot be told is absent.
struct Comparison {
  bool to_mesh = false;
  std::size_t points = 0;    ///< compared, those that are not finite among them
  std::size_t skipped = 0;   ///< left out as outliers
  DistanceError error{};     ///< from the points to the truth
  DistanceError coverage{};  ///< from the truth to the points
  std::optional<double> chamfer{};
  std::optional<double> spacing{};  ///< of the finite points on the true surface
  std::optional<NormalError> normals{};
  std::optional<FeatureFigures> features{};
  std::optional<OutlierScore> outliers{};
  std::optional<OffsetError> offsets{};
  std::vector<std::string> warnings{};
};

/// Offsets are called far from this many spacings on.
inline constexpr double far_offset = 1.5;

/// Compares a cloud with the truth, and point by point with itself without noise if that is given.
/// Without a finite point, error.count is 0 and nothing else is measured.
[[nodiscard]] Comparison compare(const PointCloud& cloud, const Truth& truth,
                                 const std::optional<PointCloud>& clean,
                                 const CompareOptions& options, ProgressBar& bar);

}  // namespace deburr::cli
