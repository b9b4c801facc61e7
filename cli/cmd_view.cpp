// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <stdexcept>
#include <utility>

#include "args.hpp"
#include "commands.hpp"
#include "compare_measure.hpp"
#include "console.hpp"
#include "deburr/io.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "json_line.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "page_output.hpp"
#include "places.hpp"
#include "up_option.hpp"

namespace deburr::cli {
namespace {

constexpr const char* view_examples =
    "  deburr view scan.ply -o scan.html\n"
    "  deburr view scan.ply part.ply -o view.html\n"
    "  deburr view scan.ply part.ply -o view.html --truth part_truth.ply --json";

constexpr double megabyte = 1e6;

struct ViewArgs {
  CommonArgs common;
  std::string before;
  std::string after;
  std::string output;
  std::string truth;
  std::string in_format;
  view::Up up = view::SceneOptions{}.up;
  double max_megabytes = static_cast<double>(view::SceneOptions{}.max_bytes) / megabyte;
};

/// A file that was read, and how far its points lie from the truth, where there is one.
struct Loaded {
  std::string name;
  PointCloud cloud;
  std::vector<double> truth_distance;

  [[nodiscard]] view::ShownCloud shown() const {
    return {.name = name, .cloud = &cloud, .truth_distance = truth_distance};
  }
};

std::vector<double> distances(const PointCloud& cloud, const Truth& truth,
                              const Execution& execution) {
  const auto* const surface = std::get_if<TriangleMesh>(&truth);
  return surface != nullptr
             ? distance_to_surface(cloud.points, *surface, execution)
             : distance_to_cloud(cloud.points, std::get<PointCloud>(truth).points, execution);
}

view::SceneOptions check(const ViewArgs& args) {
  const NamedPath output{"--output", args.output};
  const std::vector<NamedPath> inputs{
      {"A", args.before}, {"B", args.after}, {"--truth", args.truth}};
  check_apart({output, json_output(args.common.json)});
  check_kept(inputs, {output});
  check_inputs(inputs);
  check_extension("--output", args.output, page_extensions(), "a page");
  check_page_output(args.output);
  check_in_format(args.in_format);
  view::SceneOptions options;
  // The page itself takes more than half of the least.
  constexpr double least = 2;
  constexpr double most = 1000;
  if (!(args.max_megabytes >= least && args.max_megabytes <= most)) {
    throw std::invalid_argument(
        fmt::format("--max-size must be in [{}, {}], got {}", least, most, args.max_megabytes));
  }
  options.max_bytes = static_cast<std::size_t>(args.max_megabytes * megabyte);
  options.up = args.up;
  return options;
}

nlohmann::ordered_json to_json(const ViewArgs& args, const view::Scene& scene,
                               const std::vector<Loaded>& clouds, std::size_t bytes) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < clouds.size(); ++k) {
    inputs.push_back(
        {{"file", clouds[k].name}, {"points", clouds[k].cloud.size()}, {"shown", scene.shown[k]}});
  }
  return {{"deburr_version", version}, {"command", "view"},
          {"output", args.output},     {"bytes", bytes},
          {"inputs", inputs},          {"paired", scene.paired},
          {"warnings", scene.warnings}};
}

std::string to_text(const ViewArgs& args, const view::Scene& scene,
                    const std::vector<Loaded>& clouds, std::size_t bytes) {
  std::string text;
  for (const std::string& warning : scene.warnings) text += warning_line(warning);
  for (std::size_t k = 0; k < clouds.size(); ++k) {
    text += as_line(
        fmt::format("{}: {} of {} points", clouds[k].name, scene.shown[k], clouds[k].cloud.size()));
  }
  return text + as_line(fmt::format("{:.1f} MB written to {}, to be opened in a browser",
                                    static_cast<double>(bytes) / megabyte, args.output));
}

void run(const ViewArgs& args) {
  const view::SceneOptions options = check(args);
  ProgressBar bar(args.common.quiet);
  const Execution execution{
      .threads = args.common.threads, .progress = bar.part("view", 0, 1), .cancelled = interrupted};

  std::vector<Loaded> clouds(1);
  clouds[0] = {args.before, read_cloud(args.before, interrupted, args.in_format), {}};
  if (!args.after.empty()) {
    clouds.push_back({args.after, read_cloud(args.after, interrupted), {}});
  }
  if (!args.truth.empty()) {
    const Truth truth = read_mesh_or_cloud(args.truth, interrupted);
    for (Loaded& loaded : clouds) {
      loaded.truth_distance = distances(loaded.cloud, truth, execution);
    }
  }
  view::Request request{.before = clouds[0].shown()};
  if (clouds.size() > 1) request.after = clouds[1].shown();
  const PreparedPage page = prepare_page(request, options, execution);
  bar.clear();
  const std::string html = page_html(page);
  Outputs outputs;
  outputs.add(args.output, html);
  const bool json = args.common.json;
  outputs.commit(json ? to_line(to_json(args, page.scene, clouds, html.size())) : "");
  if (!json && !args.common.quiet) tell(to_text(args, page.scene, clouds, html.size()));
}

}  // namespace

void add_view_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("view", "Make a page that shows one or two clouds");
  const auto args = std::make_shared<ViewArgs>();
  add_file(*command, "A", args->before, cloud_help);
  command
      ->add_option(
          "B", args->after,
          "A second cloud to compare A with. As many points as in A are taken for the same "
          "points in the same order")
      ->type_name("")
      ->check(refuse_no_name);
  add_in_format(*command, args->in_format);
  add_file_option(*command, "-o,--output", args->output,
                  "Where to write the page, one HTML file; - is stdout", "FILE REQUIRED")
      ->required();
  add_file_option(*command, "--truth", args->truth,
                  "The true surface: a file with faces, or a cloud of points on it",
                  "MESH_OR_CLOUD");
  add_up(*command, args->up);
  add_value(*command, "--max-size", args->max_megabytes,
            "Largest size of the page, in megabytes; what does not fit is left out evenly");
  add_common_options(*command, args->common, view_examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
