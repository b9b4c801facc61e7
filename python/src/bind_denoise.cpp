// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "arrays.hpp"
#include "bind.hpp"
#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "run.hpp"
#include "sizes.hpp"
#include "words.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

constexpr Choice<Method> methods[] = {{"auto", Method::Auto}, {"yadav2018", Method::Yadav2018}};
constexpr Choice<NormalSource> normal_sources[] = {{"auto", NormalSource::Auto},
                                                   {"keep", NormalSource::Keep},
                                                   {"estimate", NormalSource::Estimate}};
constexpr Choice<OutlierAction> outlier_actions[] = {{"label", OutlierAction::Label},
                                                     {"remove", OutlierAction::Remove},
                                                     {"keep", OutlierAction::Keep}};
constexpr Choice<bool> rebuilds[] = {{"once", false}, {"per-round", true}};
constexpr Choice<bool> updates[] = {{"in-place", true}, {"simultaneous", false}};

/// The attribute that tells which points are left where some are removed.
constexpr const char* index_name = "index";

DenoiseOptions parse_options(const nb::dict& words) {
  const auto word = [&](const char* name) { return nb::cast<std::string>(words[name]); };
  const auto real = [&](const char* name) { return nb::cast<double>(words[name]); };
  const auto whole = [&](const char* name) { return nb::cast<int>(words[name]); };
  DenoiseOptions options;
  options.method = parse_word("method", word("method"), methods);
  options.normals = parse_word("normals", word("normals"), normal_sources);
  options.automatic = {.strength = whole("strength"),
                       .noise = real("noise"),
                       .max_move = real("max_move"),
                       .outliers = parse_word("outliers", word("outliers"), outlier_actions)};
  options.yadav2018 = {.k = to_size("k", nb::cast<std::int64_t>(words["k"])),
                       .rounds = whole("rounds"),
                       .rho = real("rho"),
                       .tau = real("tau"),
                       .damping = real("damping"),
                       .alpha = real("alpha"),
                       .epsilon = real("epsilon"),
                       .radius = real("radius"),
                       .rebuild = parse_word("neighborhoods", word("neighborhoods"), rebuilds),
                       .in_place = parse_word("update", word("update"), updates)};
  return options;
}

nb::dict option_words(const DenoiseOptions& options) {
  const AutoOptions& a = options.automatic;
  const Yadav2018Options& y = options.yadav2018;
  nb::dict words;
  words["method"] = word_for(methods, options.method);
  words["normals"] = word_for(normal_sources, options.normals);
  words["strength"] = a.strength;
  words["noise"] = a.noise;
  words["max_move"] = a.max_move;
  words["outliers"] = word_for(outlier_actions, a.outliers);
  words["k"] = y.k;
  words["rounds"] = y.rounds;
  words["rho"] = y.rho;
  words["tau"] = y.tau;
  words["damping"] = y.damping;
  words["alpha"] = y.alpha;
  words["epsilon"] = y.epsilon;
  words["radius"] = y.radius;
  words["neighborhoods"] = word_for(rebuilds, y.rebuild);
  words["update"] = word_for(updates, y.in_place);
  return words;
}

nb::dict report_to_python(const Report& report) {
  nb::dict labels;
  for (std::size_t i = 0; i < report.labels.size(); ++i) {
    const std::string_view name = to_string(static_cast<Feature>(i));
    labels[nb::str(name.data(), name.size())] = report.labels[i];
  }
  nb::list rounds;
  for (const RoundReport& round : report.rounds) {
    rounds.append(nb::make_tuple(round.rms_move, round.max_move));
  }
  nb::list stages;
  for (const StageTime& stage : report.stages) {
    stages.append(nb::make_tuple(nb::str(stage.stage.data(), stage.stage.size()), stage.seconds));
  }
  nb::dict result;
  result["points"] = report.points;
  result["non_finite"] = report.non_finite;
  result["duplicates"] = report.duplicates;
  result["outliers"] = report.outliers;
  result["kept"] = report.kept;
  result["spacing"] = report.spacing;
  result["noise"] = report.noise;
  result["max_move"] = report.max_move;
  result["kept_normals"] = report.kept_normals;
  result["labels"] = labels;
  result["rounds"] = rounds;
  result["stages"] = stages;
  return result;
}

nb::dict denoise_arrays(const AnyVectorArray& points, const std::optional<AnyVectorArray>& normals,
                        const nb::dict& words, int threads, const nb::object& on_progress) {
  const DenoiseOptions options = parse_options(words);
  const bool remove = options.automatic.outliers == OutlierAction::Remove;
  DenoiseResult result = run(threads, on_progress, [&](const Execution& execution) {
    PointCloud cloud;
    cloud.points = copy_vectors(points);
    if (normals) cloud.normals = copy_vectors(*normals);
    if (remove) {
      std::vector<std::uint64_t> indices(cloud.size());
      std::iota(indices.begin(), indices.end(), 0);
      cloud.attributes.push_back({index_name, std::move(indices), {}});
    }
    return denoise(std::move(cloud), options, execution);
  });
  // Asked of the library, so that the limit stands in one place.
  result.cloud.layout.fields = {
      {"x", ScalarType::Float32}, {"y", ScalarType::Float32}, {"z", ScalarType::Float32}};
  nb::dict arrays;
  arrays["fits_float32"] = is_float32(points) && doubts_about(result.cloud).empty();
  arrays["kept"] = nb::none();
  if (remove) {
    Values& values = result.cloud.attributes.front().values;
    arrays["kept"] = to_array(std::get<std::vector<std::uint64_t>>(std::move(values)));
  }
  arrays["points"] = to_array(std::move(result.cloud.points));
  arrays["normals"] = to_array(std::move(result.cloud.normals));
  arrays["labels"] = to_array(std::move(result.labels));
  arrays["outliers"] = to_array(std::move(result.outliers));
  arrays["displacement"] = to_array(std::move(result.displacement));
  arrays["report"] = report_to_python(result.report);
  return arrays;
}

}  // namespace

void bind_denoise(nb::module_& m) {
  m.def("denoise", denoise_arrays, "points"_a, "normals"_a.none(), "options"_a, "threads"_a,
        "on_progress"_a.none());
  m.def("denoise_defaults", [] { return option_words({}); });
}

}  // namespace deburr::python
