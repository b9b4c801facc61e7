// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// What is open already: "-", and the paths by which the system knows it.

namespace deburr::cli {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Args = std::vector<std::string>;

const Args stdout_names{"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "./link"};
const Args stdin_names{"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0", "./link"};

class CliStreams : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_cloud("scan.ply", scan);
  }

  /// Runs the program with a file as its stdout in which something stands already.
  static std::string appended(const Args& args) {
    write_text("stream", "");
    const int out = open("stream", O_WRONLY | O_CLOEXEC);
    const int err = open("messages", O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    EXPECT_EQ(write(out, "before\n", 7), 7);
    EXPECT_EQ(wait_for_exit(start_program(args, out, err)), 0) << read_text("messages");
    EXPECT_EQ(write(out, "after\n", 6), 6);
    close(err);
    close(out);
    const std::string text = read_text("stream");
    EXPECT_THAT(text, StartsWith("before\n"));
    EXPECT_THAT(text, EndsWith("after\n"));
    return text.substr(7, text.size() - 13);
  }

  const PointCloud scan = synthesize_part({.points = 300}).cloud;
};

TEST_F(CliStreams, StdoutIsWrittenFromWhereItStands) {
  std::filesystem::create_symlink("/dev/stdout", "link");
  ASSERT_EQ(run_program({"denoise", "scan.ply", "out.ply"}).exit_code, 0);
  const std::string expected = read_text("out.ply");
  for (const std::string& name : stdout_names) {
    EXPECT_EQ(appended({"denoise", "scan.ply", name}), expected) << name;
  }
}

TEST_F(CliStreams, EveryOutputCanBeAStream) {
  ASSERT_EQ(run_program(
                {"synth", "cube", "a.ply", "--points", "9", "--truth", "t.ply", "--clean", "c.ply"})
                .exit_code,
            0);
  ASSERT_EQ(run_program({"render", "scan.ply", "a.png", "--size", "20x10"}).exit_code, 0);
  for (const std::string name : {"-", "/dev/stdout"}) {
    const Args synth{"synth", "cube", "--points", "9"};
    const auto with = [](Args args, const Args& more) {
      args.insert(args.end(), more.begin(), more.end());
      return args;
    };
    EXPECT_EQ(appended(with(synth, {name})), read_text("a.ply"));
    EXPECT_EQ(appended(with(synth, {"b.ply", "--truth", name})), read_text("t.ply"));
    EXPECT_EQ(appended(with(synth, {"b.ply", "--clean", name})), read_text("c.ply"));
    EXPECT_EQ(appended({"render", "scan.ply", name, "--size", "20x10"}), read_text("a.png"));
    const std::string report = appended({"denoise", "scan.ply", "b.ply", "--report", name});
    EXPECT_EQ(nlohmann::json::parse(report)["points"], 300);
    EXPECT_FALSE(std::filesystem::exists("-"));
  }
}

TEST_F(CliStreams, OneStreamDoesNotHoldTwoThings) {
  std::filesystem::create_symlink("/dev/stdout", "link");
  const auto refused = [](const Args& args, const std::string& what) {
    const Outcome outcome = run_program(args);
    EXPECT_EQ(outcome.exit_code, 2) << what;
    EXPECT_THAT(outcome.out, IsEmpty()) << what;
    EXPECT_THAT(outcome.err, StartsWith("deburr: " + what + " would be written to the same place"));
  };
  for (const std::string& name : stdout_names) {
    refused({"denoise", "scan.ply", name, "--json"}, "OUT " + name + " and --json");
    refused({"denoise", "scan.ply", name, "--report", "-"}, "OUT " + name + " and --report -");
    refused({"denoise", "scan.ply", "x.ply", "--report", name, "--json"},
            "--report " + name + " and --json");
    refused({"synth", "cube", "-", "--truth", name}, "OUT - and --truth " + name);
    refused({"synth", "cube", "x.ply", "--clean", name, "--json"},
            "--clean " + name + " and --json");
    refused({"compare", "scan.ply", "--truth", "scan.ply", "--distances", name},
            "--distances " + name + " and the figures");
    refused({"render", "scan.ply", name, "--json"}, "OUT " + name + " and --json");
    refused({"view", "scan.ply", "-o", name, "--json"}, "--output " + name + " and --json");
  }
  EXPECT_FALSE(std::filesystem::exists("x.ply"));
}

// The shell has opened the file by then; a rename would take its name away from what is printed.
TEST_F(CliStreams, TheFileUnderStdoutIsNoOutput) {
  const int out = open("out.ply", O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const int err = open("messages", O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  EXPECT_EQ(wait_for_exit(start_program({"denoise", "scan.ply", "out.ply", "--json"}, out, err)),
            2);
  EXPECT_EQ(wait_for_exit(start_program({"denoise", "scan.ply", "out.ply"}, out, err)), 0);
  close(err);
  close(out);
  EXPECT_EQ(read_cloud("out.ply").size(), 300U);
}

// A file is replaced by what came out of it, but nothing is appended to the file that is read.
TEST_F(CliStreams, TheInputIsNotAppendedTo) {
  write_cloud("scan.xyz", scan);
  const std::string before = read_text("scan.xyz");
  const int out = open("scan.xyz", O_WRONLY | O_APPEND | O_CLOEXEC);
  const int err = open("messages", O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  for (const char* name : {"-", "/dev/stdout"}) {
    EXPECT_EQ(
        wait_for_exit(start_program({"denoise", "scan.xyz", name, "--format", "xyz"}, out, err)),
        2);
  }
  close(err);
  close(out);
  EXPECT_THAT(read_text("messages"), HasSubstr("OUT - would overwrite IN scan.xyz"));
  EXPECT_EQ(read_text("scan.xyz"), before);
}

TEST_F(CliStreams, StdinIsReadFromWhereItStands) {
  std::filesystem::create_symlink("/dev/stdin", "link");
  write_text("stream", "before\n" + read_text("scan.ply"));
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const std::string& name : stdin_names) {
    const int in = open("stream", O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(lseek(in, 7, SEEK_SET), 7);
    EXPECT_EQ(wait_for_exit(start_program({"denoise", name, "out.ply"}, nothing, nothing, in)), 0);
    close(in);
    EXPECT_TRUE(read_cloud("out.ply").points == denoise(scan).cloud.points) << name;
  }
  close(nothing);
  write_mesh("mesh.ply", synthesize_part({.points = 1}).truth);
  EXPECT_EQ(run_program({"synth", "-", "out.ply", "--points", "9"}, "mesh.ply").exit_code, 0);
}

// The next file that is opened would get the number of a closed stream, and what is printed there.
TEST_F(CliStreams, NothingTakesThePlaceOfAClosedStream) {
  ASSERT_EQ(run_program({"denoise", "scan.ply", "out.ply"}).exit_code, 0);
  const std::string expected = read_text("out.ply");
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  const auto run_closed = [nothing](const Args& args) {
    std::filesystem::remove("out.ply");
    return wait_for_exit(start_program(args, closed, closed, nothing));
  };
  EXPECT_EQ(run_closed({"denoise", "scan.ply", "out.ply", "--json"}), 3);
  EXPECT_FALSE(std::filesystem::exists("out.ply"));
  EXPECT_EQ(run_closed({"denoise", "scan.ply", "out.ply", "--report", "report.json"}), 0);
  EXPECT_EQ(read_text("out.ply"), expected);
  EXPECT_THAT(read_text("report.json"), EndsWith("}\n"));
  EXPECT_EQ(run_closed({"denoise", "scan.ply", "-"}), 3);
  EXPECT_EQ(wait_for_exit(start_program({"info", "-"}, nothing, nothing, closed)), 3);
  close(nothing);
}

TEST_F(CliStreams, StreamsThatCannotBeWrittenAreExitCode3) {
  const Outcome reading = run_program({"denoise", "scan.ply", "/dev/stdin"}, "scan.ply");
  EXPECT_EQ(reading.exit_code, 3);
  EXPECT_EQ(reading.err, "deburr: /dev/stdin: is not open for writing\n");
  const Outcome closed =
      run_program({"denoise", "scan.ply", "x.ply", "--report", "/proc/self/fd/999"});
  EXPECT_EQ(closed.exit_code, 3);
  EXPECT_EQ(closed.err, "deburr: /proc/self/fd/999: Bad file descriptor\n");
  EXPECT_FALSE(std::filesystem::exists("x.ply"));
}

// Before the input is read, which may take long.
TEST_F(CliStreams, AClosedStdoutIsNoOutput) {
  for (const auto& [name, told] :
       {std::pair{"-", "standard output"}, {"/dev/stdout", "/dev/stdout"}}) {
    const int err = open("messages", O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    EXPECT_EQ(wait_for_exit(start_program({"denoise", "missing.ply", name}, closed, err)), 3);
    close(err);
    EXPECT_EQ(read_text("messages"),
              std::string("deburr: ") + told + ": is not open for writing\n");
  }
}

}  // namespace
}  // namespace deburr::cli
