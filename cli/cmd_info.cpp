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
#include "output_file.hpp"

namespace deburr::cli {
namespace {

constexpr const char* info_examples =
    "  deburr info scan.ply\n"
    "  deburr info scan.xyz --json";

struct InfoArgs {
  CommonArgs common;
  std::string input;
  std::string in_format;
};

void run(const InfoArgs& args) {
  check_in_format(args.in_format);
  const PointCloud cloud = read_cloud(args.input, interrupted, args.in_format);
  ProgressBar bar(args.common.quiet);
  const CloudInfo info = measure(cloud, args.common.threads, bar);
  bar.clear();
  if (!args.common.quiet) {
    for (const std::string& doubt : doubts_about(cloud)) {
      tell(warning_line(fmt::format("{}: {}", args.input, doubt)));
    }
  }
  if (!args.common.json) {
    print(as_line(fmt::format("{:<11} {}", "file", args.input)) + to_text(info));
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
  add_file(*command, "IN", args->input, cloud_help);
  add_in_format(*command, args->in_format);
  add_common_options(*command, args->common, info_examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
