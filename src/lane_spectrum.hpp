// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstring>

#include "lanes.hpp"
#include "sym3.hpp"

namespace deburr {

/// Eigenvalues and eigenvectors of a matrix in each lane, as in Spectrum.
struct LanesSpectrum {
  std::array<Lanes, 3> values;
  std::array<Lanes3, 3> vectors;
};

DEBURR_LANES_INLINE Lanes sqrt(const Lanes& v) {
  std::array<double, lane_count> each;
  std::memcpy(each.data(), &v, sizeof v);
  for (double& d : each) d = std::sqrt(d);
  Lanes root;
  std::memcpy(&root, each.data(), sizeof root);
  return root;
}
DEBURR_LANES_INLINE Lanes abs(const Lanes& v) {
  LaneBits bits;
  std::memcpy(&bits, &v, sizeof bits);
  bits &= 0x7fffffffffffffff;
  Lanes positive;
  std::memcpy(&positive, &bits, sizeof positive);
  return positive;
}
DEBURR_LANES_INLINE bool any(const LaneBits& b) {
  return (((b[0] | b[4]) | (b[2] | b[6])) | ((b[1] | b[5]) | (b[3] | b[7]))) != 0;
}
DEBURR_LANES_INLINE Lanes3 choose(const LaneBits& which, const Lanes3& a, const Lanes3& b) {
  return {which ? a.x : b.x, which ? a.y : b.y, which ? a.z : b.z};
}

/// unit() in each lane.
DEBURR_LANES_INLINE Lanes3 unit(const Lanes3& v) {
  const Lanes length = sqrt(dot(v, v));
  return choose(length < 1e-10, all_lanes(Vec3{0, 0, 1}), (1 / length) * v);
}

/// The rotation of spectrum(), in the lanes `turns`; the others stay as they are.
DEBURR_LANES_INLINE void rotate(const LaneBits& turns, Lanes& app, Lanes& aqq, Lanes& apq,
                                Lanes& arp, Lanes& arq, Lanes3& vp, Lanes3& vq) {
  const Lanes theta = (aqq - app) / (2 * apq);
  const Lanes sign = theta < 0.0 ? all_lanes(-1) : all_lanes(1);
  const Lanes t = sign / (abs(theta) + sqrt(theta * theta + 1));
  const Lanes c = 1 / sqrt(t * t + 1);
  const Lanes s = t * c;
  app = turns ? app - t * apq : app;
  aqq = turns ? aqq + t * apq : aqq;
  apq = turns ? Lanes{} : apq;
  const Lanes rp = c * arp - s * arq;
  const Lanes rq = s * arp + c * arq;
  arp = turns ? rp : arp;
  arq = turns ? rq : arq;
  const Lanes3 p = c * vp - s * vq;
  const Lanes3 q = s * vp + c * vq;
  vp = choose(turns, p, vp);
  vq = choose(turns, q, vq);
}

/// spectrum() of the matrix in each lane, with the same bits.
DEBURR_LANES_INLINE LanesSpectrum spectrum(LanesSym3 a, double tolerance) {
  const Lanes one = all_lanes(1);
  LanesSpectrum s{{}, {Lanes3{one, {}, {}}, Lanes3{{}, one, {}}, Lanes3{{}, {}, one}}};
  auto& [u, v, w] = s.vectors;
  const Lanes negligible = jacobi::negligible * abs(a.xx + a.yy + a.zz);
  const Lanes enough = negligible > tolerance ? negligible : all_lanes(tolerance);
  for (int sweep = 0; sweep < jacobi::most_sweeps; ++sweep) {
    const Lanes off_diagonal = abs(a.xy) + abs(a.xz) + abs(a.yz);
    const LaneBits goes_on = off_diagonal > enough;
    if (!any(goes_on)) break;
    const Lanes small =
        sweep < jacobi::coarse_sweeps ? jacobi::coarse_share * off_diagonal : Lanes{};
    rotate(goes_on & (abs(a.xy) > small), a.xx, a.yy, a.xy, a.xz, a.yz, u, v);
    rotate(goes_on & (abs(a.xz) > small), a.xx, a.zz, a.xz, a.xy, a.yz, u, w);
    rotate(goes_on & (abs(a.yz) > small), a.yy, a.zz, a.yz, a.xy, a.xz, v, w);
  }
  s.values = {a.xx, a.yy, a.zz};
  const auto order = [&](std::size_t p, std::size_t q) __attribute__((always_inline)) {
    const LaneBits stays = s.values[p] >= s.values[q];
    const Lanes value = s.values[p];
    const Lanes3 vector = s.vectors[p];
    s.values[p] = stays ? value : s.values[q];
    s.values[q] = stays ? s.values[q] : value;
    s.vectors[p] = choose(stays, vector, s.vectors[q]);
    s.vectors[q] = choose(stays, s.vectors[q], vector);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return s;
}

}  // namespace deburr
