// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sym3.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deburr {
namespace {

/// Rotates a_pq to zero in the plane of axes p and q; r is the third axis.
void rotate(double& app, double& aqq, double& apq, double& arp, double& arq, Vec3& vp, Vec3& vq) {
  const double theta = (aqq - app) / (2 * apq);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1);
  const double s = t * c;
  app -= t * apq;
  aqq += t * apq;
  apq = 0;
  const double old_rp = arp;
  arp = c * old_rp - s * arq;
  arq = s * old_rp + c * arq;
  const Vec3 old_vp = vp;
  vp = c * old_vp - s * vq;
  vq = s * old_vp + c * vq;
}

}  // namespace

Spectrum spectrum(const Sym3& m, double tolerance) {
  using namespace jacobi;
  Sym3 a = m;
  Spectrum s{{}, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  auto& [u, v, w] = s.vectors;
  const double enough = std::max(tolerance, negligible * std::abs(m.trace()));
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double off_diagonal = std::abs(a.xy) + std::abs(a.xz) + std::abs(a.yz);
    if (!(off_diagonal > enough)) break;
    const double small = sweep < coarse_sweeps ? coarse_share * off_diagonal : 0;
    if (std::abs(a.xy) > small) rotate(a.xx, a.yy, a.xy, a.xz, a.yz, u, v);
    if (std::abs(a.xz) > small) rotate(a.xx, a.zz, a.xz, a.xy, a.yz, u, w);
    if (std::abs(a.yz) > small) rotate(a.yy, a.zz, a.yz, a.xy, a.xz, v, w);
  }
  s.values = {a.xx, a.yy, a.zz};
  const auto order = [&](std::size_t p, std::size_t q) {
    if (s.values[p] >= s.values[q]) return;
    std::swap(s.values[p], s.values[q]);
    std::swap(s.vectors[p], s.vectors[q]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return s;
}

}  // namespace deburr
