// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "args.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "deburr/metrics.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"
#include "json_line.hpp"

namespace deburr::cli {
namespace {

constexpr const char* examples =
    "  deburr compare part.ply --truth part_truth.ply\n"
    "  deburr compare part.ply --truth part_truth.ply --json";

struct CompareArgs {
  CommonArgs common;
  std::string cloud;
  std::string truth;
};

void run(const CompareArgs& args) {
  const PointCloud cloud = read_cloud(args.cloud, interrupted);
  const TriangleMesh truth = read_mesh(args.truth);
  ProgressBar bar(args.common.quiet);
  const SurfaceError error = compare_to_surface(cloud.points, truth,
                                                {.threads = args.common.threads,
                                                 .progress = bar.part("distances", 0, 1),
                                                 .cancelled = interrupted});
  bar.clear();
  if (error.count == 0) throw DataError(args.cloud + ": no finite point to compare");

  const std::size_t non_finite = cloud.size() - error.count;
  if (args.common.json) {
    print(to_line({{"deburr_version", version},
                   {"command", "compare"},
                   {"input", args.cloud},
                   {"truth", args.truth},
                   {"count", error.count},
                   {"non_finite", non_finite},
                   {"diagonal", error.diagonal},
                   {"mean", error.mean},
                   {"rms", error.rms},
                   {"maximum", error.maximum},
                   {"mean_relative", error.mean / error.diagonal},
                   {"rms_relative", error.rms / error.diagonal},
                   {"maximum_relative", error.maximum / error.diagonal}}));
    return;
  }
  const auto line = [&](const char* name, double value) {
    return fmt::format("{:<11} {:<12.6g} {:.6g} % of the diagonal\n", name, value,
                       100 * value / error.diagonal);
  };
  print(fmt::format("{:<11} {}\n{:<11} {}\n{:<11} {:.6g}\n", "points", error.count, "not finite",
                    non_finite, "diagonal", error.diagonal) +
        line("mean", error.mean) + line("rms", error.rms) + line("maximum", error.maximum));
}

}  // namespace

void add_compare_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("compare", "Measure how far points lie from a true surface");
  const auto args = std::make_shared<CompareArgs>();
  add_file(*command, "CLOUD", args->cloud, "Point cloud: PLY, or text with x y z in each line");
  add_file(*command, "--truth", args->truth, "The true surface: a PLY file with faces")
      ->option_text("MESH REQUIRED");
  add_common_options(*command, args->common, examples);
  command->callback([args] { run(*args); });
}

}  // namespace deburr::cli
