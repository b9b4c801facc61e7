// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  const deburr::SyntheticScan scan = deburr::synthesize_part({.points = 20000});
  const deburr::DenoiseResult result = deburr::denoise(scan.cloud);

  const auto before = deburr::compare_to_surface(scan.cloud.points, scan.truth);
  const auto after = deburr::compare_to_surface(result.cloud.points, scan.truth);
  std::printf("mean distance to the true surface: %.2f mm, then %.2f mm\n", before.mean,
              after.mean);
}
