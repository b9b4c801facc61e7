// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <array>

#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// Exit codes and the one line that explains them.

namespace deburr::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class CliErrors : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_cloud("scan.ply", synthesize_part({.points = 100}).cloud);
    write_text("broken.ply",
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n1 2 3\n");
  }
};

void expect_failure(const std::vector<std::string>& args, int exit_code, const std::string& what) {
  const Outcome outcome = run_program(args);
  EXPECT_EQ(outcome.exit_code, exit_code) << what;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, StartsWith("deburr: "));
  EXPECT_THAT(outcome.err, HasSubstr(what));
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
}

TEST_F(CliErrors, WrongUsageIsExitCode2) {
  expect_failure({}, 2, "subcommand is required (see deburr --help)");
  expect_failure({"polish"}, 2, "unexpected argument polish");
  expect_failure({"denoise", "scan.ply"}, 2, "OUT is required (see deburr denoise --help)");
  expect_failure({"denoise", "scan.ply", "out.ply", "--strong"}, 2, "--strong");
  expect_failure({"denoise", "scan.ply", "out.ply", "--rounds", "many"}, 2, "--rounds");
  expect_failure({"denoise", "scan.ply", "out.ply", "--method", "magic"}, 2, "magic");
  expect_failure({"denoise", "scan.ply", "out.ply", "--add", "label,colour"}, 2, "colour");
  expect_failure({"denoise", "scan.ply", "out.ply", "--threads", "-1"}, 2,
                 "--threads: must be >= 0, got -1");
  expect_failure({"compare", "scan.ply"}, 2, "--truth is required");
  expect_failure({"synth", "cow", "out.ply"}, 2, "cow");
  expect_failure({"synth", "part", "out.ply", "--points", "-5"}, 2,
                 "--points: must be >= 0, got -5");
  expect_failure({"synth", "part", "out.ply", "--truth", "truth.xyz"}, 2, "--truth truth.xyz");
  expect_failure({"denoise", "scan.ply", "out.ply", "--threads", "100000000"}, 2, "[0, 256]");
  std::filesystem::create_symlink("missing/out.ply", "dangling.ply");
  expect_failure({"denoise", "scan.ply", "dangling.ply"}, 3, "dangling.ply");
  EXPECT_FALSE(std::filesystem::exists("out.ply"));
}

TEST_F(CliErrors, OptionsOutOfRangeAreExitCode2) {
  const auto yadav = [](const std::string& option, const std::string& value) {
    return std::vector<std::string>{"denoise",   "scan.ply", "out.ply", "--method",
                                    "yadav2018", option,     value};
  };
  expect_failure(yadav("--rho", "1"), 2, ": --rho must be in [0, 1), got 1");
  expect_failure(yadav("--tau", "nan"), 2, ": --tau must be");
  expect_failure(yadav("--k", "2"), 2, ": --k must be");
  expect_failure(yadav("--rounds", "-1"), 2, ": --rounds must be");
  expect_failure({"denoise", "scan.ply", "out.ply", "--strength", "6"}, 2,
                 ": --strength must be in [1, 5], got 6");
  expect_failure({"denoise", "scan.ply", "out.ply", "--max-move", "-1"}, 2, ": --max-move must be");
  expect_failure({"denoise", "scan.ply", "out.ply", "--noise", "nan"}, 2, ": --noise must be");
  expect_failure({"synth", "part", "out.ply", "--noise", "-1"}, 2, ": --noise must be");
}

// As a variable of the shell is that nobody has set.
TEST_F(CliErrors, EmptyNamesOfFilesAreExitCode2) {
  expect_failure({"denoise", "scan.ply", ""}, 2,
                 "deburr: OUT: must name a file, got an empty name (see deburr denoise --help)");
  expect_failure({"denoise", "", "out.ply"}, 2, "deburr: IN: must name");
  expect_failure({"denoise", "scan.ply", "out.ply", "--report", ""}, 2, "deburr: --report: must");
  expect_failure({"info", ""}, 2, "deburr: IN: must name");
  expect_failure({"synth", "part", ""}, 2, "deburr: OUT: must name");
  expect_failure({"synth", "part", "out.ply", "--truth", ""}, 2, "deburr: --truth: must name");
  expect_failure({"synth", "part", "out.ply", "--clean", ""}, 2, "deburr: --clean: must name");
  expect_failure({"compare", "scan.ply", "--truth", ""}, 2, "deburr: --truth: must name");
  const std::vector<std::string> compare{"compare", "scan.ply", "--truth", "scan.ply"};
  for (const char* option : {"--clean", "--distances"}) {
    std::vector<std::string> args = compare;
    args.insert(args.end(), {option, ""});
    expect_failure(args, 2, std::string("deburr: ") + option + ": must name");
  }
  expect_failure({"render", "scan.ply", ""}, 2, "deburr: OUT: must name");
  expect_failure({"render", "scan.ply", "out.png", "--before", ""}, 2, "deburr: --before: must");
  expect_failure({"view", "scan.ply", "-o", ""}, 2, "deburr: --output: must name");
  expect_failure({"view", "scan.ply", "", "-o", "a.html"}, 2, "deburr: B: must name");
  EXPECT_FALSE(std::filesystem::exists("out.ply"));
}

