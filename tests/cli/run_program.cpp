// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "run_program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

namespace deburr::cli {
namespace {

constexpr unsigned longest_run = 120;  // seconds

using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

void give(int fd, int as) { fd == closed ? (void)close(as) : (void)dup2(fd, as); }

std::string contents(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}

}  // namespace

pid_t start_program(const std::vector<std::string>& args, int out, int err, int in) {
  std::vector<std::string> words{DEBURR_PROGRAM};
  words.insert(words.end(), args.begin(), args.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) {
    if (in != -1) give(in, STDIN_FILENO);
    give(out, STDOUT_FILENO);
    give(err, STDERR_FILENO);
    (void)alarm(longest_run);
    (void)execv(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

int wait_for_exit(pid_t process) {
  int status = 0;
  if (waitpid(process, &status, 0) != process) return -1;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

Outcome run_program(const std::vector<std::string>& args, const std::filesystem::path& input) {
  const TemporaryFile in(input.empty() ? nullptr : std::fopen(input.c_str(), "r"), std::fclose);
  const TemporaryFile out(std::tmpfile(), std::fclose);
  const TemporaryFile err(std::tmpfile(), std::fclose);
  Outcome outcome;
  outcome.exit_code = wait_for_exit(start_program(args, fileno(out.get()), fileno(err.get()),
                                                  in != nullptr ? fileno(in.get()) : -1));
  outcome.out = contents(out.get());
  outcome.err = contents(err.get());
  return outcome;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void CliTest::SetUp() {
  before_ = std::filesystem::current_path();
  std::string name = std::filesystem::temp_directory_path() / "deburr-cli-XXXXXX";
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  folder_ = name;
  std::filesystem::current_path(folder_);
}

void CliTest::TearDown() {
  std::filesystem::current_path(before_);
  std::filesystem::remove_all(folder_);
}

}  // namespace deburr::cli
