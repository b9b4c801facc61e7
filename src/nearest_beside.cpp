// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest_beside.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "box.hpp"
#include "lane_sort.hpp"
#include "lanes.hpp"

namespace deburr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Radius of a ball in distances to the last point that is found: a larger one serves more
/// searches, and each of them has more points to look through.
constexpr double ball = 1.75;
constexpr double centered = 0.9;  ///< share of what it is larger that places in it may be apart

/// Searches look at no more points than so many times those wanted: where points are that dense,
/// many are at one place.
constexpr std::size_t most_per_wanted = 12;
constexpr std::size_t most_at_least = 400;
constexpr std::size_t tries_apart = 32;  ///< searches until the next try to gather a ball then

/// The last bits of a key tell the place of the point.
constexpr unsigned slot_bits = 12;
constexpr std::uint64_t slot_mask = (std::uint64_t{1} << slot_bits) - 1;

/// Squared radius of a search without a ball, in the square of the search before.
constexpr double wider = 1.4;

/// More than are wanted are sorted, so that a wrong guess of the distance seldom matters.
constexpr double spare = 1.08;
constexpr int most_guesses = 5;

/// Distances are rounded by far less than this share of them...
constexpr double rounding = 1e-9;
/// ... unless their squares come near to what a double can hold.
constexpr double smallest_square = 1e-250;
constexpr double largest_square = 1e250;

DEBURR_LANES_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Squared distances as squared_norm() has them, and keys that sort like them.
DEBURR_MULTIVERSION
void measure(const double* x, const double* y, const double* z, std::size_t size, const Vec3& place,
             double* squares, double* keys) {
  const Lanes3 at = all_lanes(place);
  LaneBits slot{0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t k = 0; k < size; k += lane_count) {
    const Lanes3 d = Lanes3{load(x + k), load(y + k), load(z + k)} - at;
    const Lanes square = dot(d, d);
    std::memcpy(squares + k, &square, sizeof square);
    LaneBits key;
    std::memcpy(&key, &square, sizeof square);
    key = (key & ~static_cast<std::int64_t>(slot_mask)) | slot;
    std::memcpy(keys + k, &key, sizeof key);
    slot += static_cast<std::int64_t>(lane_count);
  }
}

/// How many of the values are no larger than the limit. There is room for whole lanes.
DEBURR_MULTIVERSION
std::size_t count_up_to(const double* values, std::size_t size, double limit) {
  LaneBits near{};
  for (std::size_t k = 0; k < size; k += lane_count) near -= load(values + k) <= limit;
  std::int64_t sum = 0;
  for (std::size_t l = 0; l < lane_count; ++l) sum += near[l];
  return static_cast<std::size_t>(sum);
}

std::uint64_t bits(double key) { return std::bit_cast<std::uint64_t>(key); }

/// Whether two keys do not tell which square is smaller.
bool alike(double a, double b) { return (bits(a) ^ bits(b)) <= slot_mask; }

}  // namespace

void NearestBeside::find(const KdTree& tree, const Vec3& at, std::size_t count,
                         std::vector<Found>& found, std::uint32_t excluded) {
  if (count_ != count) {
    count_ = count;
    square_ = 0;
    radius_ = -1;
  }
  if (!(square_ > 0) || !find_in_ball(tree, at, count, found, excluded)) {
    const double limit = square_ > 0 ? wider * square_ : infinity;
    tree.nearest_to(at, count, limit, found, excluded);
    if (found.size() < count && limit < infinity) {
      tree.nearest_to(at, count, infinity, found, excluded);
    }
  }
  square_ = found.size() == count && count > 0 ? found.back().squared_distance : 0;
  if (!(square_ > smallest_square && square_ < largest_square)) square_ = 0;
}

/// False if that needs points beyond the ball.
bool NearestBeside::find_in_ball(const KdTree& tree, const Vec3& at, std::size_t count,
                                 std::vector<Found>& found, std::uint32_t excluded) {
  // One more may be the one that is left out.
  const std::size_t wanted = excluded == KdTree::no_point ? count : count + 1;
  const double safe = safe_square(at);
  if (!(safe > square_) || !select(at, wanted, safe)) {
    if (!gather(tree, at, wanted) || !select(at, wanted, safe_square(at))) return false;
  }
  sort(wanted, found);
  if (wanted > count) {
    const auto out = std::ranges::find(found, excluded, &Found::index);
    found.erase(out != found.end() ? out : out - 1);
  }
  return true;
}

/// Puts the center amid the places that come next, as many as the ball can serve.
void NearestBeside::center_ball(const Vec3& at) {
  center_ = at;
  const auto here = std::ranges::find(expected_, at);
  if (here == expected_.end()) return;
  expected_ = expected_.subspan(static_cast<std::size_t>(here - expected_.begin()));
  const double reach = (ball - 1) * centered * std::sqrt(square_);
  Box box;
  for (const Vec3& place : expected_) {
    box.add(place);
    if (!(squared_norm(half_extent(box)) <= reach * reach)) break;
    center_ = middle(box);
  }
}

