// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "added_fields.hpp"
#include "args.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/denoise.hpp"
#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "denoise_options.hpp"
#include "denoise_summary.hpp"
#include "element_losses.hpp"
#include "interrupt.hpp"
#include "io/format.hpp"
#include "json_line.hpp"
#include "memory.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "places.hpp"
#include "report_page.hpp"

namespace deburr::cli {
namespace {

constexpr const char* denoise_examples =
    "  deburr denoise scan.ply clean.ply\n"
    "  deburr denoise scan.ply clean.ply --report report.json --quiet\n"
    "  deburr denoise scan.ply clean.ply --report report.html\n"
    "  deburr denoise scan.las clean.las --outliers label\n"
    "  deburr denoise scan.xyz clean.xyz --strength 2 --outliers remove\n"
    "  deburr denoise scan.xyz clean.ply --method yadav2018 --rho 0.95 --add label,displacement";

struct DenoiseArgs {
  CommonArgs common;
  std::string input;
  std::string output;
  std::string report;
  std::string add;
  std::string in_format;
  std::string format;
  DenoiseOptions options;
};

void summarize_displacement(const DenoiseResult& result, DenoiseSummary& summary) {
  if (result.displacement.empty()) return;
  const double largest = std::ranges::max(result.displacement);
  summary.max_displacement = largest;
  if (!(largest > 0)) return;
  double sum = 0;  // of squares relative to the largest, which cannot overflow
  for (const double moved : result.displacement) sum += (moved / largest) * (moved / largest);
  const std::size_t finite = summary.report.points - summary.report.non_finite;
  summary.rms_displacement = largest * std::sqrt(sum / static_cast<double>(finite));
}

/// Everything that can be refused before the input is read.
FormatInfo check(const DenoiseArgs& args) {
  FormatInfo format = check_cloud_output(args.output, args.format);
  check_in_format(args.in_format);
  const NamedPath report{"--report", args.report};
  check_apart({{"OUT", args.output}, report, json_output(args.common.json)});
  check_kept({{"IN", args.input}}, {report});
  // A file can be replaced by what came out of it, but not appended to while it is read.
  if (is_open_stream(args.output)) check_kept({{"IN", args.input}}, {{"OUT", args.output}});
  if (!args.report.empty()) {
    is_page(args.report) ? check_page_output(args.report) : check_output(args.report);
  }
  // Nothing to denoise, so this only looks at the ranges of the options.
  DenoiseOptions options = args.options;
  options.normals = NormalSource::Auto;
  (void)denoise({}, options);
  return format;
}

/// A grid of coordinates has to tell apart what the movement did, but nothing far below the
/// distance of the points.
double resolution_for(const DenoiseSummary& summary) {
  constexpr double of_move = 1.0 / 32;
  constexpr double of_spacing = 1e-4;
  if (!(summary.rms_displacement > 0)) return 0;
  return std::max(of_move * summary.rms_displacement, of_spacing * summary.report.spacing);
}

void run(const DenoiseArgs& args) {
  const FormatInfo format = check(args);
  const AddedFields add = parse_added_fields(args.add, format);
  ProgressBar bar(args.common.quiet);
  const Execution execution{.threads = args.common.threads,
                            .progress = [&bar](const Progress& progress) { bar.update(progress); },
                            .cancelled = interrupted,
                            .clock = steady_seconds};
  DenoiseSummary summary{.input = args.input, .output = args.output, .options = args.options};

  const double started = steady_seconds();
  DenoiseResult result;
  result.cloud = read_cloud(args.input, interrupted, args.in_format);
  const double reading = steady_seconds() - started;

  for (const std::string& doubt : doubts_about(result.cloud)) {
    summary.warnings.push_back(fmt::format("{}: {}", args.input, doubt));
  }
  const std::size_t points = result.cloud.size();
  give_memory_back(points);
  std::optional<ReportPage> page;
  if (is_page(args.report)) page.emplace(args.input, args.output, result.cloud);
  if (std::ranges::any_of(result.cloud.points, is_finite)) {
    const bool had_normals = !result.cloud.normals.empty();
    const std::vector<ElementSize> elements = element_sizes(result.cloud);
    try {
      result = denoise(std::move(result.cloud), args.options, execution);
    } catch (const DataError& error) {
      throw DataError(args.input + ": " + error.what());
    }
    summary.report = std::move(result.report);
    if (page) page->take(result, execution);
    warn_of_lost_elements(args.input, elements, element_sizes(result.cloud), summary.warnings);
    summarize_displacement(result, summary);
    summary.added = add_fields(result, add, had_normals, format);
    result.cloud.layout.resolution = resolution_for(summary);
  } else {
    summary.report.points = points;
    summary.report.kept = points;
    summary.report.non_finite = points;
    summary.report.labels[static_cast<std::size_t>(Feature::Isolated)] = points;
    summary.warnings.emplace_back(args.input + ": no point is finite, written unchanged");
    if (page) page->take(result, execution);
  }

  bar.clear();
  const double writing = steady_seconds();
  Outputs outputs;
  AtomicFile& out = outputs.add(args.output);
  for (std::string& warning : write_cloud(out, result.cloud, interrupted, format.name)) {
    summary.warnings.push_back(std::move(warning));
  }
  out.sync();
  std::vector<StageTime>& stages = summary.report.stages;
  stages.insert(stages.begin(), {"read", reading});
  stages.push_back({"write", steady_seconds() - writing});

  const std::string json = to_line(to_json(summary));
  if (!args.report.empty()) outputs.add(args.report, page ? page->html(json) : json);
  outputs.commit(args.common.json ? json : "");
  if (!args.common.json && !args.common.quiet) tell(to_text(summary));
}

}  // namespace

void add_denoise_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("denoise", "Take the noise off a point cloud");
  const auto args = std::make_shared<DenoiseArgs>();
  add_file(*command, "IN", args->input, cloud_help);
  add_file(
      *command, "OUT", args->output,
      "Where to write it; may be IN: .ply .las .pcd .stl .obj .off .xyz .csv ...; - is stdout");
  add_in_format(*command, args->in_format);
  add_format(*command, args->format);
  add_denoise_options(*command, args->options);
  command
      ->add_option(
          "--add", args->add,
          "What to write for every point: normals,label,displacement,outlier, some or none")
      ->option_text("LIST [all to PLY, LAS and PCD, else none]");
  add_file_option(*command, "--report", args->report,
                  "Write the summary to this file: as JSON, or, if it ends in .html, as a page "
                  "that shows the points before and after; - is stdout",
                  "FILE");
  add_common_options(*command, args->common, denoise_examples);
  command->callback([command, args] {
    finish_denoise_options(*command, args->options);
    run(*args);
  });
}

}  // namespace deburr::cli
