// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#include "lane_sums.hpp"
#include "lanes.hpp"
#include "sheet_samples.hpp"

namespace deburr {

static_assert(SheetSamples::block_size == lane_count);

/// The loops over blocks.
struct SheetSamples::Kernels {
  using Column = std::array<double, lane_count>;

  DEBURR_LANES_INLINE static Lanes load(const Column& from) {
    Lanes v;
    std::memcpy(&v, from.data(), sizeof v);
    return v;
  }
  DEBURR_LANES_INLINE static void store(const Lanes& v, Column& to) {
    std::memcpy(to.data(), &v, sizeof v);
  }

  DEBURR_LANES_INLINE static Lanes root(Lanes v) {
    for (std::size_t l = 0; l < lane_count; ++l) v[l] = std::sqrt(v[l]);
    return v;
  }

  /// As in belonging.hpp, in lanes.
  DEBURR_LANES_INLINE static Lanes level_top(const Lanes& e) {
    const Lanes t = 1.0 - e * e * (1.0 / 9);
    const Lanes t2 = t * t;
    const Lanes t4 = t2 * t2;
    return e < 3.0 ? t4 * t4 : Lanes{};
  }

  /// Where each of the sums stands among all that are made at once.
  enum Sum { normal = 0, right = 15, squared_heights = 21, spread, shared, squared_shares, used };
  static constexpr std::size_t sums_at_once = 28;

  /// Coordinates of places and normals in the frame instead, and heights of measured positions.
  DEBURR_MULTIVERSION
  static void turn(std::span<Block> blocks, const Frame& frame) {
    const Lanes3 origin = all_lanes(frame.origin);
    const Lanes3 u = all_lanes(frame.u);
    const Lanes3 v = all_lanes(frame.v);
    const Lanes3 w = all_lanes(frame.w);
    for (Block& s : blocks) {
      const Lanes3 place = Lanes3{load(s.x), load(s.y), load(s.place_height)} - origin;
      const Lanes3 normal{load(s.u), load(s.v), load(s.w)};
      const Lanes3 measured{load(s.height), load(s.share), load(s.measured)};
      store(dot(place, u), s.x);
      store(dot(place, v), s.y);
      store(dot(place, w), s.place_height);
      store(dot(normal, u), s.u);
      store(dot(normal, v), s.v);
      store(dot(normal, w), s.w);
      store(dot(measured - origin, w), s.height);
    }
  }

  /// The shares of the first `count` samples, 0 for those after them up to whole lanes.
  /// @param curved  whether the surface is
  template <bool curved>
  DEBURR_LANES_INLINE static void share_out(Block* blocks, std::size_t count,
                                            const Membership& member) {
    const auto& c = member.surface.c;
    const double per_area = 0.9 / member.area;
    const double per_reach = 1 / member.reach;
    const double per_turn = 2 / (member.normal_reach * member.normal_reach);
    const double cosine_of_plane = 1 / std::sqrt(1 + c[1] * c[1] + c[2] * c[2]);
    for (std::size_t i = 0; i < count; i += lane_count) {
      Block& s = blocks[i / lane_count];
      const Lanes x = load(s.x);
      const Lanes y = load(s.y);
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
      const Lanes along = (load(s.w) - a * load(s.u) - b * load(s.v)) * cosine;
      const Lanes off = (load(s.place_height) - f) * cosine * per_reach;
      const Lanes belongs = level_top((1.0 - along) * per_turn + off * off);
      const Lanes near = 1.0 - load(s.square) * per_area;
      const Lanes all = near * belongs * load(s.trust);
      store(present(count, i) > 0.0 ? all : Lanes{}, s.share);
    }
  }
  DEBURR_MULTIVERSION
  static void share_in_plane(Block* blocks, std::size_t count, const Membership& member) {
    share_out<false>(blocks, count, member);
  }
  DEBURR_MULTIVERSION
  static void share_in_quadric(Block* blocks, std::size_t count, const Membership& member) {
    share_out<true>(blocks, count, member);
  }

  /// Sums of the products of weights with the terms, and others, in the lanes from `first` on.
  template <typename V>
  DEBURR_LANES_INLINE static void add_moments(std::span<const Block> blocks, std::size_t first,
                                              double per_scale, V* sums) {
    const auto part = [first](const Column& from) __attribute__((always_inline)) {
      V v;
      std::memcpy(&v, from.data() + first, sizeof v);
      return v;
    };
    for (const Block& s : blocks) {
      const V share = part(s.share);
      const V w = share * part(s.weight);
      const V x = part(s.x) * per_scale;
      const V y = part(s.y) * per_scale;
      const V h = part(s.height);
      const V xx = x * x;
      const V xy = x * y;
      const V yy = y * y;
      const V terms[]{w, w * x, w * y, w * xx, w * xy, w * yy};
      for (std::size_t k = 0; k < WeightedQuadric::terms; ++k) {
        sums[normal + k] += terms[k];
        sums[right + k] += terms[k] * h;
      }
      sums[normal + 6] += terms[3] * x;
      sums[normal + 7] += terms[3] * y;
      sums[normal + 8] += terms[5] * x;
      sums[normal + 9] += terms[5] * y;
      sums[normal + 10] += terms[3] * xx;
      sums[normal + 11] += terms[3] * xy;
      sums[normal + 12] += terms[3] * yy;
      sums[normal + 13] += terms[4] * yy;
      sums[normal + 14] += terms[5] * yy;
      sums[squared_heights] += w * h * h;
      sums[spread] += w * share;
      sums[shared] += share;
      sums[squared_shares] += share * share;
      sums[used] += share > 0.0 ? V{} + 1.0 : V{};
    }
  }

  using Sums = std::array<double, sums_at_once>;

  // One of these is taken when the program starts. Where vectors of the processor have fewer lanes,
  // half of them come after the others: of all at once, the compiler would put every product into
  // memory.
#ifdef DEBURR_TARGETS
  [[gnu::target("avx512f")]] static Sums moments(std::span<const Block> blocks, double per_scale) {
    std::array<Lanes, sums_at_once> sums{};
    add_moments(blocks, 0, per_scale, sums.data());
    Sums all;
    sum_each(sums, all.data());
    return all;
  }
  [[gnu::target("avx2")]] static Sums moments(std::span<const Block> blocks, double per_scale) {
    return moments_by_half(blocks, per_scale);
  }
  [[gnu::target("default")]]
#endif
  static Sums
  moments(std::span<const Block> blocks, double per_scale) {
    return moments_by_half(blocks, per_scale);
  }
  DEBURR_LANES_INLINE static Sums moments_by_half(std::span<const Block> blocks, double per_scale) {
    std::array<std::array<HalfLanes, sums_at_once>, 2> half{};
    add_moments(blocks, 0, per_scale, half[0].data());
    add_moments(blocks, lane_count / 2, per_scale, half[1].data());
    for (std::size_t k = 0; k < sums_at_once; ++k) half[0][k] += half[1][k];
    Sums all;
    sum_each(half[0], all.data());
    return all;
  }

  DEBURR_MULTIVERSION
  static double variance(std::span<const Block> blocks, const HeightQuadric& pull) {
    const auto& q = pull.c;
    Lanes total{};
    for (const Block& s : blocks) {
      const Lanes x = load(s.x);
      const Lanes y = load(s.y);
      const Lanes p =
          load(s.share) * (q[0] + x * (q[1] + q[3] * x + q[4] * y) + y * (q[2] + q[5] * y));
      total += p * p * load(s.weight);
    }
    return deburr::sum(total);
  }
};

}  // namespace deburr
