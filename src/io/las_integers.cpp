// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_integers.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/fields.hpp"

namespace deburr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_integer = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t lanes = las_lanes;
constexpr std::size_t block = 512;  ///< points that are surveyed at once

using Lanes = LasLanes;
using Bits = std::int64_t __attribute__((vector_size(lanes * sizeof(std::int64_t))));
using Integers = std::int32_t __attribute__((vector_size(lanes * sizeof(std::int32_t))));

bool all_set(const Bits& bits) { return (bits[0] & bits[1]) != 0; }

/// The nearest integer, ties to even, of a number below 2^51. Faster than a call of nearbyint().
template <typename T>
T nearest(const T& value) {
  constexpr double large = 0x1.8p52;
  return (value + large) - large;
}

/// A number where it is one of 32 bits; another where it is none, or a NaN.
Lanes within_integers(const Lanes& value) {
  const Lanes below = value < largest_integer ? value : Lanes{} + largest_integer;
  return below > -largest_integer ? below : Lanes{} - largest_integer;
}

Lanes load(const Vec3* points, std::size_t v) {
  Lanes value;
  std::memcpy(&value, reinterpret_cast<const char*>(points) + v * sizeof value, sizeof value);
  return value;
}

}  // namespace

std::optional<std::int32_t> las_integer(double value, double scale, double offset) {
  // As the lanes have it, which must not depend on the place of a point.
  const double inverse = 1 / scale;
  const double steps = value - offset;
  const double real = std::isfinite(inverse) ? steps * inverse : steps / scale;
  constexpr double safe = 0x1p51;
  const double integer = std::abs(real) < safe ? nearest(real) : real;
  const double held = std::clamp(integer, -largest_integer - 1, largest_integer);
  // The last integers may be missed by a rounding of the difference. A NaN is never equal.
  if (held != integer && held * scale + offset != value) return std::nullopt;
  return static_cast<std::int32_t>(held);
}

LasIntegers::LasIntegers(const LasGrid& grid)
    : grid_(grid), scale_(repeated(grid.scale)), offset_(repeated(grid.offset)) {
  // A product is found sooner than a quotient, and as near: it rounds to another integer only where
  // two of them are as good as each other. That of an infinite inverse is outside of the grid.
  for (std::size_t v = 0; v < 3; ++v) inverse_[v] = 1 / scale_[v];
  least_.fill(Lanes{} + infinity);
  most_.fill(Lanes{} - infinity);
}

LasIntegers::Group LasIntegers::repeated(const std::array<double, 3>& values) {
  Group all{};
  for (std::size_t j = 0; j < 3 * lanes; ++j) all.at(j / lanes)[j % lanes] = values[j % 3];
  return all;
}

bool LasIntegers::survey(Points points) {
  for (std::size_t i = 0; i < points.size(); i += block) {
    const Points some = points.subspan(i, std::min(block, points.size() - i));
    const std::size_t whole = some.size() / lanes * lanes;
    const std::size_t done = survey_groups(some.first(whole)) ? whole : 0;
    if (!survey_one_by_one(some.subspan(done))) return false;
  }
  return true;
}

/// False, and no account kept, if one of them needs a closer look.
bool LasIntegers::survey_groups(Points points) {
  Group least = least_;
  Group most = most_;
  Bits inside = ~Bits{};
  Bits exact = ~Bits{};
  const Vec3* from = points.data();
  const auto look = [&](std::size_t v) {
    const Lanes value = load(from, v);
    const Lanes quick = nearest<Lanes>((value - offset_[v]) * inverse_[v]);
    const Lanes integer = within_integers(quick);
    inside &= integer == quick;
    exact &= integer * scale_[v] + offset_[v] == value;
    least[v] = integer < least[v] ? integer : least[v];
    most[v] = integer > most[v] ? integer : most[v];
  };
  for (std::size_t i = 0; i < points.size(); i += lanes, from += lanes) {
    look(0);
    look(1);
    look(2);
  }
  if (!all_set(inside)) return false;
  is_exact_ = is_exact_ && all_set(exact);
  least_ = least;
  most_ = most;
  return true;
}

bool LasIntegers::survey_one_by_one(Points points) {
  for (const Vec3& point : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = point.*axes[k];
      const auto integer = las_integer(value, grid_.scale[k], grid_.offset[k]);
      if (!integer) return false;
      is_exact_ = is_exact_ && *integer * grid_.scale[k] + grid_.offset[k] == value;
      Lanes& low = least_.at(k / lanes);
      Lanes& high = most_.at(k / lanes);
      low[k % lanes] = std::min<double>(low[k % lanes], *integer);
      high[k % lanes] = std::max<double>(high[k % lanes], *integer);
    }
  }
  return true;
}

void LasIntegers::tell_box(std::array<double, 3>& low, std::array<double, 3>& high) const {
  for (std::size_t k = 0; k < 3; ++k) {
    double least = infinity;
    double most = -infinity;
    for (std::size_t j = k; j < 3 * lanes; j += 3) {
      least = std::min(least, least_.at(j / lanes)[j % lanes]);
      most = std::max(most, most_.at(j / lanes)[j % lanes]);
    }
    const double a = least * grid_.scale[k] + grid_.offset[k];
    const double b = most * grid_.scale[k] + grid_.offset[k];
    low[k] = std::min(a, b);
    high[k] = std::max(a, b);
  }
}

void LasIntegers::put(Points points, std::int32_t* to) const {
  const std::size_t whole = points.size() / lanes * lanes;
  const std::size_t done = put_groups(points.first(whole), to) ? whole : 0;
  for (std::size_t j = 3 * done; j < 3 * points.size(); ++j) {
    const std::size_t k = j % 3;
    to[j] = las_integer(points[j / 3].*axes[k], grid_.scale[k], grid_.offset[k]).value_or(0);
  }
}

/// False if one of them needs a closer look.
bool LasIntegers::put_groups(Points points, std::int32_t* to) const {
  const Group inverse = inverse_;
  const Group offset = offset_;
  Bits inside = ~Bits{};
  const Vec3* from = points.data();
  const auto put = [&](std::size_t v) {
    const Lanes quick = nearest<Lanes>((load(from, v) - offset[v]) * inverse[v]);
    const Lanes integer = within_integers(quick);
    inside &= integer == quick;
    const Integers held = __builtin_convertvector(integer, Integers);
    std::memcpy(to + v * lanes, &held, sizeof held);
  };
  for (std::size_t i = 0; i < points.size(); i += lanes, from += lanes, to += 3 * lanes) {
    put(0);
    put(1);
    put(2);
  }
  return all_set(inside);
}

}  // namespace deburr
