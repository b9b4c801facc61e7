// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <stdexcept>

#include "args.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "json_line.hpp"
#include "output_file.hpp"

namespace deburr::cli {
namespace {

constexpr const char* examples =
    "  deburr synth part part.ply\n"
    "  deburr synth part part.xyz --points 5000 --noise 0.01 --seed 7 --truth part_truth.ply";

struct SynthArgs {
  CommonArgs common;
  std::string shape;
  std::string output;
  std::string truth;
  SynthOptions options;
};

void run(const SynthArgs& args) {
  check_cloud_output(args.output);
  if (!args.truth.empty()) {
    if (extension(args.truth) != ".ply") {
      throw std::invalid_argument("--truth " + args.truth + ": a mesh is written as .ply");
    }
    check_different("--truth", args.truth, args.output);
    check_output(args.truth);
  }
  const SyntheticScan scan = synthesize_part(args.options);
  // The cloud first: only while it is written can an interrupt still leave everything as it was.
  const std::vector<std::string> warnings = write_cloud(args.output, scan.cloud, interrupted);
  if (!args.truth.empty()) write_mesh(args.truth, scan.truth);

  if (args.common.json) {
    nlohmann::ordered_json json{
        {"deburr_version", version},   {"command", "synth"},        {"shape", args.shape},
        {"output", args.output},       {"truth", nullptr},          {"points", args.options.points},
        {"noise", args.options.noise}, {"seed", args.options.seed}, {"warnings", warnings}};
    if (!args.truth.empty()) json["truth"] = args.truth;
    print(to_line(json));
  } else if (!args.common.quiet) {
    for (const std::string& warning : warnings) tell("deburr: warning: " + warning + "\n");
    tell(fmt::format("{} points written to {}\n", scan.cloud.size(), args.output));
    if (!args.truth.empty()) {
      tell(fmt::format("{} triangles written to {}\n", scan.truth.triangles.size(), args.truth));
    }
  }
}

}  // namespace

void add_synth_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("synth", "Make a noisy scan of a known surface");
  const auto args = std::make_shared<SynthArgs>();
  add_file(*command, "SHAPE", args->shape, "What is scanned: part, a machined part")
      ->check(CLI::IsMember({"part"}))
      ->option_text("part");
  add_file(*command, "OUT", args->output, "Where to write the points");
  add_value(*command, "--points", args->options.points, "Number of points");
  add_value(*command, "--noise", args->options.noise,
            "Standard deviation of the noise, as a fraction of the diagonal of the surface");
  add_value(*command, "--seed", args->options.seed, "The same seed gives the same points");
  command->add_option("--truth", args->truth, "Write the true surface to this PLY file")
      ->option_text("MESH");
  add_common_options(*command, args->common, examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
