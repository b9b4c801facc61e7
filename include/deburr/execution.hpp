// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace deburr {

/// How far a computation has come.
struct Progress {
  std::string_view stage;  ///< what is being done, e.g. "rounds"
  double fraction = 0;     ///< of the whole call, in [0, 1], never decreasing
};

/// How to run a computation. Nothing in here can change its result.
struct Execution {
  /// Number of threads, 0 to 256; 0 uses every core that the process may run on.
  int threads = 0;
  /// Called on the caller's thread between steps of the work, while other threads are at it; may
  /// throw to stop it. Must not begin work of oneTBB, whose waits would take up that of here.
  std::function<void(const Progress&)> progress{};
  /// Asked often, several times in a tenth of a second for a million points, and from several
  /// threads at once; true stops the work, which throws Cancelled.
  std::function<bool()> cancelled{};
  /// Monotonic seconds, for the times in a report. Without it they stay 0: the library itself
  /// never reads a clock.
  std::function<double()> clock{};
  /// Points that a thread takes at a time, between two looks at `cancelled`; 0 for what suits most
  /// machines. Where a point is more work than usual, fewer are taken in proportion.
  std::size_t block = 0;
};

}  // namespace deburr
