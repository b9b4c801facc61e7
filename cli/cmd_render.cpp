// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <memory>
#include <stdexcept>

#include "args.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "json_line.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "places.hpp"
#include "up_option.hpp"
#include "view/left_out.hpp"
#include "view/png.hpp"
#include "view/still.hpp"

namespace deburr::cli {
namespace {

constexpr const char* render_examples =
    "  deburr render scan.ply scan.png\n"
    "  deburr render part.ply part.png --before scan.ply --color displacement\n"
    "  deburr render scan.ply top.png --view top --size 640x480 --quiet";

constexpr Choice<view::StillColour> colours[] = {{"normals", view::StillColour::Normals},
                                                 {"displacement", view::StillColour::Displacement},
                                                 {"labels", view::StillColour::Labels},
                                                 {"rgb", view::StillColour::OfFile}};
constexpr Choice<view::View> views[] = {{"iso", view::View::Iso},      {"front", view::View::Front},
                                        {"back", view::View::Back},    {"left", view::View::Left},
                                        {"right", view::View::Right},  {"top", view::View::Top},
                                        {"bottom", view::View::Bottom}};

struct RenderArgs {
  CommonArgs common;
  std::string cloud;
  std::string output;
  std::string before;
  std::string in_format;
  std::string size;
  view::StillOptions options;
};

/// The two numbers of WIDTHxHEIGHT.
void parse_size(const std::string& text, view::RasterOptions& raster) {
  if (text.empty()) return;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, raster.width);
  bool good = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  if (good) {
    const auto height = std::from_chars(width.ptr + 1, end, raster.height);
    good = height.ec == std::errc() && height.ptr == end;
  }
  if (!good) throw std::invalid_argument("--size must be WIDTHxHEIGHT in pixels, got " + text);
}

/// Everything that can be refused before the input is read.
void check(const RenderArgs& args) {
  check_in_format(args.in_format);
  const NamedPath output{"OUT", args.output};
  const std::vector<NamedPath> inputs{{"CLOUD", args.cloud}, {"--before", args.before}};
  check_apart({output, json_output(args.common.json)});
  check_kept(inputs, {output});
  check_inputs(inputs);
  check_extension("OUT", args.output, {".png"}, "a picture");
  check_output(args.output);
  if (!args.before.empty() && args.options.colour != view::StillColour::Displacement) {
    throw std::invalid_argument("--before belongs to --color displacement");
  }
  // Nothing to draw, so this only looks at the ranges of the options.
  (void)view::draw(
      {.points = {}, .normals = {}, .colours = {}, .radius = 1}, {},
      {.width = args.options.raster.width, .height = args.options.raster.height, .samples = 1});
}

/// What is told of a picture, as JSON or in words.
std::string describe(const RenderArgs& args, const view::StillPicture& still) {
  const bool has_range = args.options.colour == view::StillColour::Displacement;
  const double low = still.is_signed ? -still.range : 0;
  if (args.common.json) {
    nlohmann::ordered_json json{{"deburr_version", version},
                                {"command", "render"},
                                {"input", args.cloud},
                                {"output", args.output},
                                {"width", still.picture.width},
                                {"height", still.picture.height},
                                {"color", word_for(colours, args.options.colour)},
                                {"view", word_for(views, args.options.view)},
                                {"up", to_string(args.options.up)},
                                {"legend", still.legend},
                                {"points", still.points}};
    if (has_range) json["range"] = {low, still.range};
    return to_line(json);
  }
  std::string range;
  if (has_range) range = fmt::format(", colours from {:.6g} to {:.6g}", low, still.range);
  return as_line(fmt::format("{} points drawn to {}{}", still.points, args.output, range));
}

void run(RenderArgs& args) {
  parse_size(args.size, args.options.raster);
  check(args);
  ProgressBar bar(args.common.quiet);
  const Execution execution{.threads = args.common.threads,
                            .progress = bar.part("render", 0, 1),
                            .cancelled = interrupted};
  const PointCloud cloud = read_cloud(args.cloud, interrupted, args.in_format);
  PointCloud before;
  view::Request request{.before = {.name = args.cloud, .cloud = &cloud}};
  if (!args.before.empty()) {
    before = read_cloud(args.before, interrupted);
    if (before.size() != cloud.size() && view::match_without_removed(before, cloud).empty()) {
      throw DataError(fmt::format("--before {}: {} points, not {} as in {}", args.before,
                                  before.size(), cloud.size(), args.cloud));
    }
    request = {.before = {.name = args.before, .cloud = &before}, .after = request.before};
  }
  const view::StillPicture still = view::draw_still(request, args.options, execution);
  bar.clear();
  Outputs outputs;
  outputs.add(args.output, view::png_bytes(still.picture));
  const std::string told = describe(args, still);
  outputs.commit(args.common.json ? told : "");
  if (!args.common.json && !args.common.quiet) tell(told);
}

}  // namespace

void add_render_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a point cloud as a still picture, without a screen");
  const auto args = std::make_shared<RenderArgs>();
  add_file(*command, "CLOUD", args->cloud, cloud_help);
  add_file(*command, "OUT", args->output, "Where to write the picture, as PNG; - is stdout");
  add_in_format(*command, args->in_format);
  add_choice(*command, "--color", args->options.colour, colours,
             "What colours show: the shape alone, or the fields deburr_displacement, deburr_label, "
             "or red green blue");
  add_choice(*command, "--view", args->options.view, views, "Where the viewer stands");
  add_up(*command, args->options.up);
  command->add_option("--size", args->size, "Size of the picture in pixels")
      ->option_text(fmt::format("WIDTHxHEIGHT [{}x{}]", args->options.raster.width,
                                args->options.raster.height));
  add_file_option(*command, "--before", args->before,
                  "The same points before they were moved, in the same order, with or without "
                  "outliers that were removed: the displacement is then taken between the two, "
                  "along the normals",
                  "CLOUD");
  add_value(*command, "--range", args->options.range,
            "Displacement of the last colour, in input units; 0 for what 98 % do not exceed");
  command->add_flag_callback(
      "--no-legend", [args] { args->options.legend = false; },
      "Do not draw below what the colours of displacement and labels mean");
  add_common_options(*command, args->common, render_examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
