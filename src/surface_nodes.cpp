// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "box.hpp"
#include "parallel.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Cells along one side of the box: more would not fit into the numbers that follow.
constexpr double most_cells = 0x1p31;

struct Key {
  std::uint32_t x, y, z;  ///< of the cell
  std::uint32_t side;     ///< where the normal points
  std::uint32_t index;

  friend bool operator<(const Key& a, const Key& b) {
    return std::tie(a.x, a.y, a.z, a.side, a.index) < std::tie(b.x, b.y, b.z, b.side, b.index);
  }
  [[nodiscard]] bool same_node(const Key& other) const {
    return x == other.x && y == other.y && z == other.z && side == other.side;
  }
};

/// The part of the sphere that a normal points to: one of six sides, cut into bins x bins parts.
std::uint32_t part_of(const Vec3& n, std::uint32_t bins) {
  const double x = std::abs(n.x);
  const double y = std::abs(n.y);
  const double z = std::abs(n.z);
  const auto within = [&](double a, double b, double major) {
    const auto bin = [&](double v) {
      const double at = major > 0 ? (v / major + 1) * 0.5 * bins : 0;
      return std::min(bins - 1, static_cast<std::uint32_t>(at));
    };
    return 6 * (bin(a) * bins + bin(b));
  };
  if (x >= y && x >= z) return (n.x < 0 ? 1U : 0U) + within(n.y, n.z, x);
  if (y >= z) return (n.y < 0 ? 3U : 2U) + within(n.x, n.z, y);
  return (n.z < 0 ? 5U : 4U) + within(n.x, n.y, z);
}

}  // namespace

SurfaceNodes nodes_of_points(std::vector<Vec3> measured, std::vector<Vec3> places,
                             std::vector<Vec3> normals, std::vector<double> trust) {
  SurfaceNodes nodes;
  nodes.measured = std::move(measured);
  nodes.places = std::move(places);
  nodes.normals = std::move(normals);
  nodes.trust = std::move(trust);
  nodes.trust.resize(nodes.size(), 1.0);
  nodes.weights.assign(nodes.size(), 1.0);
  nodes.of.resize(nodes.size());
  std::iota(nodes.of.begin(), nodes.of.end(), 0U);
  return nodes;
}

SurfaceNodes merge_into_cells(Points measured, Points places, Normals normals,
                              std::span<const double> weights, std::span<const double> trust,
                              double cell, std::uint32_t bins, const Execution& execution) {
  const Box box = bounding_box(places);
  const Vec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  // A whole number of cells: a cell size that differs in its last bits must not move the borders.
  const double count = std::clamp(std::ceil(longest / cell), 1.0, most_cells);
  const double per_length = longest > 0 ? count / longest : 0;
  const auto along = [&](double v, double low) {
    // The far end of the box belongs to the last cell.
    return static_cast<std::uint32_t>(std::min((v - low) * per_length, count - 1));
  };
  std::vector<Key> keys(places.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    const Vec3& p = places[i];
    keys[i] = {along(p.x, box.low.x), along(p.y, box.low.y), along(p.z, box.low.z),
               normals.empty() ? 0 : part_of(normals[i], bins), i};
  }
  parallel_sort(keys, execution);

  std::size_t all = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (k == 0 || !keys[k].same_node(keys[k - 1])) ++all;
  }
  SurfaceNodes nodes;
  nodes.of.resize(places.size());
  for (auto* column : {&nodes.measured, &nodes.places, &nodes.normals}) column->reserve(all);
  for (auto* column : {&nodes.weights, &nodes.trust}) column->reserve(all);
  for (std::size_t from = 0; from < keys.size();) {
    Vec3 measured_sum;
    Vec3 place_sum;
    Vec3 normal_sum;
    double total = 0;
    double spread = 0;
    std::size_t to = from;
    for (; to < keys.size() && keys[to].same_node(keys[from]); ++to) {
      const std::uint32_t i = keys[to].index;
      const double t = trust.empty() ? 1 : trust[i];
      const double w = t * (weights.empty() ? 1 : weights[i]);
      measured_sum += w * measured[i];
      place_sum += w * places[i];
      if (!normals.empty()) normal_sum += w * normals[i];
      total += w;
      spread += t * w;
      nodes.of[i] = static_cast<std::uint32_t>(nodes.size());
    }
    nodes.measured.push_back((1 / total) * measured_sum);
    nodes.places.push_back((1 / total) * place_sum);
    nodes.normals.push_back(is_zero(normal_sum) ? Vec3{} : unit(normal_sum));
    // As many points of full trust have a mean of the same variance.
    nodes.weights.push_back(total * total / spread);
    nodes.trust.push_back(spread / total);
    from = to;
  }
  return nodes;
}

}  // namespace deburr
