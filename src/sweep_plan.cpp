// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sweep_plan.hpp"

#include <algorithm>

#include "lanes.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

class Planner {
 public:
  Planner(const NearLists& lists, std::span<const std::uint32_t> order, const Execution& execution)
      : lists_(lists),
        execution_(execution),
        states_(order.size()),
        ready_(order.size() / lists.block() + 1) {
    for (std::uint32_t at = 0; at < order.size(); ++at) states_[order[at]].rank = at;
    parallel_blocks(order.size(), execution, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> buffer;
      for (std::size_t i = begin; i < end; ++i) {
        for (const std::uint32_t j : lists_.read(i, buffer)) {
          states_[i].waits_for += states_[j].rank < states_[i].rank ? 1 : 0;
        }
      }
    });
    // In the given order, so that the first ones go first.
    for (const std::uint32_t i : order) {
      if (states_[i].waits_for == 0) make_ready(i);
    }
    plan_.order.reserve(order.size());
  }

  SweepPlan run() {
    while (plan_.order.size() < states_.size()) {
      const std::size_t before = plan_.order.size();
      for (Ready& ready : ready_) {
        while (ready.points.size() - ready.gone >= lane_count) go(ready);
      }
      // Where no block has a full batch, smaller ones must do.
      if (plan_.order.size() > before) continue;
      for (Ready& ready : ready_) {
        if (ready.points.size() > ready.gone) go(ready);
      }
    }
    return std::move(plan_);
  }

 private:
  /// Points of a block that wait for none, the first `gone` of which have been planned.
  struct Ready {
    std::vector<std::uint32_t> points;
    std::size_t gone = 0;
  };

  struct State {
    std::uint32_t rank = 0;       ///< in the given order
    std::uint32_t waits_for = 0;  ///< number of neighbours of lower rank that have to go
  };

  void make_ready(std::uint32_t i) { ready_[i / lists_.block()].points.push_back(i); }

  /// Plans a batch. Points that are ready at the same time are no neighbours: else one would wait.
  void go(Ready& ready) {
    check_cancelled(execution_);
    const std::size_t from = plan_.order.size();
    const std::size_t count = std::min(lane_count, ready.points.size() - ready.gone);
    for (std::size_t l = 0; l < count; ++l) plan_.order.push_back(ready.points[ready.gone++]);
    plan_.ends.push_back(static_cast<std::uint32_t>(plan_.order.size()));
    for (std::size_t at = from; at < from + count; ++at) {
      const std::uint32_t i = plan_.order[at];
      const std::uint32_t rank = states_[i].rank;
      for (const std::uint32_t j : lists_.read(i, buffer_)) {
        State& other = states_[j];
        // Without a branch: a wrong guess would have to wait for memory, every other time.
        const bool later = other.rank > rank;
        other.waits_for -= later ? 1 : 0;
        if (static_cast<int>(later) & static_cast<int>(other.waits_for == 0)) make_ready(j);
      }
    }
  }

  const NearLists& lists_;
  const Execution& execution_;
  std::vector<State> states_;
  std::vector<Ready> ready_;  ///< by block
  std::vector<std::uint32_t> buffer_;
  SweepPlan plan_;
};

}  // namespace

SweepPlan plan_sweep(const NearLists& lists, std::span<const std::uint32_t> order,
                     const Execution& execution) {
  return Planner(lists, order, execution).run();
}

}  // namespace deburr
