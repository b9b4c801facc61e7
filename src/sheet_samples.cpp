// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lane_sums.hpp"
#include "lanes.hpp"

namespace deburr {
namespace {

DEBURR_LANES_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
DEBURR_LANES_INLINE void store(const Lanes& v, double* to) { std::memcpy(to, &v, sizeof v); }

DEBURR_LANES_INLINE Lanes root(Lanes v) {
  for (std::size_t l = 0; l < lane_count; ++l) v[l] = std::sqrt(v[l]);
  return v;
}

/// As in belonging.hpp, in lanes.
DEBURR_LANES_INLINE Lanes level_top(const Lanes& e) {
  const Lanes t = 1.0 - e * e * (1.0 / 9);
  const Lanes t2 = t * t;
  const Lanes t4 = t2 * t2;
  return e < 3.0 ? t4 * t4 : Lanes{};
}

/// Coordinates of places and normals in the frame instead, and heights of the measured positions.
struct Turned {
  double *x, *y, *z, *u, *v, *w, *measured_x;
  const double *measured_y, *measured_z;
};
DEBURR_MULTIVERSION
void turn(const Turned& s, std::size_t begin, std::size_t end, const Frame& frame) {
  const Lanes3 origin = all_lanes(frame.origin);
  const Lanes3 u = all_lanes(frame.u);
  const Lanes3 v = all_lanes(frame.v);
  const Lanes3 w = all_lanes(frame.w);
  for (std::size_t i = begin; i < end; i += lane_count) {
    const Lanes3 place = Lanes3{load(s.x + i), load(s.y + i), load(s.z + i)} - origin;
    store(dot(place, u), s.x + i);
    store(dot(place, v), s.y + i);
    store(dot(place, w), s.z + i);
    const Lanes3 normal{load(s.u + i), load(s.v + i), load(s.w + i)};
    store(dot(normal, u), s.u + i);
    store(dot(normal, v), s.v + i);
    store(dot(normal, w), s.w + i);
    const Lanes3 measured{load(s.measured_x + i), load(s.measured_y + i), load(s.measured_z + i)};
    store(dot(measured - origin, w), s.measured_x + i);
  }
}

struct Neighbors {
  const double *x, *y, *place_height, *u, *v, *w, *trust, *square;
};

/// The shares of the first `count` samples, 0 for those after them up to whole lanes.
/// @param curved  whether the surface is
template <bool curved>
DEBURR_LANES_INLINE void share_out(const Neighbors& s, std::size_t count,
                                   const SheetSamples::Membership& member, double* shares) {
  const auto& c = member.surface.c;
  const double per_area = 0.9 / member.area;
  const double per_reach = 1 / member.reach;
  const double per_turn = 2 / (member.normal_reach * member.normal_reach);
  const double cosine_of_plane = 1 / std::sqrt(1 + c[1] * c[1] + c[2] * c[2]);
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes x = load(s.x + i);
    const Lanes y = load(s.y + i);
    Lanes a = all_lanes(c[1]);
    Lanes b = all_lanes(c[2]);
    Lanes f = c[0] + a * x + b * y;
    Lanes cosine = all_lanes(cosine_of_plane);
    if constexpr (curved) {
      const Lanes bx = c[3] * x + c[4] * y;
      const Lanes by = c[5] * y;
      f += bx * x + by * y;
      a += bx + c[3] * x;
      b += c[4] * x + 2 * by;
      cosine = 1.0 / root(1.0 + a * a + b * b);
    }
    // Squared differences of unit normals are 2 less twice their product; a sample without a
    // normal is foreign either way.
    const Lanes along = (load(s.w + i) - a * load(s.u + i) - b * load(s.v + i)) * cosine;
    const Lanes off = (load(s.place_height + i) - f) * cosine * per_reach;
    const Lanes belongs = level_top((1.0 - along) * per_turn + off * off);
    const Lanes near = 1.0 - load(s.square + i) * per_area;
    const Lanes all = near * belongs * load(s.trust + i);
    store(present(count, i) > 0.0 ? all : Lanes{}, shares + i);
  }
}
DEBURR_MULTIVERSION
void share_in_plane(const Neighbors& s, std::size_t count, const SheetSamples::Membership& member,
                    double* shares) {
  share_out<false>(s, count, member, shares);
}
DEBURR_MULTIVERSION
void share_in_quadric(const Neighbors& s, std::size_t count, const SheetSamples::Membership& member,
                      double* shares) {
  share_out<true>(s, count, member, shares);
}

struct Samples {
  const double *x, *y, *height, *weight, *share;
};

enum Sum { normal = 0, right = 15, squared_heights = 21, spread, shared, squared_shares, used };

/// Sums of the products of weights with the terms, and others.
DEBURR_MULTIVERSION
void add_moments(const Samples& s, std::size_t count, double per_scale, WeightedQuadric::Sums& to) {
  std::array<Lanes, 28> sums{};
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes share = load(s.share + i);
    const Lanes w = share * load(s.weight + i);
    const Lanes x = load(s.x + i) * per_scale;
    const Lanes y = load(s.y + i) * per_scale;
    const Lanes h = load(s.height + i);
    const Lanes xx = x * x;
    const Lanes xy = x * y;
    const Lanes yy = y * y;
    const std::array<Lanes, WeightedQuadric::terms> terms{w, w * x, w * y, w * xx, w * xy, w * yy};
    for (std::size_t k = 0; k < terms.size(); ++k) {
      sums[normal + k] += terms[k];
      sums[right + k] += terms[k] * h;
    }
    sums[6] += terms[3] * x;
    sums[7] += terms[3] * y;
    sums[8] += terms[5] * x;
    sums[9] += terms[5] * y;
    sums[10] += terms[3] * xx;
    sums[11] += terms[3] * xy;
    sums[12] += terms[3] * yy;
    sums[13] += terms[4] * yy;
    sums[14] += terms[5] * yy;
    sums[squared_heights] += w * h * h;
    sums[spread] += w * share;
    sums[shared] += share;
    sums[squared_shares] += share * share;
    sums[used] += share > 0.0 ? all_lanes(1) : Lanes{};
  }
  std::array<double, 28> all;
  sum_each(sums, all.data());
  for (std::size_t k = 0; k < to.normal.size(); ++k) to.normal[k] += all[normal + k];
  for (std::size_t k = 0; k < to.right.size(); ++k) to.right[k] += all[right + k];
  to.heights += all[squared_heights];
  to.spread += all[spread];
  to.shares += all[shared];
  to.share_squares += all[squared_shares];
  to.count += static_cast<std::size_t>(all[used]);
}

