// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "args.hpp"
#include "cloud_info.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/io.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "json_line.hpp"

namespace deburr::cli {
namespace {

constexpr const char* examples =
    "  deburr info scan.ply\n"
    "  deburr info scan.xyz --json";

struct InfoArgs {
  CommonArgs common;
  std::string input;
};

void run(const InfoArgs& args) {
  const PointCloud cloud = read_cloud(args.input, interrupted);
  ProgressBar bar(args.common.quiet);
  const CloudInfo info = measure(cloud, args.common.threads, bar);
  bar.clear();
  if (!args.common.json) {
    print(fmt::format("{:<11} {}\n{}", "file", args.input, to_text(info)));
    return;
  }
  nlohmann::ordered_json json{
      {"deburr_version", version}, {"command", "info"}, {"input", args.input}};
  json.update(to_json(info));
  print(to_line(json));
}

}  // namespace

void add_info_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "Tell what is in a point cloud");
  const auto args = std::make_shared<InfoArgs>();
  add_file(*command, "IN", args->input, "Point cloud: PLY, or text with x y z in each line");
  add_common_options(*command, args->common, examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
