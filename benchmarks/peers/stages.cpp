// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "deburr/deburr.hpp"
#include "measure.hpp"

// Stages of deburr: stages neighbors|orientation CLOUD RADIUS THREADS. The number is that of pairs,
// of normals.

int main(int argc, char** argv) {
  if (argc != 5) peers::fail("usage: stages neighbors|orientation CLOUD RADIUS THREADS");
  const std::string stage = argv[1];
  const std::vector<deburr::Vec3> points = deburr::read_cloud(argv[2]).points;
  const double radius = std::stod(argv[3]);
  const deburr::Execution execution{.threads = std::stoi(argv[4])};
  if (stage == "neighbors") {
    peers::measure(
        [&] { return deburr::find_neighbors(points, {.radius = radius}, execution).pair_count(); });
  } else if (stage == "orientation") {
    const auto near = deburr::find_neighbors(points, {.max_count = 12}, execution);
    const auto normals = deburr::estimate_normals(points, near, execution);
    peers::measure([&] { return deburr::orient_normals(points, normals, near, execution).size(); });
  } else {
    peers::fail("no such stage: " + stage);
  }
  return 0;
}
