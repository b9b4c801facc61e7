// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// The commands view and render, and the report that is a page.

namespace deburr::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

#if DEBURR_HAS_VIEWER
constexpr bool has_viewer = true;
#else
constexpr bool has_viewer = false;
#endif

constexpr const char* png_mark = "\x89PNG\r\n\x1a\n";

/// A noisy and a clean cloud of the same points, and their true surface.
class CliView : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    const SyntheticScan scan = synthesize_part({.points = 500});
    write_cloud("noisy.ply", scan.cloud);
    PointCloud clean;
    clean.points = scan.clean;
    clean.normals = scan.normals;
    write_cloud("clean.ply", clean);
    write_mesh("truth.ply", scan.truth);
  }
};

/// A block of data in a page.
std::string block(const std::string& html, const std::string& name) {
  const std::size_t tag = html.find("<script id=\"deburr-" + name + "\"");
  if (tag == std::string::npos) return "";
  const std::size_t begin = html.find('>', tag) + 1;
  return html.substr(begin, html.find('<', begin) - begin);
}

void expect_error(const std::vector<std::string>& args, int code, const std::string& what) {
  const Outcome outcome = run_program(args);
  EXPECT_EQ(outcome.exit_code, code) << what;
  EXPECT_THAT(outcome.err, StartsWith("deburr: "));
  EXPECT_THAT(outcome.err, HasSubstr(what));
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(CliView, WithoutTheViewerItSaysWhatIsMissing) {
  if (has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has the page; -DDEBURR_VIEWER=OFF makes one without";
  }
  expect_error({"view", "noisy.ply", "-o", "x.html"}, 1, "Node.js");
  expect_error({"denoise", "noisy.ply", "out.ply", "--report", "x.html"}, 1, "-DDEBURR_VIEWER=ON");
  EXPECT_FALSE(std::filesystem::exists("out.ply"));
  EXPECT_FALSE(std::filesystem::exists("x.html"));
}

TEST_F(CliView, MakesAPageOfTwoClouds) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  const Outcome outcome = run_program({"view", "noisy.ply", "clean.ply", "-o", "x.html", "--truth",
                                       "truth.ply", "--up", "-y", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json told = json::parse(outcome.out);
  EXPECT_EQ(told["bytes"], std::filesystem::file_size("x.html"));
  EXPECT_EQ(told["paired"], true);
  EXPECT_EQ(told["inputs"][1]["shown"], 500);
  const std::string html = read_text("x.html");
  EXPECT_THAT(html, StartsWith("<!doctype html>"));
  const json scene = json::parse(block(html, "scene"));
  EXPECT_EQ(scene["clouds"][0]["name"], "noisy.ply");
  EXPECT_EQ(scene["up"], "-y");
  EXPECT_EQ(scene["displacement"]["signed"], true);
  EXPECT_LT(scene["truth"][1]["max"].get<double>(), 1e-6);
  EXPECT_GT(scene["truth"][0]["mean"].get<double>(), 0.1);
  EXPECT_EQ(block(html, "report"), "");
}

TEST_F(CliView, MakesAPageOfOneCloudOnStdout) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  const Outcome outcome = run_program({"view", "-", "-o", "-", "--quiet"}, "noisy.ply");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(block(outcome.out, "scene"))["clouds"].size(), 1U);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CliView, KeepsToItsSize) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  write_cloud("large.ply", synthesize_part({.points = 150'000, .noise = 0}).cloud);
  const Outcome outcome =
      run_program({"view", "large.ply", "-o", "x.html", "--max-size", "2", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_LE(std::filesystem::file_size("x.html"), 2'000'000U);
  EXPECT_LT(json::parse(outcome.out)["inputs"][0]["shown"], 150'000);
  EXPECT_GT(json::parse(outcome.out)["inputs"][0]["shown"], 50'000);
}

TEST_F(CliView, TheReportOfARunCanBeAPage) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  const Outcome outcome = run_program(
      {"denoise", "noisy.ply", "out.xyz", "--report", "R.HTML", "--outliers", "remove", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string html = read_text("R.HTML");
  EXPECT_EQ(json::parse(block(html, "report")), json::parse(outcome.out));
  const json scene = json::parse(block(html, "scene"));
  EXPECT_EQ(scene["paired"], true);
  EXPECT_EQ(scene["clouds"][0]["shown"], 500);
  EXPECT_EQ(scene["clouds"][1]["shown"], json::parse(outcome.out)["kept"]);
  EXPECT_EQ(scene["removed"], json::parse(outcome.out)["outliers"]);
  // Of the numbers that told the points apart nothing is left.
  EXPECT_EQ(lines_of(read_text("out.xyz"))[0].find("deburr"), std::string::npos);
  EXPECT_TRUE(read_cloud("out.xyz").attributes.empty());
}

TEST_F(CliView, AResultWithoutItsOutliersIsPairedWithItsInput) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  // Formats keep coordinates and the field in their own ways.
  for (const std::string name : {"out.ply", "out.las", "out.csv"}) {
    ASSERT_EQ(run_program({"synth", "part", "many.ply", "--points", "3000", "--outliers", "0.02"})
                  .exit_code,
              0);
    const Outcome run = run_program({"denoise", "many.ply", name, "--outliers", "remove", "--add",
                                     "normals,label,displacement", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Outcome page = run_program({"view", "many.ply", name, "-o", "x.html", "--json"});
    ASSERT_EQ(page.exit_code, 0) << page.err;
    EXPECT_EQ(json::parse(page.out)["paired"], true) << name;
    const json scene = json::parse(block(read_text("x.html"), "scene"));
    EXPECT_EQ(scene["removed"], json::parse(run.out)["outliers"]);
    EXPECT_GT(scene["removed"], 30);
    EXPECT_EQ(run_program({"render", name, "x.png", "--before", "many.ply", "--color",
                           "displacement", "--size=64x48"})
                  .exit_code,
              0);
  }
}

TEST_F(CliView, TheResultIsTheSameWithAPage) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  ASSERT_EQ(run_program({"denoise", "noisy.ply", "a.ply"}).exit_code, 0);
  ASSERT_EQ(run_program({"denoise", "noisy.ply", "b.ply", "--report", "r.html"}).exit_code, 0);
  EXPECT_EQ(read_text("a.ply"), read_text("b.ply"));
}

TEST_F(CliView, CloudsWithoutAFinitePointHaveAPage) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  write_text("nan.xyz", "nan nan nan\nnan 1 2\n");
  const Outcome outcome = run_program({"denoise", "nan.xyz", "o.xyz", "--report", "r.html"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(block(read_text("r.html"), "scene"))["clouds"][1]["shown"], 0);
}

TEST_F(CliView, RefusesWhatCannotBe) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  expect_error({"view", "noisy.ply"}, 2, "--output");
  expect_error({"view", "noisy.ply", "-o", "noisy.ply"}, 2,
               "--output noisy.ply would overwrite A noisy.ply");
  expect_error({"view", "noisy.ply", "-o", "x.html", "--max-size", "1"}, 2,
               "--max-size must be in");
  expect_error({"view", "noisy.ply", "-o", "x.html", "--max-size", "nan"}, 2, "--max-size");
  expect_error({"view", "missing.ply", "-o", "x.html"}, 3, "missing.ply");
  expect_error({"view", "noisy.ply", "-o", "no/x.html"}, 3, "no/x.html");
  EXPECT_FALSE(std::filesystem::exists("x.html"));
}

TEST_F(CliView, WarnsOfCloudsThatAreNotTheSamePoints) {
  if (!has_viewer) {
    GTEST_SKIP() << "NOT TESTED: this build has no page; Node.js and -DDEBURR_VIEWER=ON make one";
  }
  PointCloud mixed = read_cloud("clean.ply");
  std::ranges::rotate(mixed.points, mixed.points.begin() + 200);
  write_cloud("mixed.ply", mixed);
  const Outcome outcome = run_program({"view", "noisy.ply", "mixed.ply", "-o", "x.html"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("deburr: warning: noisy.ply and mixed.ply have as many points"));
}

TEST_F(CliView, RendersAPicture) {
  const Outcome outcome =
      run_program({"render", "noisy.ply", "x.png", "--size", "64x48", "--view", "top", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_text("x.png"), StartsWith(png_mark));
  const json told = json::parse(outcome.out);
  EXPECT_EQ(told["width"], 64);
  EXPECT_EQ(told["height"], 48);
  EXPECT_EQ(told["view"], "top");
  EXPECT_EQ(told["points"], 500);
  EXPECT_EQ(told["up"], "z");
  EXPECT_EQ(told["legend"], false);
  const Outcome piped =
      run_program({"render", "-", "-", "--size", "64x48", "--view", "top"}, "noisy.ply");
  EXPECT_EQ(piped.out, read_text("x.png"));
}

TEST_F(CliView, RendersWhatAFileHasOnly) {
  expect_error({"render", "noisy.ply", "x.png", "--color", "displacement"}, 4,
               "noisy.ply: no field deburr_displacement");
  expect_error({"render", "noisy.ply", "x.png", "--color", "labels"}, 4, "deburr_label");
  expect_error({"render", "noisy.ply", "x.png", "--color", "rgb"}, 4, "red green blue");
  const Outcome outcome = run_program({"render", "clean.ply", "x.png", "--before", "noisy.ply",
                                       "--color", "displacement", "--range", "0.5", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["range"], json::parse("[-0.5,0.5]"));
}

TEST_F(CliView, RendersWithAnotherAxisUp) {
  const auto picture = [&](const std::string& up) {
    const Outcome outcome =
        run_program({"render", "noisy.ply", "x.png", "--size", "64x48", "--up", up, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["up"], up);
    return read_text("x.png");
  };
  const std::string upright = picture("z");
  EXPECT_NE(picture("y"), upright);
  EXPECT_NE(picture("-z"), upright);
  expect_error({"render", "noisy.ply", "y.png", "--up", "w"}, 2, "--up");
  EXPECT_FALSE(std::filesystem::exists("y.png"));
}

TEST_F(CliView, ALegendCanBeLeftOut) {
  const std::vector<std::string> args{"render",       "clean.ply",      "x.png",
                                      "--before",     "noisy.ply",      "--color",
                                      "displacement", "--size=320x240", "--json"};
  const auto legend = [&](const std::vector<std::string>& all) {
    const Outcome outcome = run_program(all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)["legend"].get<bool>();
  };
  EXPECT_TRUE(legend(args));
  std::vector<std::string> without = args;
  without.emplace_back("--no-legend");
  EXPECT_FALSE(legend(without));
}

TEST_F(CliView, RefusesPicturesThatCannotBe) {
  for (const char* size : {"64", "64x", "x48", "64x48x1", "axb", "-1x5", "0x5", "99999x5"}) {
    const std::string option = std::string("--size=") + size;
    expect_error({"render", "noisy.ply", "x.png", option}, 2, "must be");
  }
  expect_error({"render", "noisy.ply", "noisy.ply"}, 2, "would overwrite");
  expect_error({"render", "noisy.ply", "x.png", "--before", "clean.ply"}, 2, "--before belongs to");
  expect_error({"render", "noisy.ply", "no/x.png"}, 3, "no/x.png");
  expect_error({"render", "noisy.ply", "x.png", "--range=-1", "--color", "displacement", "--before",
                "clean.ply"},
               2, "range must be >= 0");
  write_cloud("few.ply", synthesize_part({.points = 9}).cloud);
  expect_error({"render", "noisy.ply", "x.png", "--before", "few.ply", "--color", "displacement"},
               4, "9 points, not 500");
  EXPECT_FALSE(std::filesystem::exists("x.png"));
}

}  // namespace
}  // namespace deburr::cli
