// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <string_view>
#include <tuple>

#include "arrays.hpp"
#include "bind.hpp"
#include "deburr/features.hpp"
#include "deburr/normal_filter.hpp"
#include "deburr/normals.hpp"
#include "deburr/orientation.hpp"
#include "deburr/position_update.hpp"
#include "run.hpp"
#include "words.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

constexpr Choice<Voteless> voteless_words[] = {{"keep", Voteless::Keep}, {"zero", Voteless::Zero}};
constexpr Choice<Offset> offsets[] = {{"projected", Offset::Projected},
                                      {"symmetric", Offset::Symmetric}};
constexpr Choice<Quadric> quadrics[] = {{"plain", Quadric::Plain}, {"guarded", Quadric::Guarded}};
constexpr Choice<Bound> bounds[] = {{"reject", Bound::Reject}, {"clamp", Bound::Clamp}};

using Update = std::tuple<double, double, double, double, double, std::string_view,
                          std::string_view, std::string_view>;
using Classes = std::tuple<double, double, double>;

PositionUpdateOptions parse_update(const Update& values) {
  const auto& [position_scale, normal_scale, step, feature_step, max_move, offset, quadric, bound] =
      values;
  return {position_scale,
          normal_scale,
          step,
          feature_step,
          max_move,
          parse_word("offset", offset, offsets),
          parse_word("quadric", quadric, quadrics),
          parse_word("bound", bound, bounds)};
}

FeatureOptions parse_classes(const Classes& values) {
  return {std::get<0>(values), std::get<1>(values), std::get<2>(values)};
}

FeatureField make_field(const ValueArray<std::uint8_t>& label, const VectorArray& direction) {
  const auto labels = as_features(label);
  const Points directions = as_span(direction);
  return {{labels.begin(), labels.end()}, {directions.begin(), directions.end()}};
}

nb::tuple to_python(FeatureField field) {
  return nb::make_tuple(to_array(std::move(field.label)), to_array(std::move(field.direction)));
}

nb::tuple sweep(const VectorArray& original, const VectorArray& points, const VectorArray& normals,
                const Neighborhoods& neighborhoods, const Classes& classes, const Update& update,
                const nb::object& order, int threads) {
  const FeatureOptions features = parse_classes(classes);
  const PositionUpdateOptions options = parse_update(update);
  const Points before = as_span(points);
  std::vector<Vec3> moved(before.begin(), before.end());
  FeatureField field;
  if (order.is_none()) {
    field = run(threads, nb::none(), [&](const Execution& execution) {
      return sweep_at_once(as_span(original), moved, as_span(normals), neighborhoods, features,
                           options, execution);
    });
  } else {
    const auto indices = nb::cast<ValueArray<std::uint32_t>>(order);
    field = run(threads, nb::none(), [&](const Execution& execution) {
      return sweep_in_place(as_span(original), moved, as_span(normals), neighborhoods, features,
                            options, as_span(indices), execution);
    });
  }
  return nb::make_tuple(to_array(std::move(moved)), to_python(std::move(field)));
}