/// Fills the columns with the points around a place; false where they are too many.
bool NearestBeside::gather(const KdTree& tree, const Vec3& at, std::size_t count) {
  if (patience_ > 0) {
    --patience_;
    return false;
  }
  radius_ = ball * std::sqrt(square_);
  center_ball(at);
  tree.runs_within(center_, radius_ * radius_, runs_);
  size_ = 0;
  for (const KdTree::Run& run : runs_) size_ += run.end - run.begin;
  if (size_ >
      std::min(std::max(most_per_wanted * count, most_at_least), slot_mask + 1 - lane_count)) {
    radius_ = -1;
    patience_ = tries_apart;
    return false;
  }
  const std::size_t room = (size_ + lane_count - 1) / lane_count * lane_count;
  for (auto* const column : {&x_, &y_, &z_, &squares_, &keys_}) {
    if (column->size() < room) column->resize(2 * room);
  }
  if (near_.size() < room + lane_sort_sizes.back()) near_.resize(2 * room + lane_sort_sizes.back());
  if (index_.size() < room) index_.resize(2 * room);
  const Points points = tree.along_leaves();
  const double square = radius_ * radius_;
  size_ = 0;
  for (const KdTree::Run& run : runs_) {
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const Vec3& p = points[i];
      x_[size_] = p.x;  // written over by the next one if too far
      y_[size_] = p.y;
      z_[size_] = p.z;
      index_[size_] = tree.order()[i];
      size_ += squared_norm(p - center_) <= square ? 1U : 0U;
    }
  }
  for (std::size_t k = size_; k % lane_count != 0; ++k) x_[k] = infinity;
  return true;
}

/// Every point nearer than this is in the columns: it cannot be farther from the center than the
/// radius. Negative if none is known to be.
double NearestBeside::safe_square(const Vec3& at) const {
  const double off = norm(at - center_);
  const double safe = radius_ - off - rounding * (radius_ + off);
  return safe > 0 ? safe * safe : -1;
}

/// Copies the keys of the `count` nearest, or of some more, to near_; false if some of those may be
/// beyond the ball.
bool NearestBeside::select(const Vec3& at, std::size_t count, double safe) {
  measure(x_.data(), y_.data(), z_.data(), size_, at, squares_.data(), keys_.data());
  const auto wanted = static_cast<double>(count);
  const auto* const fits = std::ranges::find_if(
      lane_sort_sizes, [&](std::size_t s) { return static_cast<double>(s) >= spare * wanted; });
  const std::size_t most = fits != lane_sort_sizes.end() ? *fits : 2 * count;
  const double aim = 0.5 * (wanted + static_cast<double>(most));
  // Squares of distances on a surface grow with the number of points.
  double limit = std::min(square_ * aim / wanted, safe);
  for (int guess = 0; guess < most_guesses; ++guess) {
    const std::size_t here = count_up_to(squares_.data(), size_, limit);
    if (here >= count && here <= most) break;
    if (here < count && !(limit < safe)) return false;
    const double share = aim / static_cast<double>(std::max<std::size_t>(here, 1));
    limit = std::min(limit * std::clamp(share, 0.25, 4.0), safe);
    if (guess + 2 == most_guesses) limit = safe;
  }
  near_count_ = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    near_[near_count_] = keys_[k];  // written over by the next one if too far
    near_count_ += squares_[k] <= limit ? 1U : 0U;
  }
  return near_count_ >= count;
}

/// Writes the `count` nearest of near_ in order.
void NearestBeside::sort(std::size_t count, std::vector<Found>& found) {
  const auto near = near_.begin();
  const auto* const fits = std::ranges::lower_bound(lane_sort_sizes, near_count_);
  if (fits != lane_sort_sizes.end()) {
    std::fill(near + static_cast<std::ptrdiff_t>(near_count_),
              near + static_cast<std::ptrdiff_t>(*fits), infinity);
    sort_in_lanes(near_.data(), *fits);
  } else {
    std::sort(near, near + static_cast<std::ptrdiff_t>(near_count_));
  }
  // Squares that differ in their last bits alone, or not at all, are not in order yet; those like
  // the last that is wanted may have to take its place.
  std::size_t all = count;
  while (all < near_count_ && alike(near_[all], near_[count - 1])) ++all;
  found.resize(all);
  for (std::size_t k = 0; k < all; ++k) {
    const std::size_t slot = bits(near_[k]) & slot_mask;
    const Found f{squares_[slot], index_[slot]};
    std::size_t to = k;
    if (k > 0 && alike(near_[k], near_[k - 1])) {
      for (; to > 0 && f < found[to - 1]; --to) found[to] = found[to - 1];
    }
    found[to] = f;
  }
  found.resize(count);
}

}  // namespace deburr
