// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <string>

namespace deburr::python {
namespace {

/// A person does not notice, and taking the GIL so seldom costs nothing.
constexpr std::chrono::milliseconds between_looks{50};

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

bool Interrupt::poll() {
  if (stopped_.load(std::memory_order_relaxed)) return true;
  if (std::this_thread::get_id() != caller_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return false;
  next_ = now + between_looks;
  const nb::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() == 0) return false;
  error_.emplace();  // takes what the handler raised
  stopped_.store(true, std::memory_order_relaxed);
  return true;
}

void Interrupt::rethrow() {
  if (error_) throw nb::python_error(std::move(*error_));
}

Execution make_execution(int threads, const nb::object& on_progress, Interrupt& interrupt) {
  Execution execution{.threads = threads,
                      .cancelled = [&interrupt] { return interrupt.poll(); },
                      .clock = steady_seconds};
  if (!on_progress.is_none()) {
    execution.progress = [&on_progress](const Progress& progress) {
      const nb::gil_scoped_acquire gil;
      on_progress(nb::str(progress.stage.data(), progress.stage.size()), progress.fraction);
    };
  }
  return execution;
}

}  // namespace deburr::python
