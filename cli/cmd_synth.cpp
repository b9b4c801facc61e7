// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include "args.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "io/format.hpp"
#include "json_line.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "places.hpp"

namespace deburr::cli {
namespace {

constexpr const char* synth_examples =
    "  deburr synth part part.ply\n"
    "  deburr synth part part.xyz --points 5000 --noise 0.01 --seed 7 --truth part_truth.ply\n"
    "  deburr synth thin-plate plate.ply --points 10000 --thickness 0.03 --noise-spacings 0.3\n"
    "  deburr synth part_truth.ply scan.ply --points 2000 --sampling scanner --noise-kind ray\n"
    "  deburr synth sphere ball.ply --points 5000 --outliers 0.05 --clean ball_clean.ply";

constexpr Choice<Shape> shapes[] = {{"part", Shape::Part},
                                    {"cube", Shape::Cube},
                                    {"sphere", Shape::Sphere},
                                    {"torus", Shape::Torus},
                                    {"cylinder", Shape::Cylinder},
                                    {"thin-plate", Shape::ThinPlate},
                                    {"bumpy-sheet", Shape::BumpySheet},
                                    {"stepped-wall", Shape::SteppedWall}};
constexpr Choice<NoiseKind> noise_kinds[] = {{"isotropic", NoiseKind::Isotropic},
                                             {"normal", NoiseKind::Normal},
                                             {"impulsive", NoiseKind::Impulsive},
                                             {"ray", NoiseKind::Ray}};
constexpr Choice<Sampling> samplings[] = {
    {"uniform", Sampling::Uniform}, {"poisson", Sampling::Poisson}, {"scanner", Sampling::Scanner}};

struct SynthArgs {
  CommonArgs common;
  std::string surface;
  std::string output;
  std::string truth;
  std::string clean;
  std::string format;
  double noise_spacings = 0;
  const CLI::Option* in_spacings = nullptr;
  const CLI::Option* thickness = nullptr;
  SynthOptions options;
};

const Choice<Shape>* find_shape(const std::string& word) {
  const auto* const found = std::ranges::find(shapes, word, &Choice<Shape>::word);
  return found != std::end(shapes) ? found : nullptr;
}

std::string shape_words() {
  std::vector<std::string> words;
  for (const Choice<Shape>& shape : shapes) words.emplace_back(shape.word);
  return fmt::format("{}", fmt::join(words, ", "));
}

void check_arguments(const SynthArgs& args) {
  const Choice<Shape>* const shape = find_shape(args.surface);
  const std::filesystem::path path = args.surface;
  // A word that cannot be meant as a file gets the list of words, not a complaint about a file.
  if (shape == nullptr && !std::filesystem::exists(path) && !path.has_extension() &&
      !path.has_parent_path() && path != "-") {
    throw std::invalid_argument(
        fmt::format("SHAPE_OR_MESH {}: neither a file nor one of {}", args.surface, shape_words()));
  }
  if (args.thickness->count() > 0 && (shape == nullptr || shape->value != Shape::ThinPlate)) {
    throw std::invalid_argument("--thickness belongs to thin-plate");
  }
  check_cloud_output(args.output, args.format);
  if (!args.truth.empty()) check_extension("--truth", args.truth, {".ply"}, "a mesh");
  const std::vector<NamedPath> outputs{
      {"OUT", args.output}, {"--truth", args.truth}, {"--clean", args.clean}};
  check_apart({outputs[0], outputs[1], outputs[2], json_output(args.common.json)});
  if (shape == nullptr) check_kept({{"SHAPE_OR_MESH", args.surface}}, outputs);
  if (!args.truth.empty()) check_output(args.truth);
  if (!args.clean.empty()) check_cloud_output(args.clean);
}

SyntheticScan make_scan(const SynthArgs& args) {
  ProgressBar bar(args.common.quiet);
  const Execution execution{.threads = args.common.threads,
                            .progress = bar.part("points", 0, 1),
                            .cancelled = interrupted};
  const Choice<Shape>* const shape = find_shape(args.surface);
  return shape != nullptr ? synthesize(shape->value, args.options, execution)
                          : synthesize(read_mesh(args.surface), args.options, execution);
}

/// The points without noise, with what is true of them.
PointCloud clean_cloud(const SyntheticScan& scan) {
  PointCloud cloud;
  cloud.points = scan.clean;
  cloud.normals = scan.normals;
  cloud.attributes.push_back({"outlier", scan.outlier, {}});
  return cloud;
}

std::vector<std::string> write(Outputs& outputs, const SynthArgs& args, const SyntheticScan& scan) {
  const auto write_points = [&](const std::string& path, const std::string& format,
                                const PointCloud& cloud) {
    const FormatInfo info = check_cloud_output(path, format);
    return write_cloud(outputs.add(path), cloud, interrupted, info.name);
  };
  std::vector<std::string> warnings = write_points(args.output, args.format, scan.cloud);
  if (!args.truth.empty()) write_mesh(outputs.add(args.truth), scan.truth, interrupted);
  if (!args.clean.empty()) write_points(args.clean, {}, clean_cloud(scan));
  return warnings;
}

void tell_summary(const SynthArgs& args, const SyntheticScan& scan,
                  const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) tell(warning_line(warning));
  tell(as_line(fmt::format("{} points written to {}", scan.cloud.size(), args.output)));
  if (scan.cloud.size() > args.options.points) {
    tell(fmt::format("{} of them are outliers\n", scan.cloud.size() - args.options.points));
  }
  tell(fmt::format("spacing {:.6g}, noise {:.6g}, {:.4g} spacings\n", scan.spacing, scan.sigma,
                   scan.sigma / scan.spacing));
  if (!args.truth.empty()) {
    tell(as_line(
        fmt::format("{} triangles written to {}", scan.truth.triangles.size(), args.truth)));
  }
  if (!args.clean.empty()) tell(as_line("points without noise written to " + args.clean));
}

std::string to_json(const SynthArgs& args, const SyntheticScan& scan,
                    const std::vector<std::string>& warnings) {
  const SynthOptions& options = args.options;
  nlohmann::ordered_json json{
      {"deburr_version", version},
      {"command", "synth"},
      {"shape", args.surface},
      {"output", args.output},
      {"truth", nullptr},
      {"clean", nullptr},
      {"points", scan.cloud.size()},
      {"surface_points", options.points},
      {"outlier_points", scan.cloud.size() - options.points},
      {"noise", options.noise},
      {"noise_unit", options.noise_unit == NoiseUnit::Spacing ? "spacing" : "diagonal"},
      {"noise_kind", word_for(noise_kinds, options.noise_kind)},
      {"sampling", word_for(samplings, options.sampling)},
      {"outliers", options.outliers},
      {"cluster_outliers", options.cluster_outliers},
      {"seed", options.seed},
      {"spacing", scan.spacing},
      {"sigma", scan.sigma},
      {"warnings", warnings}};
  if (!args.truth.empty()) json["truth"] = args.truth;
  if (!args.clean.empty()) json["clean"] = args.clean;
  if (args.surface == "thin-plate") json["thickness"] = options.shape.thickness;
  return to_line(json);
}

void run(SynthArgs& args) {
  if (args.in_spacings->count() > 0) {
    args.options.noise = args.noise_spacings;
    args.options.noise_unit = NoiseUnit::Spacing;
  }
  check_arguments(args);
  const SyntheticScan scan = make_scan(args);
  Outputs outputs;
  const std::vector<std::string> warnings = write(outputs, args, scan);
  outputs.commit(args.common.json ? to_json(args, scan, warnings) : "");
  if (!args.common.json && !args.common.quiet) tell_summary(args, scan, warnings);
}

}  // namespace

