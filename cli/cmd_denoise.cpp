// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

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
#include "json_line.hpp"
#include "output_file.hpp"
#include "report_page.hpp"

namespace deburr::cli {
namespace {

constexpr const char* examples =
    "  deburr denoise scan.ply clean.ply\n"
    "  deburr denoise scan.ply clean.ply --report report.json --quiet\n"
    "  deburr denoise scan.ply clean.ply --report report.html\n"
    "  deburr denoise scan.las clean.las --outliers label\n"
    "  deburr denoise scan.xyz clean.xyz --strength 2 --outliers remove\n"
    "  deburr denoise scan.xyz clean.ply --method yadav2018 --rho 0.95 --add label,displacement";

/// What is written for every point besides what came in.
struct AddedFields {
  bool normals = false;
  bool label = false;
  bool displacement = false;
  bool outlier = false;
};

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

/// What --add asks for. Where new fields have no names, nothing is added unless asked for.
AddedFields parse_added_fields(const DenoiseArgs& args, const FormatInfo& format) {
  if (args.add.empty()) {
    const bool named = format.takes_any_field;
    return {named, named, named, named};
  }
  AddedFields add;
  if (args.add == "none") return add;
  for (const std::string& word : CLI::detail::split(args.add, ',')) {
    if (word == "normals") {
      add.normals = true;
    } else if (word == "label") {
      add.label = true;
    } else if (word == "displacement") {
      add.displacement = true;
    } else if (word == "outlier") {
      add.outlier = true;
    } else {
      throw std::invalid_argument(fmt::format(
          "--add takes none, or a list of normals,label,displacement,outlier, got {}", args.add));
    }
  }
  return add;
}

/// Adds a field to the points, or puts new values into the one of that name.
void set_attribute(PointCloud& cloud, const std::string& name, Values values) {
  const auto found = std::ranges::find(cloud.attributes, name, &Attribute::name);
  Attribute& attribute = found != cloud.attributes.end() ? *found : cloud.attributes.emplace_back();
  attribute = {.name = name, .values = std::move(values), .offsets = {}};
}

/// Values as classes of LAS, whatever type they were read as; none if one is not a class.
std::optional<std::vector<std::uint8_t>> as_classes(const Values& values) {
  std::vector<std::uint8_t> classes;
  const bool all = std::visit(
      [&](const auto& column) {
        using Value = typename std::decay_t<decltype(column)>::value_type;
        if constexpr (std::is_arithmetic_v<Value>) {
          for (const Value value : column) {
            const auto number = static_cast<double>(value);
            if (!(number >= 0 && number <= 255) || number != std::floor(number)) return false;
            classes.push_back(static_cast<std::uint8_t>(number));
          }
          return true;
        } else {
          return false;
        }
      },
      values);
  return all ? std::optional(std::move(classes)) : std::nullopt;
}

/// LAS has a class for outliers, low noise, which all its programs know.
void classify_outliers(PointCloud& cloud, const std::vector<std::uint8_t>& outliers) {
  constexpr std::uint8_t low_noise = 7;
  const auto found = std::ranges::find(cloud.attributes, "classification", &Attribute::name);
  std::vector<std::uint8_t> classes(cloud.size());
  if (found != cloud.attributes.end()) {
    auto before = as_classes(found->values);
    // Of what else a file calls its classification, nothing is written over.
    if (!before || before->size() != classes.size()) return;
    classes = std::move(*before);
  }
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (outliers[i] != 0) classes[i] = low_noise;
  }
  set_attribute(cloud, "classification", std::move(classes));
}

/// Leaves in the cloud what is to be written, and returns the names of the fields added.
std::vector<std::string> add_fields(DenoiseResult& result, const AddedFields& add, bool had_normals,
                                    bool is_las) {
  std::vector<std::string> names;
  // Only a header can tell what a new column of a text file is.
  TextHeader& header = result.cloud.layout.text.header;
  const bool new_columns =
      (add.normals && !had_normals) || add.label || add.displacement || add.outlier;
  if (new_columns && header == TextHeader::None) header = TextHeader::Plain;
  if (add.normals || had_normals) {
    names.insert(names.end(), {"nx", "ny", "nz"});
  } else {
    result.cloud.normals.clear();
  }
  if (add.label) {
    std::vector<std::uint8_t> values;
    values.reserve(result.labels.size());
    for (const Feature label : result.labels) values.push_back(static_cast<std::uint8_t>(label));
    set_attribute(result.cloud, names.emplace_back("deburr_label"), std::move(values));
  }
  if (add.displacement) {
    std::vector<float> values;
    values.reserve(result.displacement.size());
    constexpr double most = std::numeric_limits<float>::max();
    for (const double moved : result.displacement) {
      values.push_back(static_cast<float>(std::min(moved, most)));
    }
    set_attribute(result.cloud, names.emplace_back("deburr_displacement"), std::move(values));
  }
  if (add.outlier && is_las) {
    names.emplace_back("classification");
    classify_outliers(result.cloud, result.outliers);
  } else if (add.outlier) {
    set_attribute(result.cloud, names.emplace_back("deburr_outlier"), std::move(result.outliers));
  }
  return names;
}

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
  check_json(args.output, args.common.json);
  if (!args.report.empty()) {
    check_different("--report", args.report, args.input);
    check_different("--report", args.report, args.output);
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
  const AddedFields add = parse_added_fields(args, format);
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
    summary.added = add_fields(result, add, had_normals, format.name == "las");
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
  for (std::string& warning : write_cloud(args.output, result.cloud, interrupted, args.format)) {
    summary.warnings.push_back(std::move(warning));
  }
  std::vector<StageTime>& stages = summary.report.stages;
  stages.insert(stages.begin(), {"read", reading});
  stages.push_back({"write", steady_seconds() - writing});

  const std::string json = to_line(to_json(summary));
  if (page) {
    page->write(args.report, json);
  } else if (!args.report.empty()) {
    write_text(args.report, json);
  }
  if (args.common.json) {
    print(json);
  } else if (!args.common.quiet) {
    tell(to_text(summary));
  }
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
  command
      ->add_option("--report", args->report,
                   "Write the summary to this file: as JSON, or, if it ends in .html, as a page "
                   "that shows the points before and after")
      ->option_text("FILE");
  add_common_options(*command, args->common, examples);
  command->callback([command, args] {
    finish_denoise_options(*command, args->options);
    run(*args);
  });
}

}  // namespace deburr::cli
