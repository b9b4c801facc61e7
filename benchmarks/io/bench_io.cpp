// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

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
// A folder in memory (the default, /dev/shm) leaves the disk out of it. There, `cat FILE > COPY`
// reads as many bytes as we do and fills as much fresh memory; `cat FILE | cat > /dev/null` fills
// none. Both are compared in seconds of a processor, which other programs disturb least, and in
// elapsed ones. What starting a shell and cat takes is left out.

namespace {

namespace fs = std::filesystem;
using deburr::PointCloud;

constexpr int repeats = 5;

struct Seconds {
  double cpu = 1e300;
  double elapsed = 1e300;
};

double cpu_of(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The least of some repeats.
Seconds seconds_of(const auto& work, int who = RUSAGE_SELF) {
  Seconds best;
  for (int i = 0; i < repeats; ++i) {
    const double cpu = cpu_of(who);
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    best.cpu = std::min(best.cpu, cpu_of(who) - cpu);
    best.elapsed = std::min(best.elapsed, took.count());
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

/// Seconds that cat takes for a file, without those for an empty one.
Seconds cat(const std::string& before, const fs::path& file, const std::string& after) {
  const auto command = [&](const std::string& name) { return before + name + after; };
  const Seconds idle = seconds_of([&] { run(command("/dev/null")); }, RUSAGE_CHILDREN);
  const Seconds all = seconds_of([&] { run(command(file.string())); }, RUSAGE_CHILDREN);
  return {all.cpu - idle.cpu, all.elapsed - idle.elapsed};
}

void print(const std::string& name, const char* what, double megabytes, const Seconds& ours,
           const Seconds& copy, const Seconds& pipe) {
  std::printf("%-15s %-6s %5.0f | %6.0f %6.0f %6.0f %6.2f %6.2f | %6.0f %6.0f %6.0f %6.2f %6.2f\n",
              name.c_str(), what, megabytes, megabytes / ours.cpu, megabytes / copy.cpu,
              megabytes / pipe.cpu, copy.cpu / ours.cpu, pipe.cpu / ours.cpu,
              megabytes / ours.elapsed, megabytes / copy.elapsed, megabytes / pipe.elapsed,
              copy.elapsed / ours.elapsed, pipe.elapsed / ours.elapsed);
}

void measure(const std::string& name, const std::string& extension, const PointCloud& cloud,
             const fs::path& folder) {
  const fs::path file = folder / ("bench_io." + extension);
  const fs::path copy = folder / ("bench_io_copy." + extension);
  (void)write_cloud(file, cloud);
  const double megabytes = static_cast<double>(fs::file_size(file)) / 1e6;
  const Seconds read = seconds_of([&] { (void)deburr::read_cloud(file); });
  Seconds write;
  {
    const PointCloud again = deburr::read_cloud(file);
    write = seconds_of([&] { (void)write_cloud(copy, again); });
  }
  const Seconds to_file = cat("cat ", file, " > " + copy.string());
  const Seconds to_pipe = cat("cat ", file, " | cat > /dev/null");
  print(name, "read", megabytes, read, to_file, to_pipe);
  print(name, "write", megabytes, write, to_file, to_pipe);
  fs::remove(file);
  fs::remove(copy);
}

void run_all(std::size_t points, const fs::path& folder) {
  std::printf("%zu points in %s; MB/s, best of %d\n", points, folder.c_str(), repeats);
  std::printf("%-28s | %-34s | %s\n", "", "by seconds of a processor", "by elapsed seconds");
  for (const char* head : {"                          MB", " |     we  cat >  cat |  ratio  ratio",
                           " |     we  cat >  cat |  ratio  ratio\n"}) {
    std::printf("%s", head);
  }
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
