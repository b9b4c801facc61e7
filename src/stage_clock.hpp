// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "deburr/denoise.hpp"

namespace deburr {

/// Adds up the seconds of every stage, by the clock of the caller.
class StageClock {
 public:
  explicit StageClock(const Execution& execution) : execution_(execution) {}

  /// Returns work(), whose time counts for `stage`.
  template <typename Work>
  auto time(std::string_view stage, const Work& work) {
    const double start = now();
    auto result = work();
    entry(stage).seconds += now() - start;
    return result;
  }

  [[nodiscard]] std::vector<StageTime> times() && { return std::move(times_); }

 private:
  [[nodiscard]] double now() const { return execution_.clock ? execution_.clock() : 0; }

  StageTime& entry(std::string_view stage) {
    const auto found = std::find_if(times_.begin(), times_.end(),
                                    [&](const StageTime& t) { return t.stage == stage; });
    return found != times_.end() ? *found : times_.emplace_back(StageTime{stage, 0});
  }

  const Execution& execution_;
  std::vector<StageTime> times_;
};

}  // namespace deburr
