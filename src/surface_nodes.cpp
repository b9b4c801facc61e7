// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "box.hpp"
#include "columns.hpp"
#include "parallel.hpp"
#include "unit.hpp"
#include "z_order.hpp"

namespace deburr {
namespace {

/// Bits of the number of a cell along one axis, and how many of them a cube of cells takes.
constexpr unsigned cell_bits = 31;
constexpr unsigned cube_bits = 21;

/// Cells stand along a curve in space, so that nodes do too. That has not room for all of them:
/// clouds far apart have a cube of cells each.
struct Key {
  std::uint64_t cell;  ///< within its cube
  std::uint32_t cube;
  std::uint32_t side;  ///< where the normal points
  std::uint32_t index;

  friend bool operator<(const Key& a, const Key& b) {
    return std::tie(a.cube, a.cell, a.side, a.index) < std::tie(b.cube, b.cell, b.side, b.index);
  }
  [[nodiscard]] bool same_node(const Key& other) const {
    return cell == other.cell && cube == other.cube && side == other.side;
  }
};
static_assert(std::uint64_t{1} << cube_bits == z_order_cells);

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
  return nodes;
}

SurfaceNodes merge_into_cells(Points measured, Points places, Normals normals,
                              std::span<const double> weights, std::span<const double> trust,
                              double cell, std::uint32_t bins, const Execution& execution) {
  constexpr auto most_cells = static_cast<double>(std::uint64_t{1} << cell_bits);
  const Box box = bounding_box(places);
  const Vec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  // A whole number of cells: a cell size that differs in its last bits must not move the borders.
  const double count = std::clamp(std::ceil(longest / cell), 1.0, most_cells);
  const double per_length = longest > 0 ? count / longest : 0;
  const auto along = [&](double v, double low) {
    // The far end of the box belongs to the last cell.
    return static_cast<std::uint64_t>(std::min((v - low) * per_length, count - 1));
  };
  // Too short for a share of the progress; to tell the caller's for each loop would go back.
  const Execution quiet = without_progress(execution);
  auto keys = make_column<Key>(places.size(), quiet);
  parallel_for(keys.size(), quiet, [&](std::size_t i) {
    const Vec3& p = places[i];
    const std::uint64_t x = along(p.x, box.low.x);
    const std::uint64_t y = along(p.y, box.low.y);
    const std::uint64_t z = along(p.z, box.low.z);
    const std::uint64_t cube = z_order(x >> cube_bits, y >> cube_bits, z >> cube_bits);
    keys[i] = {z_order(x % z_order_cells, y % z_order_cells, z % z_order_cells),
               static_cast<std::uint32_t>(cube), normals.empty() ? 0 : part_of(normals[i], bins),
               static_cast<std::uint32_t>(i)};
  });
  parallel_sort(keys, quiet);
  std::vector<std::uint32_t> begins;
  pick(
      keys.size(), [&](std::size_t k) { return k == 0 || !keys[k].same_node(keys[k - 1]); },
      [&](std::size_t nodes) { begins.resize(nodes); },
      [&](std::size_t k, std::size_t node) { begins[node] = static_cast<std::uint32_t>(k); },
      quiet);

  SurfaceNodes nodes;
  resize_column(nodes.of, places.size(), quiet);
  for (auto* column : {&nodes.measured, &nodes.places, &nodes.normals}) {
    resize_column(*column, begins.size(), quiet);
  }
  for (auto* column : {&nodes.weights, &nodes.trust}) {
    resize_column(*column, begins.size(), quiet);
  }
  parallel_for(begins.size(), quiet, [&](std::size_t node) {
    Vec3 measured_sum;
    Vec3 place_sum;
    Vec3 normal_sum;
    double total = 0;
    double spread = 0;
    const std::size_t end = node + 1 < begins.size() ? begins[node + 1] : keys.size();
    for (std::size_t k = begins[node]; k < end; ++k) {
      const std::uint32_t i = keys[k].index;
      const double t = trust.empty() ? 1 : trust[i];
      const double w = t * (weights.empty() ? 1 : weights[i]);
      measured_sum += w * measured[i];
      place_sum += w * places[i];
      if (!normals.empty()) normal_sum += w * normals[i];
      total += w;
      spread += t * w;
      nodes.of[i] = static_cast<std::uint32_t>(node);
    }
    nodes.measured[node] = (1 / total) * measured_sum;
    nodes.places[node] = (1 / total) * place_sum;
    // Parts of one point on several sheets may lie at one place; rounding must not part them.
    const std::uint32_t first = keys[begins[node]].index;
    if (end - begins[node] == 1) nodes.places[node] = places[first];
    if (!is_zero(normal_sum)) nodes.normals[node] = unit(normal_sum);
    // As many points of full trust have a mean of the same variance.
    nodes.weights[node] = total * total / spread;
    nodes.trust[node] = spread / total;
  });
  return nodes;
}

}  // namespace deburr
