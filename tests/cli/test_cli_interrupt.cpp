// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// Ctrl-C, with a terminal as stderr: its progress bar is the sign that the work has begun.

namespace deburr::cli {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr int patience = 60000;  // milliseconds

class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) return;
    slave_ =
        open(ptsname(master_), O_RDWR | O_NOCTTY | O_CLOEXEC);  // NOLINT(concurrency-mt-unsafe)
  }
  ~Terminal() {
    close_slave();
    if (master_ >= 0) close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] int slave() const { return slave_; }
  void close_slave() {
    if (slave_ >= 0) close(slave_);
    slave_ = -1;
  }

  /// Reads until the text is there, or, without a text, until nobody writes any more.
  std::string read_until(const std::string& text) {
    std::string seen;
    std::array<char, 512> buffer{};
    pollfd ready{master_, POLLIN, 0};
    while (text.empty() || seen.find(text) == std::string::npos) {
      if (poll(&ready, 1, patience) <= 0) break;
      const ssize_t count = read(master_, buffer.data(), buffer.size());
      if (count <= 0) break;
      seen.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return seen;
  }

 private:
  int master_ = -1;
  int slave_ = -1;
};

class CliInterrupt : public CliTest, public testing::WithParamInterface<int> {};

TEST_P(CliInterrupt, StopsALongRunAndWritesNothing) {
  write_cloud("scan.ply", synthesize_part({.points = 200000}).cloud);
  write_text("out.ply", "precious");
  const std::string scan = read_text("scan.ply");

  Terminal terminal;
  ASSERT_GE(terminal.slave(), 0);
  const pid_t process =
      start_program({"denoise", "scan.ply", "out.ply", "--method", "yadav2018", "--rounds", "1000"},
                    terminal.slave(), terminal.slave());
  terminal.close_slave();
  EXPECT_THAT(terminal.read_until("%"), HasSubstr("%"));
  ASSERT_EQ(kill(process, GetParam()), 0);
  const std::string rest = terminal.read_until("");
  EXPECT_EQ(wait_for_exit(process), 130);

  // The bar is wiped before the message, which is the last word.
  EXPECT_THAT(rest, EndsWith(" \rdeburr: interrupted, nothing was written\r\n"));
  EXPECT_EQ(read_text("out.ply"), "precious");
  EXPECT_EQ(read_text("scan.ply"), scan);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator("."), {}), 2);
}

INSTANTIATE_TEST_SUITE_P(Signals, CliInterrupt, testing::Values(SIGINT, SIGTERM));

TEST_F(CliTest, ShowsNoProgressWhereStderrIsNoTerminal) {
  write_cloud("scan.ply", synthesize_part({.points = 30000}).cloud);
  const Outcome outcome = run_program({"denoise", "scan.ply", "out.ply"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err.find_first_of("\r%"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace deburr::cli
