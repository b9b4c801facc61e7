// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lanes.hpp"

namespace deburr {
namespace {

DEBURR_LANES_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

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

struct Columns {
  const double *x, *y, *height, *place_height, *weight, *trust, *square, *u, *v, *w;
};

/// The weights of the first `count` samples, 0 for those after them up to whole lanes.
DEBURR_MULTIVERSION
void weigh(const Columns& s, std::size_t count, const SheetSamples::Membership& member,
           double* weights) {
  const auto& c = member.surface.c;
  const double per_area = 0.9 / member.area;
  const double per_reach = 1 / member.reach;
  const double per_turn = 1 / (member.normal_reach * member.normal_reach);
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes x = load(s.x + i);
    const Lanes y = load(s.y + i);
    const Lanes a = c[1] + 2 * c[3] * x + c[4] * y;
    const Lanes b = c[2] + c[4] * x + 2 * c[5] * y;
    const Lanes f = c[0] + (c[1] + c[3] * x + c[4] * y) * x + (c[2] + c[5] * y) * y;
    const Lanes cosine = 1.0 / root(1.0 + a * a + b * b);
    const Lanes du = load(s.u + i) + a * cosine;
    const Lanes dv = load(s.v + i) + b * cosine;
    const Lanes dw = load(s.w + i) - cosine;
    const Lanes off = (load(s.place_height + i) - f) * cosine * per_reach;
    const Lanes share = level_top((du * du + dv * dv + dw * dw) * per_turn + off * off);
    const Lanes near = 1.0 - load(s.square + i) * per_area;
    const Lanes all = near * share * load(s.weight + i) * load(s.trust + i);
    const Lanes weight = present(count, i) > 0.0 ? all : Lanes{};
    std::memcpy(weights + i, &weight, sizeof weight);
  }
}

/// Sums of the products of weight (and of its square over the number of points) with the terms.
DEBURR_MULTIVERSION
void add_moments(const Columns& s, const double* weights, std::size_t count, double per_scale,
                 WeightedQuadric::Sums& to) {
  std::array<Lanes, WeightedQuadric::moments> normal{};
  std::array<Lanes, WeightedQuadric::moments> spread{};
  std::array<Lanes, WeightedQuadric::terms> right{};
  Lanes heights{};
  Lanes shares{};
  Lanes share_squares{};
  Lanes used{};
  for (std::size_t i = 0; i < count; i += lane_count) {
    const Lanes w = load(weights + i);
    const Lanes share = w / load(s.weight + i);
    const Lanes x = load(s.x + i) * per_scale;
    const Lanes y = load(s.y + i) * per_scale;
    const Lanes h = load(s.height + i);
    const Lanes xx = x * x;
    const Lanes xy = x * y;
    const Lanes yy = y * y;
    const std::array<Lanes, WeightedQuadric::moments> product{
        all_lanes(1), x,      y,       xx,      xy,      yy,      xx * x, xx * y,
        x * yy,       yy * y, xx * xx, xx * xy, xx * yy, xy * yy, yy * yy};
    const Lanes squared = w * share;
    for (std::size_t k = 0; k < product.size(); ++k) {
      normal[k] += w * product[k];
      spread[k] += squared * product[k];
    }
    const Lanes wh = w * h;
    for (std::size_t k = 0; k < right.size(); ++k) right[k] += wh * product[k];
    heights += wh * h;
    shares += share;
    share_squares += share * share;
    used += w > 0.0 ? all_lanes(1) : Lanes{};
  }
  for (std::size_t k = 0; k < normal.size(); ++k) {
    to.normal[k] += sum(normal[k]);
    to.spread[k] += sum(spread[k]);
  }
  for (std::size_t k = 0; k < right.size(); ++k) to.right[k] += sum(right[k]);
  to.heights += sum(heights);
  to.shares += sum(shares);
  to.share_squares += sum(share_squares);
  to.count += static_cast<std::size_t>(sum(used));
}

}  // namespace

void SheetSamples::add(const Sample& sample) {
  if (size_ + lane_count > shares_.size()) {
    const std::size_t room = 2 * size_ + 4 * lane_count;
    for (auto& column : columns_) column.resize(room);
    // Lanes beyond the last sample are worked on too, and must be divided by something.
    std::ranges::replace(columns_[weights], 0.0, 1.0);
    shares_.resize(room);
  }
  columns_[xs][size_] = sample.x;
  columns_[ys][size_] = sample.y;
  columns_[heights][size_] = sample.height;
  columns_[place_heights][size_] = sample.place_height;
  columns_[weights][size_] = sample.weight;
  columns_[trusts][size_] = sample.trust;
  columns_[squares][size_] = sample.square;
  columns_[us][size_] = sample.normal.x;
  columns_[vs][size_] = sample.normal.y;
  columns_[ws][size_] = sample.normal.z;
  ++size_;
}

std::size_t SheetSamples::count_within(double area) const {
  const auto begin = columns_[squares].begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(size_);
  return static_cast<std::size_t>(std::upper_bound(begin, end, area) - begin);
}

void SheetSamples::sum(std::size_t count, const Membership& member, WeightedQuadric& sums) {
  const auto column = [&](Column c) { return columns_[c].data(); };
  const Columns s{column(xs),      column(ys),     column(heights), column(place_heights),
                  column(weights), column(trusts), column(squares), column(us),
                  column(vs),      column(ws)};
  weigh(s, count, member, shares_.data());
  add_moments(s, shares_.data(), count, 1 / sums.scale(), sums.sums());
}

}  // namespace deburr
