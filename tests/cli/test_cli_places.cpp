// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// Two paths that lead to one place, and names that promise another kind of file.

namespace deburr::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Args = std::vector<std::string>;

class CliPlaces : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_cloud("scan.ply", synthesize_part({.points = 100}).cloud);
    write_mesh("mesh.ply", synthesize_part({.points = 1}).truth);
    fs::create_directories("folder/inner");
    fs::create_symlink("folder", "link");
    fs::create_symlink("folder/new.ply", "dangling.ply");
    fs::create_symlink("dangling.ply", "chain.ply");
  }

  /// The program says no before it does anything.
  static void expect_refusal(const Args& args, const std::string& what) {
    const Outcome outcome = run_program(args);
    EXPECT_EQ(outcome.exit_code, 2) << what;
    EXPECT_THAT(outcome.out, IsEmpty()) << what;
    EXPECT_THAT(outcome.err, StartsWith("deburr: " + what + " (see deburr " + args[0]));
    EXPECT_FALSE(fs::exists("new.ply") || fs::exists("folder/new.ply")) << what;
  }
};

std::string same_place(const std::string& first, const std::string& second) {
  return first + " and " + second + " would be written to the same place";
}

TEST_F(CliPlaces, OneFileCannotBeTwoOutputs) {
  const std::vector<std::pair<std::string, std::string>> same{
      {"new.ply", "new.ply"},
      {"new.ply", "./new.ply"},
      {"new.ply", fs::current_path() / "new.ply"},
      {"folder/new.ply", "link/new.ply"},
      {"folder/new.ply", "folder/inner/../new.ply"},
      {"dangling.ply", "folder/new.ply"},
      {"chain.ply", "link/new.ply"}};
  for (const auto& [a, b] : same) {
    for (const auto& [out, other] : {std::pair{a, b}, std::pair{b, a}}) {
      expect_refusal({"denoise", "scan.ply", out, "--report", other},
                     same_place("OUT " + out, "--report " + other));
      expect_refusal({"synth", "cube", out, "--truth", other},
                     same_place("OUT " + out, "--truth " + other));
      expect_refusal({"synth", "cube", out, "--clean", other},
                     same_place("OUT " + out, "--clean " + other));
      expect_refusal({"synth", "cube", "other.ply", "--truth", out, "--clean", other},
                     same_place("--truth " + out, "--clean " + other));
    }
  }
}

TEST_F(CliPlaces, FilesOfOneNameInTwoFoldersAreTwo) {
  const Args args{"synth",   "cube",           "new.ply",
                  "--truth", "folder/new.ply", "--points",
                  "9",       "--clean",        "folder/inner/new.ply"};
  EXPECT_EQ(run_program(args).exit_code, 0);
  EXPECT_EQ(read_cloud("new.ply").size(), 9U);
  EXPECT_EQ(read_mesh("folder/new.ply").triangles.size(), 12U);
  EXPECT_EQ(read_cloud("folder/inner/new.ply").size(), 9U);
  // Now that they are there.
  EXPECT_EQ(run_program(args).exit_code, 0);
}

TEST_F(CliPlaces, AnInputIsNotOverwrittenByAnotherOutput) {
  fs::create_symlink("scan.ply", "same.ply");
  fs::create_hard_link("scan.ply", "same.json");
  for (const char* const same : {"scan.ply", "./scan.ply", "same.ply", "same.json"}) {
    expect_refusal({"denoise", "scan.ply", "new.ply", "--report", same},
                   std::string("--report ") + same + " would overwrite IN scan.ply");
  }
  expect_refusal({"synth", "mesh.ply", "link/../mesh.ply"},
                 "OUT link/../mesh.ply would overwrite SHAPE_OR_MESH mesh.ply");
  expect_refusal({"compare", "scan.ply", "--truth", "mesh.ply", "--distances", "./mesh.ply"},
                 "--distances ./mesh.ply would overwrite --truth mesh.ply");
  expect_refusal({"view", "mesh.ply", "scan.ply", "-o", "same.ply"},
                 "--output same.ply would overwrite B scan.ply");
  expect_refusal({"render", "mesh.ply", "same.ply", "--before", "scan.ply"},
                 "OUT same.ply would overwrite --before scan.ply");
}

TEST_F(CliPlaces, DevicesTakeEverything) {
  EXPECT_EQ(
      run_program({"denoise", "scan.ply", "/dev/null", "--format", "ply", "--report", "/dev/null"})
          .exit_code,
      0);
}

TEST_F(CliPlaces, OneStreamIsNotReadTwice) {
  const auto refused = [](const Args& args, const std::string& what) {
    const Outcome outcome = run_program(args, "scan.ply");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, StartsWith("deburr: " + what + " would be read from the same stream"));
  };
  refused({"view", "-", "-", "-o", "x.html"}, "A - and B -");
  refused({"view", "-", "scan.ply", "--truth", "/dev/stdin", "-o", "x.html"},
          "A - and --truth /dev/stdin");
  refused({"compare", "-", "--truth", "-"}, "CLOUD - and --truth -");
  refused({"compare", "scan.ply", "--truth", "-", "--clean", "/dev/fd/0"},
          "--truth - and --clean /dev/fd/0");
  refused({"render", "-", "x.png", "--before", "-", "--color", "displacement"},
          "CLOUD - and --before -");
  ASSERT_EQ(mkfifo("pipe", 0600), 0);
  refused({"compare", "pipe", "--truth", "./pipe"}, "CLOUD pipe and --truth ./pipe");
  // A file can be read as often as one likes.
  EXPECT_EQ(run_program({"compare", "-", "--truth", "scan.ply"}, "scan.ply").exit_code, 0);
}

TEST_F(CliPlaces, NamesTellWhatAFileHolds) {
  for (const std::string name : {"out.jpg", "out", "out.png.ply"}) {
    expect_refusal({"render", "scan.ply", name}, "OUT " + name + ": a picture is written as .png");
    expect_refusal({"view", "scan.ply", "-o", name},
                   "--output " + name + ": a page is written as .html or .htm");
    EXPECT_FALSE(fs::exists(name));
  }
  expect_refusal({"synth", "cube", "new.ply", "--truth", "new.stl"},
                 "--truth new.stl: a mesh is written as .ply");
  EXPECT_EQ(run_program({"render", "scan.ply", "out.PNG", "--size", "8x8"}).exit_code, 0);
  EXPECT_EQ(run_program({"render", "scan.ply", "/dev/null", "--size", "8x8"}).exit_code, 0);
}

}  // namespace
}  // namespace deburr::cli
