// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "arrays.hpp"
#include "bind.hpp"
#include "deburr/synth.hpp"
#include "run.hpp"
#include "sizes.hpp"
#include "words.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

constexpr Choice<Shape> shapes[] = {{"part", Shape::Part},
                                    {"cube", Shape::Cube},
                                    {"sphere", Shape::Sphere},
                                    {"torus", Shape::Torus},
                                    {"cylinder", Shape::Cylinder},
                                    {"thin-plate", Shape::ThinPlate},
                                    {"bumpy-sheet", Shape::BumpySheet},
                                    {"stepped-wall", Shape::SteppedWall}};
constexpr Choice<NoiseUnit> noise_units[] = {{"diagonal", NoiseUnit::Diagonal},
                                             {"spacing", NoiseUnit::Spacing}};
constexpr Choice<NoiseKind> noise_kinds[] = {{"isotropic", NoiseKind::Isotropic},
                                             {"normal", NoiseKind::Normal},
                                             {"impulsive", NoiseKind::Impulsive},
                                             {"ray", NoiseKind::Ray}};
constexpr Choice<Sampling> samplings[] = {
    {"uniform", Sampling::Uniform}, {"poisson", Sampling::Poisson}, {"scanner", Sampling::Scanner}};

SynthOptions parse_options(const nb::dict& words) {
  const auto word = [&](const char* name) { return nb::cast<std::string>(words[name]); };
  const auto real = [&](const char* name) { return nb::cast<double>(words[name]); };
  const auto size = [&](const char* name) {
    return to_size(name, nb::cast<std::int64_t>(words[name]));
  };
  SynthOptions options;
  options.points = size("points");
  options.noise = real("noise");
  options.noise_unit = parse_word("noise_unit", word("noise_unit"), noise_units);
  options.noise_kind = parse_word("noise_kind", word("noise_kind"), noise_kinds);
  options.sampling = parse_word("sampling", word("sampling"), samplings);
  options.outliers = real("outliers");
  options.cluster_outliers = real("cluster_outliers");
  options.seed = nb::cast<std::uint64_t>(words["seed"]);
  options.shape.thickness = real("thickness");
  return options;
}

nb::dict option_words(const SynthOptions& options) {
  nb::dict words;
  words["points"] = options.points;
  words["noise"] = options.noise;
  words["noise_unit"] = word_for(noise_units, options.noise_unit);
  words["noise_kind"] = word_for(noise_kinds, options.noise_kind);
  words["sampling"] = word_for(samplings, options.sampling);
  words["outliers"] = options.outliers;
  words["cluster_outliers"] = options.cluster_outliers;
  words["seed"] = options.seed;
  words["thickness"] = options.shape.thickness;
  return words;
}

nb::dict to_python(SyntheticScan scan) {
  nb::dict arrays;
  arrays["points"] = to_array(std::move(scan.cloud.points));
  arrays["truth"] = mesh_to_python(std::move(scan.truth));
  arrays["clean"] = to_array(std::move(scan.clean));
  arrays["normals"] = to_array(std::move(scan.normals));
  arrays["outlier"] = to_array(std::move(scan.outlier));
  arrays["sigma"] = scan.sigma;
  arrays["spacing"] = scan.spacing;
  return arrays;
}

}  // namespace

void bind_synth(nb::module_& m) {
  m.def(
      "synthesize",
      [](std::string_view shape, const nb::dict& words, int threads,
         const nb::object& on_progress) {
        const Shape which = parse_word("shape", shape, shapes);
        const SynthOptions options = parse_options(words);
        return to_python(run(threads, on_progress, [&](const Execution& execution) {
          return synthesize(which, options, execution);
        }));
      },
      "shape"_a, "options"_a, "threads"_a, "on_progress"_a.none());
  m.def(
      "synthesize_mesh",
      [](const VectorArray& vertices, const TriangleArray& triangles, const nb::dict& words,
         int threads, const nb::object& on_progress) {
        const SynthOptions options = parse_options(words);
        return to_python(run(threads, on_progress, [&](const Execution& execution) {
          return synthesize(make_mesh(vertices, triangles), options, execution);
        }));
      },
      "vertices"_a, "triangles"_a, "options"_a, "threads"_a, "on_progress"_a.none());
  m.def(
      "shape_mesh",
      [](std::string_view shape, double thickness) {
        return mesh_to_python(shape_mesh(parse_word("shape", shape, shapes), {thickness}));
      },
      "shape"_a, "thickness"_a);
  m.def("synth_defaults", [] { return option_words({}); });
}

}  // namespace deburr::python
