// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  // A strip of one face along its edge: points in a row, all with the same normal.
  const std::vector<deburr::Vec3> row{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  const std::vector<deburr::Vec3> normals(row.size(), {0, 0, 1});
  const auto nearest = deburr::find_neighbors(row, {.radius = 2});
  const auto found = deburr::classify_features(row, normals, nearest);
  std::printf("%s along x: %.1f\n", to_string(found.label[2]).data(), found.direction[2].x);
}
