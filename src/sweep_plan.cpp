// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sweep_plan.hpp"

#include <algorithm>

#include "lanes.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

/// Points that are looked at together, as long as one of them can go: what they read fits into the
/// cache of a core, and they reach far beyond the neighbourhood of one.
constexpr std::uint32_t tile_size = 4096;

class Planner {
 public:
  Planner(const Neighborhoods& neighborhoods, std::span<const std::uint32_t> order,
          const Execution& execution)
      : neighborhoods_(neighborhoods),
        execution_(execution),
        rank_(order.size()),
        waits_for_(order.size()),
        ready_(order.size() / tile_size + 1) {
    for (std::uint32_t at = 0; at < order.size(); ++at) rank_[order[at]] = at;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      if (i % block_size == 0) check_cancelled(execution_);
      for (const std::uint32_t j : neighborhoods_[i]) waits_for_[i] += rank_[j] < rank_[i] ? 1 : 0;
    }
    // In the given order, so that the first ones go first.
    for (const std::uint32_t i : order) {
      if (waits_for_[i] == 0) make_ready(i);
    }
    plan_.order.reserve(order.size());
  }

  SweepPlan run() {
    while (plan_.order.size() < rank_.size()) {
      const std::size_t before = plan_.order.size();
      for (Ready& ready : ready_) {
        check_cancelled(execution_);
        while (ready.points.size() - ready.gone >= lane_count) go(ready);
      }
      // Where no tile has a full batch, smaller ones must do.
      if (plan_.order.size() > before) continue;
      for (Ready& ready : ready_) {
        if (ready.points.size() > ready.gone) go(ready);
      }
    }
    return std::move(plan_);
  }

 private:
  /// Points of a tile that wait for none, the first `gone` of which have been planned.
  struct Ready {
    std::vector<std::uint32_t> points;
    std::size_t gone = 0;
  };

  void make_ready(std::uint32_t i) { ready_[i / tile_size].points.push_back(i); }

  /// Plans a batch. Points that are ready at the same time are no neighbours: else one would wait.
  void go(Ready& ready) {
    const std::size_t from = plan_.order.size();
    const std::size_t count = std::min(lane_count, ready.points.size() - ready.gone);
    for (std::size_t l = 0; l < count; ++l) plan_.order.push_back(ready.points[ready.gone++]);
    plan_.ends.push_back(static_cast<std::uint32_t>(plan_.order.size()));
    for (std::size_t at = from; at < from + count; ++at) {
      const std::uint32_t i = plan_.order[at];
      for (const std::uint32_t j : neighborhoods_[i]) {
        if (rank_[j] > rank_[i] && --waits_for_[j] == 0) make_ready(j);
      }
    }
  }

  const Neighborhoods& neighborhoods_;
  const Execution& execution_;
  std::vector<std::uint32_t> rank_;       ///< of each point in the given order
  std::vector<std::uint32_t> waits_for_;  ///< number of neighbours of lower rank that have to go
  std::vector<Ready> ready_;              ///< by tile
  SweepPlan plan_;
};

/// The neighbourhoods of points in another order.
Neighborhoods reorder(const Neighborhoods& neighborhoods, std::span<const std::uint32_t> order) {
  std::vector<std::size_t> offsets{0};
  offsets.reserve(order.size() + 1);
  std::vector<std::uint32_t> indices;
  indices.reserve(neighborhoods.pair_count());
  for (const std::uint32_t i : order) {
    indices.insert(indices.end(), neighborhoods[i].begin(), neighborhoods[i].end());
    offsets.push_back(indices.size());
  }
  return {std::move(offsets), std::move(indices)};
}

}  // namespace

SweepPlan plan_sweep(const Neighborhoods& neighborhoods, std::span<const std::uint32_t> order,
                     const Execution& execution) {
  SweepPlan plan = Planner(neighborhoods, order, execution).run();
  plan.neighborhoods = reorder(neighborhoods, plan.order);
  return plan;
}

}  // namespace deburr
