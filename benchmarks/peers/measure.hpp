// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// What the programs share that benchmarks/speed compiles: text files of points, and a clock that
// leaves their reading and writing out. Nothing of deburr is in here, since CGAL is under the GPL.

namespace peers {

using Point = std::array<double, 3>;

[[noreturn]] inline void fail(const std::string& what) {
  std::cerr << what << '\n';
  std::exit(1);
}

inline std::vector<Point> read_points(const std::string& path) {
  std::ifstream file(path);
  std::vector<Point> points;
  for (Point p{}; file >> p[0] >> p[1] >> p[2];) points.push_back(p);
  if (points.empty()) fail("no points in " + path);
  return points;
}

/// @param at  at(i) is the i-th point, with [0], [1] and [2]
template <typename At>
void write_points(const std::string& path, std::size_t count, const At& at) {
  std::ofstream file(path);
  file.precision(17);
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = at(i);
    file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  if (!file.flush()) fail("cannot write " + path);
}

/// Runs some work and prints what processor time and what time it took, and a number.
template <typename Work>
void measure(const Work& work) {
  const auto cpu = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double before = cpu();
  const auto start = std::chrono::steady_clock::now();
  const std::size_t number = work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::printf("{\"cpu\": %.6f, \"wall\": %.6f, \"number\": %zu}\n", cpu() - before, wall.count(),
              number);
}

}  // namespace peers
