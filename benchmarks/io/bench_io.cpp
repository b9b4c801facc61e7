// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "deburr/io.hpp"

// How fast files are read and written, next to cat on the same files:
//   bench_io [POINTS [FOLDER]]
// A folder in memory (the default, /dev/shm) leaves the disk out of it.

namespace {

namespace fs = std::filesystem;
using deburr::PointCloud;

constexpr int repeats = 5;

double seconds_of(const auto& work) {
  double best = 1e300;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count());
  }
  return best;
}

/// Survey-like points with intensity, time and colours; float coordinates for formats with floats.
PointCloud make_cloud(std::size_t points, bool floats) {
  PointCloud cloud;
  std::vector<std::uint16_t> intensity;
  std::vector<double> time;
  std::vector<std::uint8_t> color;
  for (std::size_t i = 0; i < points; ++i) {
    const auto t = static_cast<double>(i);
    const double scale = floats ? 1.0 : 0.001;
    cloud.points.push_back({std::floor(1000 * std::sin(1e-3 * t)) * scale,
                            std::floor(1000 * std::cos(1e-3 * t)) * scale,
                            std::floor(t / 1000) * scale});
    intensity.push_back(static_cast<std::uint16_t>(i));
    time.push_back(1e5 + 1e-5 * t);
    color.push_back(static_cast<std::uint8_t>(i));
  }
  cloud.attributes = {{"intensity", intensity, {}},
                      {"gps_time", time, {}},
                      {"red", color, {}},
                      {"green", color, {}},
                      {"blue", color, {}}};
  if (floats) {
    for (const char* name : {"x", "y", "z"}) {
      cloud.layout.fields.push_back({name, deburr::ScalarType::Float32});
    }
  }
  return cloud;
}

void run(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command + " failed");
}

void measure(const std::string& name, const std::string& extension, const PointCloud& cloud,
             const fs::path& folder) {
  const fs::path file = folder / ("bench_io." + extension);
  const fs::path copy = folder / ("bench_io_copy." + extension);
  (void)write_cloud(file, cloud);
  const PointCloud again = deburr::read_cloud(file);
  const double megabytes = static_cast<double>(fs::file_size(file)) / 1e6;
  const double read = seconds_of([&] { (void)deburr::read_cloud(file); });
  const double write = seconds_of([&] { (void)write_cloud(copy, again); });
  const double cat = seconds_of([&] { run("cat " + file.string() + " | cat > /dev/null"); });
  const double cat_file = seconds_of([&] { run("cat " + file.string() + " > " + copy.string()); });
  std::printf("%-16s %8.0f %10.0f %10.0f %8.2f %10.0f %10.0f %8.2f\n", name.c_str(), megabytes,
              megabytes / read, megabytes / cat, cat / read, megabytes / write,
              megabytes / cat_file, cat_file / write);
  fs::remove(file);
  fs::remove(copy);
}

void run_all(std::size_t points, const fs::path& folder) {
  std::printf("%zu points in %s; MB/s, best of %d; cat: through a pipe, and to a file\n", points,
              folder.c_str(), repeats);
  std::printf("%-16s %8s %10s %10s %8s %10s %10s %8s\n", "", "MB", "read", "cat |", "ratio",
              "write", "cat >", "ratio");
  const PointCloud floats = make_cloud(points, true);
  const PointCloud doubles = make_cloud(points, false);
  measure("ply float", "ply", floats, folder);
  measure("ply double", "ply", doubles, folder);
  measure("las", "las", doubles, folder);
  measure("pcd binary", "pcd", floats, folder);
  PointCloud packed = floats;
  packed.layout.encoding = deburr::Encoding::PcdCompressed;
  measure("pcd compressed", "pcd", packed, folder);
  measure("csv", "csv", doubles, folder);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run_all(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2'000'000,
            argc > 2 ? argv[2] : "/dev/shm");
  } catch (const std::exception& error) {
    (void)std::fprintf(stderr, "bench_io: %s\n", error.what());
    return 1;
  }
}
