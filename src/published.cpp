// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "published.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "deburr/normals.hpp"
#include "deburr/orientation.hpp"
#include "parallel.hpp"
#include "sweep.hpp"

namespace deburr {
namespace {

/// Share of the progress that is told before the rounds begin.
constexpr double prepared = 0.15;

RoundReport measure(Points before, Points after, const WorkingSet& set,
                    const Execution& execution) {
  CancelWatch watch(execution);
  double squares = 0;
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    watch();
    const double squared = squared_norm(after[i] - before[i]);
    squares += squared;
    largest = std::max(largest, squared);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, before.size()));
  return {set.length(std::sqrt(squares / count)), set.length(std::sqrt(largest))};
}

std::vector<Vec3> first_normals(Points points, const Neighborhoods& nearest,
                                const Execution& execution) {
  return orient_normals(
      points, estimate_normals(points, nearest, sub_execution(execution, "normals", 0, 0.5)),
      nearest, execution);
}

/// Points of a block of lists.
std::uint32_t list_block(const Execution& execution) {
  constexpr std::size_t most = std::size_t{1} << 20;
  if (execution.block == 0) return NearLists::usual_block;
  return static_cast<std::uint32_t>(std::min(execution.block, most));
}

}  // namespace

void run_published(Neighborhoods nearest, const Schedule& schedule, const WorkingSet& set,
                   bool keep_normals, State& state, Report& report, StageClock& clock,
                   const Execution& execution) {
  state.normals = clock.time("first normals", [&] {
    return keep_normals ? set.normals
                        : first_normals(set.points, nearest,
                                        sub_execution(execution, "normals", 0, prepared));
  });
  nearest = {};  // their memory is wanted for more of them
  NearLists lists;
  SweepPlan plan;
  // Kept from round to round: new memory takes long, and one thread alone can take it.
  NextNormals next{.filter = schedule.normal_filter, .normals = {}};
  std::vector<Vec3> moved;
  // The filter of a round compares the neighbours as the movement of the round before does.
  const bool fused = !schedule.rebuild;
  for (int round = 0; round < schedule.rounds; ++round) {
    const Execution part =
        sub_execution(execution, "rounds", prepared + (1 - prepared) * round / schedule.rounds,
                      prepared + (1 - prepared) * (round + 1) / schedule.rounds);
    const Execution quiet = without_progress(part);
    if (round == 0 || schedule.rebuild) {
      clock.time("neighbourhoods", [&] {
        lists = {};
        lists = NearLists(state.points, schedule.neighbors.radius, list_block(execution), quiet);
        return 0;
      });
    }
    if (round == 0 || !fused) {
      state.normals = clock.time("normal filter", [&] {
        return filter_normals(state.normals, lists, schedule.normal_filter,
                              round == 0 ? schedule.voteless_at_first : Voteless::Keep, quiet);
      });
    }
    // Within a radius neighbours are mutual.
    if (schedule.in_place && (round == 0 || schedule.rebuild)) {
      clock.time("neighbourhoods", [&] {
        plan = plan_sweep(lists, set.sweep, quiet);
        lists.arrange(plan.order, quiet);
        return 0;
      });
    }
    const bool last = round + 1 == schedule.rounds;
    NextNormals* const wanted = fused && !last ? &next : nullptr;
    moved.resize(state.points.size());
    if (schedule.in_place) std::ranges::copy(state.points, moved.begin());
    state.labels = clock.time("features and positions", [&] {
      return schedule.in_place
                 ? sweep_along(plan, set.points, moved, state.normals, lists, schedule.features,
                               schedule.update, wanted, part)
                 : sweep_together(set.points, state.points, state.normals, lists, schedule.features,
                                  schedule.update, moved, wanted, part);
    });
    if (wanted != nullptr) std::swap(state.normals, next.normals);
    report.rounds.push_back(measure(state.points, moved, set, quiet));
    std::swap(state.points, moved);
  }
}

}  // namespace deburr
