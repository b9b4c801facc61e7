// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace deburr::cli {

/// How a run of the program ended.
struct Outcome {
  int exit_code = 0;  ///< 128 + signal where a signal ended it
  std::string out;
  std::string err;
};

/// In place of a descriptor: the program finds the stream closed.
inline constexpr int closed = -2;

/// Starts the program with these file descriptors as its stdout, stderr and maybe stdin. It is
/// killed after two minutes, so that no test can hang.
[[nodiscard]] pid_t start_program(const std::vector<std::string>& args, int out, int err,
                                  int in = -1);

/// Waits for its end; 128 + signal where a signal ended it.
[[nodiscard]] int wait_for_exit(pid_t process);

/// Runs the program to its end.
/// @param input  a file for its stdin
[[nodiscard]] Outcome run_program(const std::vector<std::string>& args,
                                  const std::filesystem::path& input = {});

[[nodiscard]] std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// Each test runs in an empty folder of its own, which is removed afterwards.
class CliTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

 private:
  std::filesystem::path before_;
  std::filesystem::path folder_;
};

}  // namespace deburr::cli
