// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "scale_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "nearest_beside.hpp"

namespace deburr {
namespace {

constexpr std::size_t pooled_nodes = 33;  ///< of those surveyed
constexpr double same_side = 0.7;         ///< cosine to the normal of a node whose curve counts

/// A residual counts no more than so many times the noise: nodes at features must not decide.
constexpr float most_residual = 4;
constexpr float most_residual_of_cloud = 3;
constexpr float most_curvature = 8;

/// Degrees of freedom that the residuals of small scales are averaged over for the local noise.
constexpr double reference_freedom = 500;
constexpr double least_noise = 0.6;  ///< local noise, as shares of that of the cloud
constexpr double most_noise = 1.3;

/// Misfits of the surroundings differ by so much from that of the cloud by chance.
constexpr double chance = 0.3;
/// What the residuals exceed the noise by without any misfit: of fits over points, and over nodes
/// that are not all equally pure.
constexpr double free_excess = 0.01;
constexpr double free_coarse_excess = 0.4;
/// Squared error at the node itself over the mean squared misfit, after blending.
constexpr double misfit_weight = 0.8;

/// Sums of curves.
struct Pool {
  std::array<double, sheet_scales> residual{}, freedom{}, variance{}, curvature{}, count{};

  void add(const ScaleCurve& curve, float most) {
    for (std::size_t s = 0; s < sheet_scales; ++s) {
      const double freedom_here = curve.freedom[s];
      if (!(freedom_here > 0)) continue;
      residual[s] += freedom_here * std::min(curve.residual[s], most);
      freedom[s] += freedom_here;
      variance[s] += curve.variance[s];
      curvature[s] += std::min(curve.curvature[s], most_curvature);
      count[s] += 1;
    }
  }
  [[nodiscard]] double excess(std::size_t s, double reference) const {
    return residual[s] / freedom[s] / reference - 1;
  }
  /// The residuals of the smallest scales.
  [[nodiscard]] double reference(double enough) const {
    double sum = 0;
    double total = 0;
    for (std::size_t s = 0; s < sheet_scales && total < enough; ++s) {
      sum += residual[s];
      total += freedom[s];
    }
    return total > 0 && sum > 0 ? sum / total : 1;
  }
};

/// The excess of the residuals of the whole cloud; 0 where too few nodes tell.
std::array<double, sheet_scales> excess_of_cloud(std::span<const ScaleCurve> curves) {
  Pool pool;
  for (const ScaleCurve& curve : curves) pool.add(curve, most_residual_of_cloud);
  double sum = 0;
  double total = 0;
  for (std::size_t s = 0; s < level_scales / 2; ++s) {
    sum += pool.residual[s];
    total += pool.freedom[s];
  }
  const double reference = total > 0 && sum > 0 ? sum / total : 1;
  std::array<double, sheet_scales> excess{};
  for (std::size_t s = 0; s < sheet_scales; ++s) {
    if (pool.freedom[s] > 0.3 * pool.freedom[0] && pool.freedom[s] > 0) {
      excess[s] = pool.excess(s, reference);
    }
  }
  return excess;
}

}  // namespace

ScaleChooser::ScaleChooser(const ScaleSurvey& survey, double noise, const AutomaticParts& parts,
                           const Execution& execution)
    : survey_(survey),
      noise_(noise),
      parts_(parts),
      tree_(survey.places, execution),
      of_cloud_(excess_of_cloud(survey.curves)) {}

std::vector<ScaleChoice> ScaleChooser::choose(Points places, Normals normals) const {
  const std::size_t pooled = parts_.pool ? pooled_nodes : 1;
  const double by_chance = parts_.pool && parts_.cloud_misfit ? chance : 0;
  std::vector<ScaleChoice> choices(places.size());
  NearestBeside nearest;
  nearest.expect(places);
  std::vector<Found> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    nearest.find(tree_, places[i], pooled, found);
    Pool pool;
    for (const Found& f : found) {
      if (dot(survey_.normals[f.index], normals[i]) >= same_side) {
        pool.add(survey_.curves[f.index], most_residual);
      }
    }
    ScaleChoice& choice = choices[i];
    const double reference = pool.reference(reference_freedom);
    choice.noise = noise_;
    if (parts_.local_sigma) {
      choice.noise *= std::clamp(std::sqrt(reference), least_noise, most_noise);
    }
    choice.curvature.fill(-1);
    const double most = *std::ranges::max_element(pool.count);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < sheet_scales; ++s) {
      if (pool.count[s] > 0) {
        choice.curvature[s] = static_cast<float>(pool.curvature[s] / pool.count[s] / reference);
      }
      if (pool.count[s] < 0.5 * most || pool.count[s] == 0) continue;
      const double difference = pool.excess(s, reference) - of_cloud_[s];
      const double significant =
          std::max(difference - by_chance, 0.0) + std::min(difference + by_chance, 0.0);
      const std::size_t level = s / level_scales;
      const double free = level > 0 ? free_coarse_excess : free_excess;
      const double misfit =
          std::max(0.0, of_cloud_[s] + significant - free) / survey_.merged[level];
      const double risk = misfit_weight * misfit + pool.variance[s] / pool.count[s];
      if (risk < least) {
        least = risk;
        choice.scale = s;
      }
    }
  }
  return choices;
}

}  // namespace deburr