DEBURR_MULTIVERSION
double variance_of(const Samples& s, std::size_t count, const HeightQuadric& pull) {
  const auto& q = pull.c;
  Lanes total{};
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes x = load(s.x + i);
    const Lanes y = load(s.y + i);
    const Lanes share = load(s.share + i);
    const Lanes p = share * (q[0] + x * (q[1] + q[3] * x + q[4] * y) + y * (q[2] + q[5] * y));
    total += p * p * load(s.weight + i);
  }
  return sum(total);
}

}  // namespace

void SheetSamples::start(const SurfaceNodes& nodes, const Frame& frame,
                         std::span<const Found> found) {
  nodes_ = &nodes;
  frame_ = frame;
  found_ = found;
  filled_ = 0;
  summed_ = 0;
  const std::size_t room = found.size() + lane_count;
  if (x_.size() >= room) return;
  for (auto* const column : {&x_, &y_, &place_height_, &height_, &u_, &v_, &w_, &weight_, &trust_,
                             &square_, &share_, &measured_y_, &measured_z_}) {
    column->resize(2 * room);
  }
}

/// Makes ready the first `count` samples. The last lanes hold the last sample several times.
void SheetSamples::fill(std::size_t count) {
  if (count <= filled_) return;
  const std::size_t begin = filled_;
  filled_ = (count + lane_count - 1) / lane_count * lane_count;
  for (std::size_t k = begin; k < filled_; ++k) {
    const Found& f = found_[std::min(k, found_.size() - 1)];
    const Vec3& place = nodes_->places[f.index];
    x_[k] = place.x;
    y_[k] = place.y;
    place_height_[k] = place.z;
    const Vec3& normal = nodes_->normals[f.index];
    u_[k] = normal.x;
    v_[k] = normal.y;
    w_[k] = normal.z;
    const Vec3& measured = nodes_->measured[f.index];
    height_[k] = measured.x;
    measured_y_[k] = measured.y;
    measured_z_[k] = measured.z;
    weight_[k] = nodes_->weights[f.index];
    trust_[k] = nodes_->trust[f.index];
    square_[k] = f.squared_distance;
  }
  turn({x_.data(), y_.data(), place_height_.data(), u_.data(), v_.data(), w_.data(), height_.data(),
        measured_y_.data(), measured_z_.data()},
       begin, filled_, frame_);
}

std::size_t SheetSamples::count_within(double area) const {
  const auto end = std::ranges::upper_bound(found_, area, {}, &Found::squared_distance);
  return static_cast<std::size_t>(end - found_.begin());
}

void SheetSamples::sum(std::size_t count, const Membership& member, WeightedQuadric& sums) {
  fill(count);
  summed_ = count;
  const auto& c = member.surface.c;
  const bool curved = c[3] != 0 || c[4] != 0 || c[5] != 0;
  const Neighbors s{x_.data(), y_.data(), place_height_.data(), u_.data(),
                    v_.data(), w_.data(), trust_.data(),        square_.data()};
  (curved ? share_in_quadric : share_in_plane)(s, count, member, share_.data());
  add_moments({x_.data(), y_.data(), height_.data(), weight_.data(), share_.data()}, count,
              1 / sums.scale(), sums.sums());
}

double SheetSamples::variance(const HeightQuadric& pull) const {
  return variance_of({x_.data(), y_.data(), height_.data(), weight_.data(), share_.data()}, summed_,
                     pull);
}

}  // namespace deburr
