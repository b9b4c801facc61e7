// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  // Two noisy normals of a top face, and one of the side below its edge.
  const std::vector<deburr::Vec3> normals{{0.28, 0, 0.96}, {-0.28, 0, 0.96}, {1, 0, 0}};
  const deburr::Neighborhoods all({0, 2, 4, 6}, {1, 2, 0, 2, 0, 1});
  for (const deburr::Vec3& n : deburr::filter_normals(normals, all, {.rho = 0.8})) {
    std::printf("%.2f %.2f %.2f\n", n.x, n.y, n.z);
  }
}