void bind_normals(nb::module_& m) {
  m.def(
      "estimate_normals",
      [](const VectorArray& points, const Neighborhoods& neighborhoods, int threads) {
        return to_array(run(threads, nb::none(), [&](const Execution& execution) {
          return estimate_normals(as_span(points), neighborhoods, execution);
        }));
      },
      "points"_a, "neighborhoods"_a, "threads"_a);
  m.def(
      "refit_normals",
      [](const VectorArray& points, const VectorArray& normals, const Neighborhoods& neighborhoods,
         double position_scale, double normal_scale, double blend, int threads) {
        return to_array(run(threads, nb::none(), [&](const Execution& execution) {
          return refit_normals(as_span(points), as_span(normals), neighborhoods,
                               {position_scale, normal_scale, blend}, execution);
        }));
      },
      "points"_a, "normals"_a, "neighborhoods"_a, "position_scale"_a, "normal_scale"_a, "blend"_a,
      "threads"_a);
  m.def(
      "orient_normals",
      [](const VectorArray& points, const VectorArray& normals, const Neighborhoods& neighborhoods,
         int threads) {
        return to_array(run(threads, nb::none(), [&](const Execution& execution) {
          return orient_normals(as_span(points), as_span(normals), neighborhoods, execution);
        }));
      },
      "points"_a, "normals"_a, "neighborhoods"_a, "threads"_a);
  m.def(
      "filter_normals",
      [](const VectorArray& normals, const Neighborhoods& neighborhoods, double rho, double tau,
         double damping, double eigen_tolerance, std::string_view voteless, int threads) {
        const Voteless rest = parse_word("voteless", voteless, voteless_words);
        return to_array(run(threads, nb::none(), [&](const Execution& execution) {
          return filter_normals(as_span(normals), neighborhoods,
                                {rho, tau, damping, eigen_tolerance}, rest, execution);
        }));
      },
      "normals"_a, "neighborhoods"_a, "rho"_a, "tau"_a, "damping"_a, "eigen_tolerance"_a,
      "voteless"_a, "threads"_a);
}

/// The defaults of the structs, by the name of the function that takes them.
nb::dict stage_defaults() {
  const NormalRefitOptions refit;
  const NormalFilterOptions filter;
  const FeatureOptions features;
  const PositionUpdateOptions update;
  nb::dict refit_normals;
  refit_normals["normal_scale"] = refit.normal_scale;
  refit_normals["blend"] = refit.blend;
  nb::dict filter_normals;
  filter_normals["rho"] = filter.rho;
  filter_normals["tau"] = filter.tau;
  filter_normals["damping"] = filter.damping;
  filter_normals["eigen_tolerance"] = filter.eigen_tolerance;
  nb::dict classify_features;
  classify_features["rho"] = features.rho;
  classify_features["tau"] = features.tau;
  classify_features["eigen_tolerance"] = features.eigen_tolerance;
  nb::dict update_positions;
  update_positions["normal_scale"] = update.normal_scale;
  update_positions["step"] = update.step;
  update_positions["feature_step"] = update.feature_step;
  update_positions["max_move"] = update.max_move;
  update_positions["offset"] = word_for(offsets, update.offset);
  update_positions["quadric"] = word_for(quadrics, update.quadric);
  update_positions["bound"] = word_for(bounds, update.bound);
  nb::dict all;
  all["refit_normals"] = refit_normals;
  all["filter_normals"] = filter_normals;
  all["classify_features"] = classify_features;
  all["update_positions"] = update_positions;
  return all;
}

}  // namespace

void bind_stages(nb::module_& m) {
  bind_normals(m);
  m.def(
      "classify_features",
      [](const VectorArray& points, const VectorArray& normals, const Neighborhoods& neighborhoods,
         const Classes& options, int threads) {
        return to_python(run(threads, nb::none(), [&](const Execution& execution) {
          return classify_features(as_span(points), as_span(normals), neighborhoods,
                                   parse_classes(options), execution);
        }));
      },
      "points"_a, "normals"_a, "neighborhoods"_a, "options"_a, "threads"_a);
  m.def(
      "update_positions",
      [](const VectorArray& original, const VectorArray& points, const VectorArray& normals,
         const ValueArray<std::uint8_t>& label, const VectorArray& direction,
         const Neighborhoods& neighborhoods, const Update& update, int threads) {
        const PositionUpdateOptions options = parse_update(update);
        return to_array(run(threads, nb::none(), [&](const Execution& execution) {
          return update_positions(as_span(original), as_span(points), as_span(normals),
                                  make_field(label, direction), neighborhoods, options, execution);
        }));
      },
      "original"_a, "points"_a, "normals"_a, "label"_a, "direction"_a, "neighborhoods"_a,
      "options"_a, "threads"_a);
  m.def("sweep", sweep, "original"_a, "points"_a, "normals"_a, "neighborhoods"_a, "features"_a,
        "update"_a, "order"_a.none(), "threads"_a);
  m.def("stage_defaults", stage_defaults);
}

}  // namespace deburr::python
