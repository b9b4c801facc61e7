// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "scale_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "lanes.hpp"
#include "nearest_beside.hpp"

namespace deburr {
namespace {

constexpr std::size_t pooled_nodes = 33;  ///< of those surveyed
constexpr double same_side = 0.7;         ///< cosine to the normal of a node whose curve counts

/// A residual counts no more than so many times the noise: nodes at features must not decide.
constexpr double most_residual = 4;
constexpr double most_residual_of_cloud = 3;
constexpr double most_curvature = 8;

/// Degrees of freedom that the residuals of small scales are averaged over for the local noise.
constexpr double reference_freedom = 500;
constexpr double least_noise = 0.6;  ///< local noise, as shares of that of the cloud
constexpr double most_noise = 1.3;

/// Misfits of the surroundings differ by so much from that of the cloud by chance.
constexpr double chance = 0.3;
/// What the residuals exceed the noise by without any misfit. Nodes of coarse levels are not all
/// equally pure: their smallest fits, in which there is hardly a misfit yet, tell by how much.
constexpr double free_excess = 0.01;
constexpr double most_free_coarse_excess = 0.4;
constexpr double per_excess_of_smallest = 2;
/// Squared error at the node itself over the mean squared misfit, after blending.
constexpr double misfit_weight = 0.8;

using PerScale = std::array<double, sheet_scales>;

/// Sums of curves.
struct Pool {
  PerScale residual{}, freedom{}, variance{}, curvature{}, count{};

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

using FloatLanes = float __attribute__((vector_size(lane_count * sizeof(float))));

DEBURR_LANES_INLINE Lanes load(const float* from) {
  FloatLanes v;
  std::memcpy(&v, from, sizeof v);
  return __builtin_convertvector(v, Lanes);
}
DEBURR_LANES_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
DEBURR_LANES_INLINE void store(const Lanes& v, double* to) { std::memcpy(to, &v, sizeof v); }

/// Adds curves to a pool; all of a curve is 0 where no fit is.
DEBURR_MULTIVERSION
void add_curves(std::span<const ScaleCurve* const> curves, double most, Pool& to) {
  static_assert(sheet_scales % lane_count == 0);
  for (std::size_t s = 0; s < sheet_scales; s += lane_count) {
    Lanes residual = load(&to.residual[s]);
    Lanes freedom = load(&to.freedom[s]);
    Lanes variance = load(&to.variance[s]);
    Lanes curvature = load(&to.curvature[s]);
    Lanes count = load(&to.count[s]);
    for (const ScaleCurve* const curve : curves) {
      const Lanes here = load(&curve->freedom[s]);
      const Lanes squares = load(&curve->residual[s]);
      const Lanes bend = load(&curve->curvature[s]);
      residual += here * (squares > most ? all_lanes(most) : squares);
      freedom += here;
      variance += load(&curve->variance[s]);
      curvature += bend > most_curvature ? all_lanes(most_curvature) : bend;
      count += here > 0.0 ? all_lanes(1) : Lanes{};
    }
    store(residual, &to.residual[s]);
    store(freedom, &to.freedom[s]);
    store(variance, &to.variance[s]);
    store(curvature, &to.curvature[s]);
    store(count, &to.count[s]);
  }
}

/// What a pool tells of each scale; what it tells of one without a fit is no number.
struct PooledCurve {
  PerScale curvature, excess, variance;
};
DEBURR_MULTIVERSION
void divide(const Pool& pool, double reference, PooledCurve& to) {
  const double per_reference = 1 / reference;
  for (std::size_t s = 0; s < sheet_scales; s += lane_count) {
    const Lanes per_curve = 1.0 / load(&pool.count[s]);
    store(load(&pool.curvature[s]) * per_curve * per_reference, &to.curvature[s]);
    store(load(&pool.residual[s]) / load(&pool.freedom[s]) * per_reference - 1.0, &to.excess[s]);
    store(load(&pool.variance[s]) * per_curve, &to.variance[s]);
  }
}

/// The excess of the residuals of the whole cloud; 0 where too few nodes tell.
PerScale excess_of_cloud(std::span<const ScaleCurve> curves) {
  std::vector<const ScaleCurve*> all;
  all.reserve(curves.size());
  for (const ScaleCurve& curve : curves) all.push_back(&curve);
  Pool pool;
  add_curves(all, most_residual_of_cloud, pool);
  double sum = 0;
  double total = 0;
  for (std::size_t s = 0; s < level_scales / 2; ++s) {
    sum += pool.residual[s];
    total += pool.freedom[s];
  }
  const double reference = total > 0 && sum > 0 ? sum / total : 1;
  PerScale excess{};
  for (std::size_t s = 0; s < sheet_scales; ++s) {
    if (pool.freedom[s] > 0.3 * pool.freedom[0] && pool.freedom[s] > 0) {
      excess[s] = pool.residual[s] / pool.freedom[s] / reference - 1;
    }
  }
  return excess;
}

/// What residuals over coarse nodes exceed the noise by without any misfit.
double coarse_excess(const PerScale& of_cloud) {
  const double smallest = of_cloud[level_scales];
  const double free = per_excess_of_smallest * std::max(smallest, 0.0);
  // Too few nodes tell of it where it is 0.
  return smallest != 0 ? std::min(free, most_free_coarse_excess) : most_free_coarse_excess;
}

}  // namespace

ScaleChooser::ScaleChooser(const ScaleSurvey& survey, double noise, const AutomaticParts& parts,
                           const Execution& execution)
    : survey_(survey),
      noise_(noise),
      parts_(parts),
      tree_(survey.places, execution),
      of_cloud_(excess_of_cloud(survey.curves)),
      free_coarse_excess_(coarse_excess(of_cloud_)) {}

std::vector<ScaleChoice> ScaleChooser::choose(Points places, Normals normals) const {
  const std::size_t pooled = parts_.pool ? pooled_nodes : 1;
  const double by_chance = parts_.pool && parts_.cloud_misfit ? chance : 0;
  std::vector<ScaleChoice> choices(places.size());
  NearestBeside nearest;
  nearest.expect(places);
  std::vector<Found> found;
  std::vector<const ScaleCurve*> curves;
  for (std::size_t i = 0; i < places.size(); ++i) {
    nearest.find(tree_, places[i], pooled, found);
    curves.clear();
    for (const Found& f : found) {
      if (dot(survey_.normals[f.index], normals[i]) >= same_side) {
        curves.push_back(&survey_.curves[f.index]);
      }
    }
    Pool pool;
    add_curves(curves, most_residual, pool);
    ScaleChoice& choice = choices[i];
    const double reference = pool.reference(reference_freedom);
    choice.noise = noise_;
    if (parts_.local_sigma) {
      choice.noise *= std::clamp(std::sqrt(reference), least_noise, most_noise);
    }
    PooledCurve curve;
    divide(pool, reference, curve);
    choice.curvature.fill(-1);
    const double most = *std::ranges::max_element(pool.count);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < sheet_scales; ++s) {
      if (pool.count[s] > 0) choice.curvature[s] = static_cast<float>(curve.curvature[s]);
      if (pool.count[s] < 0.5 * most || pool.count[s] == 0) continue;
      const double difference = curve.excess[s] - of_cloud_[s];
      const double significant =
          std::max(difference - by_chance, 0.0) + std::min(difference + by_chance, 0.0);
      const std::size_t level = s / level_scales;
      const double free = level > 0 ? free_coarse_excess_ : free_excess;
      const double misfit =
          std::max(0.0, of_cloud_[s] + significant - free) / survey_.merged[level];
      const double risk = misfit_weight * misfit + curve.variance[s];
      if (risk < least) {
        least = risk;
        choice.scale = s;
      }
    }
  }
  return choices;
}

}  // namespace deburr
