// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

enum class Method {
  Auto,      ///< the default schedule: independent of unit, point order and normal signs
  Yadav2018  ///< the published program, exactly, its known flaws included
};

/// Where the first normals come from.
enum class NormalSource {
  Auto,     ///< those of the cloud where it has them, else estimated
  Keep,     ///< those of the cloud; a DataError where it has none
  Estimate  ///< estimated from the positions
};

/// Parameters of the published method with its published defaults. dbar is the mean distance of a
/// point to its k nearest other points.
struct Yadav2018Options {
  std::size_t k = 12;    ///< neighbours for the first normals, their orientation and dbar, >= 3
  int rounds = 50;       ///< >= 0; there is no stopping test
  double rho = 0.9;      ///< similarity of normals: n_i . n_j > rho; in [0, 1)
  double tau = 0.25;     ///< eigenvalue threshold of both stages; in (0, 1)
  double damping = 3;    ///< share of the old normal; in [0, 1e6]
  double alpha = 0.1;    ///< step of surface points; in (0, 1]
  double epsilon = 2;    ///< largest distance from the original position, in dbar; in (0, 1e6]
  double radius = 2;     ///< r, scale of the weights, in dbar; in (0, 1e6]; neighbours: 2.5 r
  bool rebuild = false;  ///< find the neighbourhoods again in every round
  bool in_place = true;  ///< a point sees the new positions of those before it
};

/// Parameters of the default schedule. Lengths are in dbar, the mean distance of a point to its 12
/// nearest other points, so that no result depends on the unit of the input.
struct AutoOptions {
  int rounds = 10;                    ///< >= 0
  std::size_t normal_neighbors = 30;  ///< for the first normals and their orientation, >= 3
  double radius = 3.5;                ///< of the neighbourhoods, in dbar, > 0
  std::size_t max_neighbors = 256;    ///< the nearest so many of those within the radius, >= 3
  double position_scale = 1.5;        ///< of the weights, in dbar, > 0
  double normal_scale = 0.3;          ///< of the weights, > 0
  double step = 0.5;                  ///< of surface points, in (0, 1]
  double max_move = 4;                ///< largest distance from the original, in sigma, > 0
};

/// What denoise() does.
struct DenoiseOptions {
  Method method = Method::Auto;
  NormalSource normals = NormalSource::Auto;
  AutoOptions automatic{};       ///< used by Method::Auto
  Yadav2018Options yadav2018{};  ///< used by Method::Yadav2018
};

/// What one round did.
struct RoundReport {
  double rms_move = 0;  ///< root mean square movement of the points in this round, input units
  double max_move = 0;  ///< largest movement in this round, input units
};

/// How long one stage took over all rounds.
struct StageTime {
  std::string_view stage;
  double seconds = 0;  ///< 0 without Execution::clock
};

/// What denoise() found and did.
struct Report {
  std::size_t points = 0;
  std::size_t non_finite = 0;  ///< points with a NaN or infinite coordinate; written back as is
  std::size_t duplicates = 0;  ///< points at the very place of an earlier one
  double spacing = 0;          ///< dbar, input units
  double noise = 0;            ///< estimated standard deviation of the noise, input units
  double max_move = 0;         ///< the bound on the movement that was used, input units
  bool kept_normals = false;   ///< whether the first normals came from the cloud
  std::array<std::size_t, 4> labels{};  ///< points per Feature, in its order
  std::vector<RoundReport> rounds;
  std::vector<StageTime> stages;
};

/// The clean cloud and what is known of it. Arrays are in the order of the input points.
struct DenoiseResult {
  PointCloud cloud;                  ///< moved points with their normals; attributes as they came
  std::vector<Feature> labels;       ///< what each point lies on
  std::vector<double> displacement;  ///< distance that each point moved, input units
  Report report;
};

/// Takes the noise off a point cloud and keeps its edges and corners.
///
/// Runs rounds of three stages: filter the normals, label each point surface, edge or corner, move
/// it to agree with the normals around it, never farther than a bound. Normals of the cloud that
/// are zero or not finite are estimated (Method::Yadav2018 leaves such points alone). Points that
/// are not finite, or have nothing near them to be compared with, stay as they are to the last bit
/// and are labelled isolated. A cloud of fewer than 4 distinct points comes back unchanged.
///
/// Source: Yadav, Reitebuch, Skrodzki, Zimmermann, Polthier, Constraint-based point set denoising
/// using normal voting tensor and restricted quadratic error metrics, Computers & Graphics 74,
/// 2018.
///
/// @throws std::invalid_argument  naming the option and the value, for an option out of its range
/// @throws DataError  for NormalSource::Keep on a cloud without normals, neighbourhoods too large
///                    for any memory (only without a limit on their number), or distances too
///                    large for a double (only by Method::Yadav2018)
/// @throws Cancelled  when execution.cancelled says so
[[nodiscard]] DenoiseResult denoise(const PointCloud& cloud, const DenoiseOptions& options = {},
                                    const Execution& execution = {});

}  // namespace deburr
