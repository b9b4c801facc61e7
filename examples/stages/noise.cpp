// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  const auto scan = deburr::synthesize_part({.points = 20000, .noise = 0.002});
  const double diagonal = deburr::compare_to_surface(scan.cloud.points, scan.truth).diagonal;
  const double sigma = deburr::estimate_noise(scan.cloud.points);
  std::printf("noise %.2f mm, estimated %.2f mm\n", 0.002 * diagonal, sigma);
}
