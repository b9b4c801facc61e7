// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  const auto scan = deburr::synthesize_part({.points = 20000});
  const auto automatic = deburr::denoise(scan.cloud);
  const auto published = deburr::denoise(scan.cloud, {.method = deburr::Method::Yadav2018});
  for (const auto& cloud : {scan.cloud, automatic.cloud, published.cloud}) {
    std::printf("%.2f mm\n", deburr::compare_to_surface(cloud.points, scan.truth).mean);
  }
}
