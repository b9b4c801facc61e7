// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial_order.hpp"

#include <algorithm>
#include <tuple>

#include "box.hpp"
#include "parallel.hpp"
#include "z_order.hpp"

namespace deburr {
namespace {

struct Place {
  std::uint64_t code;
  Vec3 at;
  std::uint32_t index;

  friend bool operator<(const Place& a, const Place& b) {
    return std::tie(a.code, a.at.x, a.at.y, a.at.z, a.index) <
           std::tie(b.code, b.at.x, b.at.y, b.at.z, b.index);
  }
};

}  // namespace

std::vector<std::uint32_t> spatial_order(Points points, const Execution& execution) {
  if (points.empty()) return {};
  const Box box = bounding_box(points);
  const Vec3 half = half_extent(box);
  const double largest = std::max({half.x, half.y, half.z});
  const auto cell = [&](double v, double from) {
    constexpr double cells = (1 << 21) - 1;
    const double share = largest > 0 ? (0.5 * v - 0.5 * from) / largest : 0;
    return static_cast<std::uint64_t>(cells * std::min(share, 1.0));
  };
  std::vector<Place> places(points.size());
  parallel_for(points.size(), execution, [&](std::size_t i) {
    const Vec3& p = points[i];
    const std::uint64_t code =
        z_order(cell(p.x, box.low.x), cell(p.y, box.low.y), cell(p.z, box.low.z));
    places[i] = {code, p, static_cast<std::uint32_t>(i)};
  });
  parallel_sort(places, execution);
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = places[i].index;
  return order;
}

}  // namespace deburr
