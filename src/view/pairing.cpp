// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/pairing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "box.hpp"
#include "view/fields.hpp"
#include "view/left_out.hpp"

namespace deburr::view {
namespace {

/// Clouds whose points lie farther apart than this share of the diagonal, on average, are not the
/// same points in the same order.
constexpr double same_points = 0.1;

void check_origin(const Request& request) {
  if (request.origin.empty()) return;
  if (!request.after || request.origin.size() != request.after->cloud->size()) {
    throw std::invalid_argument("origin must have one index per point of the cloud after");
  }
  for (const std::uint32_t i : request.origin) {
    if (i >= request.before.cloud->size()) {
      throw std::invalid_argument(fmt::format("origin must hold indices of points, got {}", i));
    }
  }
}

std::vector<std::uint32_t> find_origin(const Request& request) {
  if (!request.origin.empty()) return {request.origin.begin(), request.origin.end()};
  if (!request.after) return {};
  if (request.after->cloud->size() != request.before.cloud->size()) {
    return match_without_removed(*request.before.cloud, *request.after->cloud);
  }
  std::vector<std::uint32_t> same(request.before.cloud->size());
  std::iota(same.begin(), same.end(), 0U);
  return same;
}

/// Whether the points of a pair lie near each other, on average.
bool plausible(Points before, Points after) {
  Box box;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!is_finite(before[i]) || !is_finite(after[i])) continue;
    box.add(before[i]);
    sum += norm(after[i] - before[i]);
    ++count;
  }
  if (count == 0) return true;
  return sum / static_cast<double>(count) <= same_points * 2 * norm(half_extent(box));
}

void measure(const PointCloud& before, const PointCloud& after, Pairing& pairing) {
  pairing.is_signed = !after.normals.empty();
  pairing.displacement.reserve(after.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vec3 moved = after.points[i] - before.points[pairing.origin[i]];
    double distance = norm(moved);
    if (pairing.is_signed) {
      const double length = norm(after.normals[i]);
      if (length > 0) distance = dot(moved, after.normals[i]) / length;
    }
    pairing.displacement.push_back(is_finite(moved) ? distance
                                                    : std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

Pairing pair_points(const Request& request) {
  check_origin(request);
  Pairing pairing;
  const ShownCloud& shown = request.after ? *request.after : request.before;
  const PointCloud& last = *shown.cloud;
  pairing.origin = find_origin(request);
  pairing.paired = !pairing.origin.empty();
  if (pairing.paired && request.origin.empty() && last.size() == request.before.cloud->size() &&
      !plausible(request.before.cloud->points, last.points)) {
    pairing.warnings.push_back(
        fmt::format("{} and {} have as many points, but these are not the same points in the same "
                    "order, so no movement is shown",
                    request.before.name, shown.name));
    pairing.paired = false;
    pairing.origin.clear();
  }
  if (pairing.paired) {
    measure(*request.before.cloud, last, pairing);
  } else if (const Attribute* field = find_numbers(last, "deburr_displacement")) {
    for (std::size_t i = 0; i < last.size(); ++i) {
      pairing.displacement.push_back(number_at(*field, i));
    }
  }
  return pairing;
}

}  // namespace deburr::view
