// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>
#include <sstream>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "deburr/version.hpp"
#include "run_program.hpp"
#include "view/raster.hpp"
#include "view/scene.hpp"

// The help is right: its defaults are those of the library, its examples run.

namespace deburr::cli {
namespace {

using testing::HasSubstr;

const std::vector<std::string> commands{"denoise", "info", "synth", "compare", "view", "render"};

std::string help_of(const std::string& command) { return run_program({command, "--help"}).out; }

TEST(CliHelp, IsThereForEveryCommand) {
  const Outcome program = run_program({"--help"});
  EXPECT_EQ(program.exit_code, 0);
  for (const std::string& command : commands) {
    EXPECT_THAT(program.out, HasSubstr("  " + command + " "));
    const Outcome outcome = run_program({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const std::string option : {"--threads", "--json", "--quiet", "--version"}) {
      EXPECT_THAT(outcome.out, HasSubstr(option)) << command;
    }
  }
}

TEST(CliHelp, TellsTheVersion) {
  const std::string expected = fmt::format("deburr {}\n", version);
  EXPECT_EQ(run_program({"--version"}).out, expected);
  for (const std::string& command : commands) {
    EXPECT_EQ(run_program({command, "--version"}).out, expected);
  }
}

TEST(CliHelp, ShowsTheDefaultsOfTheLibrary) {
  const std::string denoise = help_of("denoise");
  const Yadav2018Options yadav;
  const auto expect = [](const std::string& help, const std::string& option, const auto& value) {
    EXPECT_THAT(help, HasSubstr(fmt::format("  {} [{}] ", option, value)));
  };
  expect(denoise, "--k N", yadav.k);
  expect(denoise, "--rho X", yadav.rho);
  expect(denoise, "--tau X", yadav.tau);
  expect(denoise, "--damping X", yadav.damping);
  expect(denoise, "--alpha X", yadav.alpha);
  expect(denoise, "--epsilon X", yadav.epsilon);
  expect(denoise, "--radius X", yadav.radius);
  expect(denoise, "--rounds N", yadav.rounds);
  expect(denoise, "--strength N", AutoOptions{}.strength);
  expect(denoise, "--noise X", AutoOptions{}.noise);
  expect(denoise, "--max-move X", AutoOptions{}.max_move);
  EXPECT_THAT(denoise, HasSubstr("--outliers label|remove|keep [label]"));
  EXPECT_THAT(denoise, HasSubstr(fmt::format("--neighborhoods once|per-round [{}]",
                                             yadav.rebuild ? "per-round" : "once")));
  EXPECT_THAT(denoise, HasSubstr(fmt::format("--update in-place|simultaneous [{}]",
                                             yadav.in_place ? "in-place" : "simultaneous")));
  const std::string synth = help_of("synth");
  expect(synth, "--points N", SynthOptions{}.points);
  expect(synth, "--noise X", SynthOptions{}.noise);
  expect(synth, "--seed N", SynthOptions{}.seed);
  const std::string compare = help_of("compare");
  expect(compare, "--samples N", CoverageOptions{}.samples);
  expect(compare, "--seed N", CoverageOptions{}.seed);
  expect(help_of("view"), "--max-size X", view::SceneOptions{}.max_bytes / 1'000'000);
  const view::RasterOptions raster;
  EXPECT_THAT(help_of("render"), HasSubstr(fmt::format("[{}x{}]", raster.width, raster.height)));
}

class CliExamples : public CliTest, public testing::WithParamInterface<std::string> {};

TEST_P(CliExamples, Run) {
  const SyntheticScan scan = synthesize_part({.points = 300});
  write_cloud("scan.ply", scan.cloud);
  write_cloud("scan.xyz", scan.cloud);
  write_cloud("scan.las", scan.cloud);
  write_cloud("part.ply", scan.cloud);
  write_mesh("part_truth.ply", scan.truth);
  int examples = 0;
  for (const std::string& line : lines_of(help_of(GetParam()))) {
    const std::string start = "  deburr ";
    if (!line.starts_with(start)) continue;
    std::istringstream words(line.substr(start.size()));
    const std::vector<std::string> args{std::istream_iterator<std::string>(words), {}};
    EXPECT_EQ(args.at(0), GetParam());
    const Outcome outcome = run_program(args);
    // A build without the viewer says so.
    const bool is_page = line.find(".html") != std::string::npos;
    EXPECT_EQ(outcome.exit_code, is_page && !DEBURR_HAS_VIEWER ? 1 : 0) << line << "\n"
                                                                        << outcome.err;
    ++examples;
  }
  EXPECT_GE(examples, 2);
}

INSTANTIATE_TEST_SUITE_P(OfHelp, CliExamples, testing::ValuesIn(commands),
                         [](const auto& instance) { return instance.param; });

TEST(CliHelp, KnowsEveryOptionThatThePageNames) {
  std::string help = run_program({"--help"}).out;
  for (const std::string& command : commands) help += help_of(command);
  const std::string page = read_text(DEBURR_SOURCE_DIR "/docs/cli.md");
  const std::regex option("--[a-z][a-z0-9-]*");
  std::sregex_iterator found(page.begin(), page.end(), option);
  EXPECT_NE(found, std::sregex_iterator());
  for (; found != std::sregex_iterator(); ++found) EXPECT_THAT(help, HasSubstr(found->str()));
}

}  // namespace
}  // namespace deburr::cli
