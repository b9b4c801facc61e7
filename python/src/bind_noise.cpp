// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"
#include "bind.hpp"
#include "deburr/noise.hpp"
#include "deburr/outliers.hpp"
#include "run.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

nb::tuple to_python(const NoiseEstimate& estimate) {
  return nb::make_tuple(estimate.sigma, estimate.spacing, estimate.reach, estimate.gap);
}

}  // namespace

void bind_noise(nb::module_& m) {
  m.def(
      "measure_noise",
      [](const VectorArray& points, int threads) {
        return to_python(run(threads, nb::none(), [&](const Execution& execution) {
          return measure_noise(as_span(points), execution);
        }));
      },
      "points"_a, "threads"_a);
  m.def(
      "estimate_local_noise",
      [](const VectorArray& points, int threads) {
        LocalNoise noise = run(threads, nb::none(), [&](const Execution& execution) {
          return estimate_local_noise(as_span(points), execution);
        });
        return nb::make_tuple(to_python(noise.overall), to_array(std::move(noise.sigma)),
                              to_array(std::move(noise.spacing)));
      },
      "points"_a, "threads"_a);
  m.def(
      "find_outliers",
      [](const VectorArray& points, double tolerance, int threads, const nb::object& on_progress) {
        return to_array(run(threads, on_progress, [&](const Execution& execution) {
          return find_outliers(as_span(points), {tolerance}, execution);
        }));
      },
      "points"_a, "tolerance"_a, "threads"_a, "on_progress"_a.none());
  m.def("find_outliers_defaults", [] {
    nb::dict values;
    values["tolerance"] = OutlierOptions{}.tolerance;
    return values;
  });
}

}  // namespace deburr::python
