// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "deburr/vec3.hpp"
#include "sym3.hpp"

// Sums over neighbours run in eight lanes at once. The number of lanes is fixed and products are
// never contracted, so that the bits of a result do not depend on the width of the vector unit: the
// compiler makes of a lane operation one AVX-512 instruction, two of AVX2, or four of SSE2.

// Functions marked with this are compiled for each of these processors, and the program takes the
// best that it finds when it starts. Sanitizers cannot follow that start, and get the plain code.
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define DEBURR_MULTIVERSION __attribute__((target_clones("avx512f", "avx2", "default")))
#define DEBURR_TARGETS  // or that are written for each of them, for vectors of its own width
#else
#define DEBURR_MULTIVERSION
#endif
#define DEBURR_LANES_INLINE [[gnu::always_inline]] inline

namespace deburr {

inline constexpr std::size_t lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));
using LaneBits = std::int64_t __attribute__((vector_size(lane_count * sizeof(std::int64_t))));

/// The same value in every lane.
DEBURR_LANES_INLINE Lanes all_lanes(double v) { return Lanes{} + v; }

/// Sum over the lanes, in a fixed order.
DEBURR_LANES_INLINE double sum(const Lanes& v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

/// A vector in each lane.
struct Lanes3 {
  Lanes x{}, y{}, z{};
};

DEBURR_LANES_INLINE Lanes3 all_lanes(const Vec3& v) {
  return {all_lanes(v.x), all_lanes(v.y), all_lanes(v.z)};
}
DEBURR_LANES_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
DEBURR_LANES_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
DEBURR_LANES_INLINE Lanes3 operator*(const Lanes& s, const Lanes3& v) {
  return {s * v.x, s * v.y, s * v.z};
}
DEBURR_LANES_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
DEBURR_LANES_INLINE Vec3 lane(const Lanes3& v, std::size_t l) { return {v.x[l], v.y[l], v.z[l]}; }
DEBURR_LANES_INLINE void set_lane(Lanes3& v, std::size_t l, const Vec3& value) {
  v.x[l] = value.x;
  v.y[l] = value.y;
  v.z[l] = value.z;
}
DEBURR_LANES_INLINE Vec3 sum(const Lanes3& v) { return {sum(v.x), sum(v.y), sum(v.z)}; }

/// A sum of outer products in each lane.
struct LanesSym3 {
  Lanes xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

  /// Adds weight * v v^T.
  DEBURR_LANES_INLINE void add_outer(const Lanes& weight, const Lanes3& v) {
    const Lanes3 w = weight * v;
    xx += w.x * v.x;
    xy += w.x * v.y;
    xz += w.x * v.z;
    yy += w.y * v.y;
    yz += w.y * v.z;
    zz += w.z * v.z;
  }
  DEBURR_LANES_INLINE void scale(const Lanes& s) {
    xx *= s;
    xy *= s;
    xz *= s;
    yy *= s;
    yz *= s;
    zz *= s;
  }
};
DEBURR_LANES_INLINE void set_lane(LanesSym3& m, std::size_t l, const Sym3& value) {
  m.xx[l] = value.xx;
  m.xy[l] = value.xy;
  m.xz[l] = value.xz;
  m.yy[l] = value.yy;
  m.yz[l] = value.yz;
  m.zz[l] = value.zz;
}
DEBURR_LANES_INLINE Sym3 sum(const LanesSym3& m) {
  return {sum(m.xx), sum(m.xy), sum(m.xz), sum(m.yy), sum(m.yz), sum(m.zz)};
}

/// exp(x) for x <= 0, to 1e-15 relative; 0 below -700. Without the C library, whose last bit
/// differs between processors.
DEBURR_LANES_INLINE Lanes exp_of_negative(const Lanes& x) {
  // x = n ln 2 + r; adding and taking away 1.5 * 2^52 rounds to an integer.
  constexpr double rounder = 0x1.8p52;
  const Lanes shifted = x * 0x1.71547652b82fep+0 + rounder;
  const Lanes n = shifted - rounder;
  const Lanes r = (x - n * 0x1.62e42feep-1) - n * 0x1.a39ef35793c76p-33;
  // Taylor series, |r| <= 0.35: the first term left out is 4e-18. Summed in a tree (Estrin), since
  // one term after the other would wait for each product.
  const Lanes r2 = r * r;
  const Lanes r4 = r2 * r2;
  const Lanes r8 = r4 * r4;
  const Lanes p0 = (1.0 + r) + r2 * (1.0 / 2 + r * (1.0 / 6));
  const Lanes p4 = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
  const Lanes p8 = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
  const Lanes p12 = 1.0 / 479001600 + r * (1.0 / 6227020800);
  const Lanes p = (p0 + r4 * p4) + r8 * (p8 + r4 * p12);
  // The integer stands in the low bits of `shifted`; it goes to the exponent.
  LaneBits bits;
  std::memcpy(&bits, &shifted, sizeof bits);
  bits = (bits + 1023) << 52;
  Lanes power;
  std::memcpy(&power, &bits, sizeof power);
  return x > -700.0 ? p * power : Lanes{};
}

/// Eight neighbours at a time; at the end of the list the missing ones are the zero vector.
DEBURR_LANES_INLINE Lanes3 load(std::span<const Vec3> values, std::span<const std::uint32_t> list,
                                std::size_t from) {
  Lanes3 v;
  if (from + lane_count <= list.size()) {
    for (std::size_t l = 0; l < lane_count; ++l) {
      const Vec3& value = values[list[from + l]];
      v.x[l] = value.x;
      v.y[l] = value.y;
      v.z[l] = value.z;
    }
  } else {
    for (std::size_t l = 0; from + l < list.size(); ++l) {
      const Vec3& value = values[list[from + l]];
      v.x[l] = value.x;
      v.y[l] = value.y;
      v.z[l] = value.z;
    }
  }
  return v;
}

/// 1 in the lanes that hold a neighbour, 0 in those beyond the end of the list.
DEBURR_LANES_INLINE Lanes present(std::size_t list_size, std::size_t from) {
  constexpr Lanes lane_number = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto left = static_cast<double>(list_size - from);
  return lane_number < left ? all_lanes(1) : Lanes{};
}

}  // namespace deburr
