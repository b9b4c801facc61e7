// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include "deburr/error.hpp"
#include "deburr/execution.hpp"

namespace deburr::python {

namespace nb = nanobind;

/// Looks for Ctrl-C while the library works without the GIL. Only Python's main thread sees
/// signals, and only if it asks.
class Interrupt {
 public:
  /// Whether to stop; called from any thread. The caller's takes the GIL now and then to ask.
  [[nodiscard]] bool poll();
  /// Throws what the signal handler raised, if one did; call it with the GIL.
  void rethrow();

 private:
  std::thread::id caller_ = std::this_thread::get_id();
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
  std::atomic<bool> stopped_{false};
  std::optional<nb::python_error> error_;
};

/// An Execution that calls `on_progress(stage, fraction)` with the GIL, unless it is None.
[[nodiscard]] Execution make_execution(int threads, const nb::object& on_progress,
                                       Interrupt& interrupt);

/// Runs `work(execution)` without the GIL. What `on_progress` or a signal handler raises stops it
/// and is raised.
template <typename Work>
auto run(int threads, const nb::object& on_progress, const Work& work) {
  Interrupt interrupt;
  const Execution execution = make_execution(threads, on_progress, interrupt);
  try {
    const nb::gil_scoped_release released;
    return work(execution);
  } catch (const Cancelled&) {
    interrupt.rethrow();
    throw;
  }
}

}  // namespace deburr::python