void add_synth_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("synth", "Make a noisy scan of a known surface");
  const auto args = std::make_shared<SynthArgs>();
  SynthOptions& options = args->options;
  add_file(
      *command, "SHAPE_OR_MESH", args->surface,
      fmt::format("What is scanned: {}, or a file with faces (PLY, STL, OBJ, OFF)", shape_words()));
  add_file(*command, "OUT", args->output, "Where to write the points; - is stdout");
  add_format(*command, args->format);
  add_value(*command, "--points", options.points, "Number of points on the surface");
  CLI::Option* const noise =
      add_value(*command, "--noise", options.noise,
                "Standard deviation of the noise, as a fraction of the diagonal of the surface");
  args->in_spacings = command
                          ->add_option("--noise-spacings", args->noise_spacings,
                                       "The same in mean spacings, sqrt(area / points)")
                          ->excludes(noise)
                          ->option_text("X");
  add_choice(*command, "--noise-kind", options.noise_kind, noise_kinds, "Where noise moves points");
  add_value(*command, "--outliers", options.outliers,
            "Outliers to add, as a share of the points, in twice the bounding box");
  add_value(*command, "--cluster-outliers", options.cluster_outliers,
            "Outliers to add in small dense clusters, likewise");
  add_choice(*command, "--sampling", options.sampling, samplings, "Where points are taken");
  add_value(*command, "--seed", options.seed, "The same seed gives the same points");
  args->thickness =
      add_value(*command, "--thickness", options.shape.thickness,
                "Distance of the sheets of thin-plate, as a fraction of the diagonal");
  add_file_option(*command, "--truth", args->truth,
                  "Write the true surface to this PLY file; - is stdout", "MESH");
  add_file_option(
      *command, "--clean", args->clean,
      "Write the points before the noise, with normals and outlier, to this file; - is stdout",
      "CLOUD");
  add_common_options(*command, args->common, synth_examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
