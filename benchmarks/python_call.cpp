// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "deburr/denoise.hpp"
#include "deburr/synth.hpp"

// The call that benchmarks/python_call measures from Python: seconds of the processor and growth of
// the largest memory, in bytes.

namespace {

double processor_seconds() {
  rusage used{};
  (void)getrusage(RUSAGE_SELF, &used);
  const auto sum = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return sum(used.ru_utime) + sum(used.ru_stime);
}

/// Of this process, in bytes; getrusage() would count the process that started it.
long largest_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return 1024 * std::atol(line.c_str() + 6);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace deburr;
  if (argc != 3) return 2;
  const auto points = static_cast<std::size_t>(std::atoll(argv[2]));
  PointCloud cloud;
  if (std::string_view(argv[1]) == "finite") {
    cloud = synthesize_part({.points = points}).cloud;
  } else {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    cloud.points.assign(points, Vec3{nan, nan, nan});
  }
  const long peak = largest_memory();
  const double before = processor_seconds();
  const DenoiseResult result = denoise(cloud, {}, {.threads = 1});
  const double after = processor_seconds();
  std::printf("%.6f %ld\n", after - before, largest_memory() - peak);
  return result.labels.size() == points ? 0 : 1;
}
