// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "deburr/deburr.hpp"

// The stages of the library, each on its own, on the synthetic part.

namespace {

using benchmark::State;

constexpr std::size_t normal_neighbors = 30;
constexpr std::size_t most_neighbors = 256;

// In mean distances to the 12 nearest points.
constexpr double radius = 3.5;
constexpr double position_scale = 1.5;
constexpr double max_move = 2;

/// What the stages take from each other, made once for each size.
struct Input {
  explicit Input(std::size_t count)
      : points(deburr::synthesize_part({.points = count}).cloud.points),
        nearest(deburr::find_neighbors(points, {.max_count = normal_neighbors})),
        spacing(deburr::mean_neighbor_distance(points,
                                               deburr::find_neighbors(points, {.max_count = 12}))),
        neighborhoods(deburr::find_neighbors(points, around())),
        normals(deburr::orient_normals(points, deburr::estimate_normals(points, nearest), nearest)),
        features(deburr::classify_features(points, normals, neighborhoods)) {}

  [[nodiscard]] deburr::NeighborOptions around() const {
    return {.max_count = most_neighbors, .radius = radius * spacing};
  }

  std::vector<deburr::Vec3> points;
  deburr::Neighborhoods nearest;
  double spacing;
  deburr::Neighborhoods neighborhoods;
  std::vector<deburr::Vec3> normals;
  deburr::FeatureField features;
};

const Input& input(const State& state) {
  static const Input small(10'000);
  static const Input large(100'000);
  return state.range(0) == 10'000 ? small : large;
}

template <typename Stage>
void measure(State& state, const Stage& stage) {
  const Input& in = input(state);
  for (auto _ : state) benchmark::DoNotOptimize(stage(in));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void neighbors(State& state) {
  measure(state, [](const Input& in) { return deburr::find_neighbors(in.points, in.around()); });
}

void normals(State& state) {
  measure(state, [](const Input& in) { return deburr::estimate_normals(in.points, in.nearest); });
}

void orientation(State& state) {
  measure(state, [](const Input& in) {
    return deburr::orient_normals(in.points, in.normals, in.nearest);
  });
}

void normal_refit(State& state) {
  measure(state, [](const Input& in) {
    return deburr::refit_normals(in.points, in.normals, in.neighborhoods,
                                 {.position_scale = position_scale * in.spacing});
  });
}

void normal_filter(State& state) {
  measure(state,
          [](const Input& in) { return deburr::filter_normals(in.normals, in.neighborhoods); });
}

void features(State& state) {
  measure(state, [](const Input& in) {
    return deburr::classify_features(in.points, in.normals, in.neighborhoods);
  });
}

void positions(State& state) {
  measure(state, [](const Input& in) {
    return deburr::update_positions(
        in.points, in.points, in.normals, in.features, in.neighborhoods,
        {.position_scale = position_scale * in.spacing, .max_move = max_move * in.spacing});
  });
}

struct Stage {
  const char* name;
  void (*run)(State& state);
};

constexpr Stage stages[] = {{"neighbors", neighbors},         {"normals", normals},
                            {"orientation", orientation},     {"normal_refit", normal_refit},
                            {"normal_filter", normal_filter}, {"features", features},
                            {"positions", positions}};

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::AddCustomContext("cpu", cpu_model());
  benchmark::AddCustomContext("compiler", DEBURR_COMPILER);
  benchmark::AddCustomContext("flags", DEBURR_FLAGS);
  for (const auto& [name, stage] : stages) {
    benchmark::RegisterBenchmark(name, stage)
        ->Arg(10'000)
        ->Arg(100'000)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
