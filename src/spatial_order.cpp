// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial_order.hpp"

#include <algorithm>
#include <tuple>

#include "box.hpp"
#include "columns.hpp"
#include "parallel.hpp"
#include "radix_sort.hpp"
#include "z_order.hpp"

namespace deburr {
namespace {

struct Place {
  std::uint64_t code;
  std::uint32_t index;
};

}  // namespace

std::vector<std::uint32_t> spatial_order(Points points, const Execution& execution) {
  if (points.empty()) return {};
  const Box box = bounding_box(points);
  const Vec3 half = half_extent(box);
  const double largest = std::max({half.x, half.y, half.z});
  const auto cell = [&](double v, double from) {
    constexpr auto cells = static_cast<double>(z_order_cells - 1);
    const double share = largest > 0 ? (0.5 * v - 0.5 * from) / largest : 0;
    return static_cast<std::uint64_t>(cells * std::min(share, 1.0));
  };
  auto places = make_column<Place>(points.size(), execution);
  parallel_for(points.size(), execution, [&](std::size_t i) {
    const Vec3& p = points[i];
    places[i] = {z_order(cell(p.x, box.low.x), cell(p.y, box.low.y), cell(p.z, box.low.z)),
                 static_cast<std::uint32_t>(i)};
  });
  std::vector<Place> scratch;
  radix_sort<6>(
      std::span(places), scratch, [](const Place& p) { return p.code; }, execution);
  release(scratch);
  parallel_sort(places, execution, [points](const Place& a, const Place& b) {
    if (a.code != b.code) return a.code < b.code;
    const Vec3& p = points[a.index];
    const Vec3& q = points[b.index];
    return std::tie(p.x, p.y, p.z, a.index) < std::tie(q.x, q.y, q.z, b.index);
  });
  auto order = make_column<std::uint32_t>(points.size(), execution);
  parallel_for(order.size(), without_progress(execution),
               [&](std::size_t i) { order[i] = places[i].index; });
  return order;
}

}  // namespace deburr
