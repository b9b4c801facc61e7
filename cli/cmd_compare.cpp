// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include "args.hpp"
#include "commands.hpp"
#include "compare_measure.hpp"
#include "compare_report.hpp"
#include "console.hpp"
#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "io/format.hpp"
#include "json_line.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "places.hpp"

namespace deburr::cli {
namespace {

constexpr const char* compare_examples =
    "  deburr compare part.ply --truth part_truth.ply\n"
    "  deburr compare part.ply --truth part_truth.ply --json\n"
    "  deburr compare part.ply --truth part_truth.ply --distances part_error.ply";

struct CompareArgs {
  CommonArgs common;
  std::string cloud;
  std::string truth;
  std::string clean;
  std::string distances;
  std::string in_format;
  CompareOptions options;
};

bool has_finite_point(const Truth& truth) {
  const auto* const cloud = std::get_if<PointCloud>(&truth);
  return cloud == nullptr || std::ranges::any_of(cloud->points, is_finite);
}

/// Writes the cloud with the distance of each of its points from the truth.
std::vector<std::string> write_distances(Outputs& outputs, const std::string& path,
                                         PointCloud cloud, const Truth& truth, int threads) {
  const Execution execution{.threads = threads, .cancelled = interrupted};
  const auto* const surface = std::get_if<TriangleMesh>(&truth);
  std::vector<double> distances =
      surface != nullptr
          ? distance_to_surface(cloud.points, *surface, execution)
          : distance_to_cloud(cloud.points, std::get<PointCloud>(truth).points, execution);
  // Only a header can tell what a new column of a text file is.
  TextHeader& header = cloud.layout.text.header;
  if (header == TextHeader::None) header = TextHeader::Plain;
  std::erase_if(cloud.attributes,
                [](const Attribute& attribute) { return attribute.name == "deburr_distance"; });
  cloud.attributes.push_back({"deburr_distance", std::move(distances), {}});
  const FormatInfo format = check_cloud_output(path);
  return write_cloud(outputs.add(path), cloud, interrupted, format.name);
}

/// Everything that can be refused before the input is read.
void check(const CompareArgs& args) {
  const NamedPath distances{"--distances", args.distances};
  const NamedPath truth{"--truth", args.truth};
  const NamedPath clean{"--clean", args.clean};
  check_apart({distances, {.option = "the figures", .path = "-", .is_implied = true}});
  check_kept({truth, clean}, {distances});
  check_inputs({{"CLOUD", args.cloud}, truth, clean});
  if (!args.distances.empty()) check_cloud_output(args.distances);
  check_in_format(args.in_format);
}

void run(CompareArgs& args) {
  check(args);
  args.options.threads = args.common.threads;
  const PointCloud cloud = read_cloud(args.cloud, interrupted, args.in_format);
  const Truth truth = read_mesh_or_cloud(args.truth, interrupted);
  std::optional<PointCloud> clean;
  if (!args.clean.empty()) clean = read_cloud(args.clean, interrupted);
  if (!has_finite_point(truth)) throw DataError(args.truth + ": no finite point to compare with");

  ProgressBar bar(args.common.quiet);
  Comparison comparison = compare(cloud, truth, clean, args.options, bar);
  bar.clear();
  if (comparison.error.count == 0) throw DataError(args.cloud + ": no finite point to compare");

  Outputs outputs;
  if (!args.distances.empty()) {
    for (std::string& warning :
         write_distances(outputs, args.distances, cloud, truth, args.common.threads)) {
      comparison.warnings.push_back(std::move(warning));
    }
  }
  if (args.common.json) {
    nlohmann::ordered_json json{{"deburr_version", version},
                                {"command", "compare"},
                                {"input", args.cloud},
                                {"truth", args.truth}};
    if (clean) json["clean"] = args.clean;
    json.update(to_json(comparison));
    outputs.commit(to_line(json));
    return;
  }
  if (!args.common.quiet) {
    for (const std::string& warning : comparison.warnings) {
      tell(warning_line(warning));
    }
  }
  outputs.commit(to_text(comparison));
}

}  // namespace

void add_compare_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("compare", "Measure how far points lie from a true surface");
  const auto args = std::make_shared<CompareArgs>();
  add_file(*command, "CLOUD", args->cloud, cloud_help);
  add_in_format(*command, args->in_format);
  add_file(*command, "--truth", args->truth,
           "The true surface: a file with faces (PLY, STL, OBJ, OFF), or a cloud of points on it")
      ->option_text("MESH_OR_CLOUD REQUIRED");
  add_file_option(*command, "--clean", args->clean,
                  "The points of CLOUD in the same order without noise, with true normals; a field "
                  "outlier marks those that are none of the surface",
                  "CLOUD");
  add_file_option(*command, "--distances", args->distances,
                  "Write CLOUD to this file, with the distance of each point from the truth as "
                  "field deburr_distance",
                  "FILE");
  command->add_flag("--skip-outliers", args->options.skip_outliers,
                    "Leave out points whose field deburr_outlier is not 0");
  add_value(*command, "--samples", args->options.coverage.samples,
            "Places on the true mesh at which coverage is measured; 0 for none");
  add_value(*command, "--seed", args->options.coverage.seed, "The same seed gives the same places");
  add_common_options(*command, args->common, compare_examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