// The range is looked at before the file, which may take long to read.
TEST_F(CliErrors, OptionsAreCheckedBeforeTheInputIsRead) {
  expect_failure({"denoise", "broken.ply", "out.ply", "--strength", "0"}, 2, "strength");
  expect_failure({"denoise", "broken.ply", "out.docx"}, 2, "out.docx: the extension");
  expect_failure({"denoise", "broken.ply", "no/out.ply"}, 3, "no/out.ply");
}

TEST_F(CliErrors, OptionsOfTheOtherMethodAreExitCode2) {
  for (const std::string option :
       {"--rounds", "--k", "--rho", "--tau", "--damping", "--alpha", "--epsilon", "--radius"}) {
    expect_failure({"denoise", "scan.ply", "out.ply", option, "1"}, 2,
                   option + " belongs to --method yadav2018");
  }
  expect_failure({"denoise", "scan.ply", "out.ply", "--update", "in-place"}, 2, "--update belongs");
  expect_failure({"denoise", "scan.ply", "out.ply", "--neighborhoods", "once"}, 2,
                 "--neighborhoods belongs");
  for (const std::string option : {"--strength", "--max-move", "--noise"}) {
    expect_failure({"denoise", "scan.ply", "out.ply", "--method", "yadav2018", option, "1"}, 2,
                   option + " belongs to --method auto");
  }
  expect_failure(
      {"denoise", "scan.ply", "out.ply", "--method", "yadav2018", "--outliers", "remove"}, 2,
      "--outliers belongs");
}

TEST_F(CliErrors, FilesAreExitCode3) {
  expect_failure({"info", "missing.ply"}, 3, "missing.ply: ");
  expect_failure({"info", "broken.ply"}, 3, "broken.ply: ");
  expect_failure({"denoise", "missing.ply", "out.ply"}, 3, "missing.ply: ");
  expect_failure({"denoise", "scan.ply", "/proc/out.ply"}, 3, "/proc/out.ply: ");
  expect_failure({"denoise", "scan.ply", "out.ply", "--report", "no/r.json"}, 3, "no/r.json: ");
  expect_failure({"synth", "part", "no/out.ply"}, 3, "no/out.ply: ");
  expect_failure({"compare", "scan.ply", "--truth", "broken.ply"}, 3, "broken.ply: ");
  expect_failure({"compare", "scan.ply", "--truth", "scan.ply", "--clean", "missing.ply"}, 3,
                 "missing.ply: ");
  std::filesystem::create_directory("folder.ply");
  expect_failure({"denoise", "scan.ply", "folder.ply"}, 3, "folder.ply: is a folder");
}

// One line it stays, and terminals are not steered by a name.
TEST_F(CliErrors, ControlCharactersOfNamesAreWrittenAsText) {
  for (const auto& [name, shown] :
       {std::pair{"a\nb.ply", "a\\nb.ply"},
        {"a\tb\r.ply", "a\\tb\\x0d.ply"},
        {"\x1b[31m\x7f.ply", "\\x1b[31m\\x7f.ply"},
        {"a\xc2\x9b.ply", "a\\xc2\\x9b.ply"},
        {"gr\xc3\xbc\xc3\x9f \xc2.ply", "gr\xc3\xbc\xc3\x9f \xc2.ply"}}) {
    expect_failure({"info", name}, 3, std::string(shown) + ": No such file");
    expect_failure({"denoise", "scan.ply", std::string("no/") + name}, 3,
                   std::string("no/") + shown + ": cannot write");
    expect_failure({"denoise", "scan.ply", "o.ply", "--report", "o.ply", name}, 2, shown);
    const Outcome outcome = run_program({"denoise", "scan.ply", name, "--add", "none"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, testing::EndsWith(std::string("written to ") + shown + "\n"));
  }
}

TEST_F(CliErrors, DataWithoutAnAnswerAreExitCode4) {
  expect_failure({"denoise", "scan.ply", "out.ply", "--normals", "keep"}, 4, "scan.ply: normals");
  write_cloud("empty.ply", {});
  write_mesh("truth.ply", synthesize_part({.points = 1}).truth);
  expect_failure({"compare", "empty.ply", "--truth", "truth.ply"}, 4, "empty.ply: no finite point");
  expect_failure({"compare", "scan.ply", "--truth", "empty.ply"}, 4, "empty.ply: no finite point");
}

TEST_F(CliErrors, AFailureLeavesTheOutputAlone) {
  write_text("out.ply", "precious");
  expect_failure({"denoise", "broken.ply", "out.ply"}, 3, "broken.ply");
  EXPECT_EQ(read_text("out.ply"), "precious");
}

TEST_F(CliErrors, AFullDiskUnderStdoutIsExitCode3) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  if (full < 0) GTEST_SKIP() << "NOT TESTED: /dev/full, a full disk, is of Linux";
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  EXPECT_EQ(wait_for_exit(start_program({"info", "scan.ply"}, full, nothing)), 3);
  EXPECT_EQ(wait_for_exit(start_program({"--help"}, full, nothing)), 3);
  close(full);
  close(nothing);
}

TEST_F(CliErrors, AClosedPipeUnderStdoutIsExitCode3) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  close(ends[0]);
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  EXPECT_EQ(wait_for_exit(start_program({"info", "scan.ply"}, ends[1], nothing)), 3);
  close(ends[1]);
  close(nothing);
}

}  // namespace
}  // namespace deburr::cli
