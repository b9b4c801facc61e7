// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_nodes.hpp"

#include <algorithm>
#include <cstdlib>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "box.hpp"
#include "parallel.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Cells along one side of the box: more would not fit into the numbers that follow.
constexpr double most_cells = 0x1p31;

struct Key {
  std::uint32_t x, y, z;  ///< of the cell
  std::uint32_t side;     ///< of six: the largest component of the normal and its sign
  std::uint32_t index;

  friend bool operator<(const Key& a, const Key& b) {
    return std::tie(a.x, a.y, a.z, a.side, a.index) < std::tie(b.x, b.y, b.z, b.side, b.index);
  }
  [[nodiscard]] bool same_node(const Key& other) const {
    return x == other.x && y == other.y && z == other.z && side == other.side;
  }
};

std::uint32_t side_of(const Vec3& n, int K) {
  const double x = std::abs(n.x);
  const double y = std::abs(n.y);
  const double z = std::abs(n.z);
  const auto bin = [&](double a, double b, double major) {
    const auto q = [&](double v) { return std::min<std::uint32_t>(K - 1, static_cast<std::uint32_t>((v / major + 1) * 0.5 * K)); };
    return 6 * (q(a) * K + q(b));
  };
  if (x >= y && x >= z) return (n.x < 0 ? 1 : 0) + bin(n.y, n.z, std::max(x, 1e-300));
  if (y >= z) return (n.y < 0 ? 3 : 2) + bin(n.x, n.z, y);
  return (n.z < 0 ? 5 : 4) + bin(n.x, n.y, z);
}

}  // namespace

SurfaceNodes nodes_of_points(Points measured, Points places, Normals normals,
                             std::span<const double> trust) {
  SurfaceNodes nodes;
  nodes.measured.assign(measured.begin(), measured.end());
  nodes.places.assign(places.begin(), places.end());
  nodes.normals.assign(normals.begin(), normals.end());
  nodes.weights.assign(measured.size(), 1.0);
  nodes.trust.assign(trust.begin(), trust.end());
  nodes.trust.resize(measured.size(), 1.0);
  nodes.of.resize(measured.size());
  std::iota(nodes.of.begin(), nodes.of.end(), 0U);
  return nodes;
}

SurfaceNodes merge_into_cells(Points measured, Points places, Normals normals,
                              std::span<const double> weights, std::span<const double> trust,
                              double cell, const Execution& execution) {
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
  static const int K0 = getenv("K0") ? atoi(getenv("K0")) : 1;static const int K1 = getenv("K1") ? atoi(getenv("K1")) : 3;
  std::vector<Key> keys(places.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    const Vec3& p = places[i];
    keys[i] = {along(p.x, box.low.x), along(p.y, box.low.y), along(p.z, box.low.z),
               normals.empty() ? 0 : side_of(normals[i], weights.empty() ? K0 : K1), i};
  }
  parallel_sort(keys, execution);

  SurfaceNodes nodes;
  nodes.of.resize(places.size());
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
