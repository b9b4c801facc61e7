// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

enum class Method {
  Auto,      ///< the default method: finds every parameter, whatever unit and order
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

/// What becomes of outliers: points and small groups that are no part of the surface.
enum class OutlierAction {
  Label,   ///< they stay, unmoved, and are marked in DenoiseResult::outliers
  Remove,  ///< they are left out of the result
  Keep     ///< none are looked for: every point counts as a part of the surface
};

/// Parameters of the default method. It needs none of them: what it works with is estimated.
struct AutoOptions {
  /// How much of what could be noise is taken for noise, 1 to 5: each step makes the noise that is
  /// assumed larger by a factor of sqrt(2), 3 is the estimate.
  int strength = 3;
  double noise = 0;     ///< standard deviation of the noise, input units, >= 0; 0 to estimate it
  double max_move = 0;  ///< no point moves farther, input units, >= 0; 0 for 4 times the noise,
                        ///< less between sheets that lie close over each other
  OutlierAction outliers = OutlierAction::Label;
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
  /// Points at the very place of an earlier one; by Method::Auto also those within about a
  /// thousandth of the spacing, where they are a thousandth of all or more. They move as that one
  /// does.
  std::size_t duplicates = 0;
  std::size_t outliers = 0;  ///< points found to be no part of the surface
  /// dbar, in input units: the mean distance to the nearest points; by Method::Auto to 12, over a
  /// sample of some 4096 points where there are more.
  double spacing = 0;
  double noise = 0;                     ///< standard deviation of the noise as found or given, with
                                        ///< the strength in it, input units
  double max_move = 0;                  ///< the bound on the movement that was used, input units
  bool kept_normals = false;            ///< whether the first normals came from the cloud
  std::array<std::size_t, 4> labels{};  ///< of `points`, those per Feature, in its order
  /// Points of the result: all, or all but the outliers where these are removed.
  std::size_t kept = 0;
  std::vector<RoundReport> rounds;  ///< of Method::Yadav2018
  std::vector<StageTime> stages;
};

/// The clean cloud and what is known of it. Arrays are in the order of the input points; those that
/// OutlierAction::Remove takes out are in none of them.
struct DenoiseResult {
  PointCloud cloud;                  ///< moved points with their normals; attributes as they came
  std::vector<Feature> labels;       ///< what each point lies on
  std::vector<double> displacement;  ///< distance that each point moved, input units
  /// 1 for each outlier, 0 for any other point; all 0 by Method::Yadav2018.
  std::vector<std::uint8_t> outliers;
  Report report;
};

/// Takes the noise off a point cloud and keeps its edges and corners.
///
/// Method::Auto estimates the noise, fits the surface around every place at the largest scale that
/// the noise and the surface allow, lets smooth sheets end where they meet, and moves each point
/// onto them, never farther than a bound. Method::Yadav2018 runs rounds of three stages: filter the
/// normals, label each point surface, edge or corner, move it to agree with the normals around it.
///
/// Normals of the cloud that are zero or not finite are estimated (Method::Yadav2018 leaves such
/// points alone). Points that are not finite, or have nothing near them to be compared with, stay
/// as they are to the last bit and are labelled isolated, and so are outliers. A cloud of fewer
/// than 16 distinct points (4 by Method::Yadav2018) comes back unchanged. Whoever has no more use
/// for the cloud saves a copy of it with std::move().
///
/// Source: Yadav, Reitebuch, Skrodzki, Zimmermann, Polthier, Constraint-based point set denoising
/// using normal voting tensor and restricted quadratic error metrics, Computers & Graphics 74,
/// 2018.
///
/// @throws std::invalid_argument  naming the option and the value, for an option out of its range
/// @throws DataError  for NormalSource::Keep on a cloud without normals, neighbourhoods too large
///                    for any memory, or distances too
///                    large for a double (only by Method::Yadav2018)
/// @throws Cancelled  when execution.cancelled says so
[[nodiscard]] DenoiseResult denoise(PointCloud cloud, const DenoiseOptions& options = {},
                                    const Execution& execution = {});

}  // namespace deburr
