// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "noise_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace deburr {
namespace {

double quant(){ static double q=std::getenv("NQ")?atof(std::getenv("NQ")):0.2; return q;}
double normal_quantile(double p){double lo=-8,hi=8;for(int i=0;i<60;i++){double m=.5*(lo+hi);(0.5*std::erfc(-m/std::sqrt(2.0))<p?lo:hi)=m;}return lo;}
double zq(){static double z=normal_quantile(quant());return z;}

/// Quantile of chi-squared / freedom.
double chi(double freedom) {
  const double a = 2 / (9 * freedom);
  const double t = 1 - a + zq() * std::sqrt(a);
  return t * t * t;
}

}  // namespace

NoiseEstimate combine_patches(std::span<const SurfacePatch> patches) {
  std::vector<double> variances, spacings, reaches;
  for (const SurfacePatch& p : patches) {
    if (p.freedom < 4) continue;
    variances.push_back(p.variance / chi(p.freedom));
    spacings.push_back(p.spacing);
    reaches.push_back(p.reach);
  }
  if (variances.empty()) return {};
  auto qu = [](std::vector<double>& v, double p) {
    auto at = v.begin() + (std::ptrdiff_t)(p * (double)(v.size()-1));
    std::nth_element(v.begin(), at, v.end());
    return *at;
  };
  return {std::sqrt(qu(variances, quant())), qu(spacings, .5), qu(reaches, .5)};
}

}  // namespace deburr
