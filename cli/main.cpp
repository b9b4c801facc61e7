// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "args.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "deburr/error.hpp"
#include "deburr/version.hpp"
#include "interrupt.hpp"

namespace deburr::cli {
namespace {

enum ExitCode { ok = 0, other = 1, usage = 2, file = 3, data = 4, stopped = 130 };

int fail(ExitCode code, const std::string& message) {
  tell(as_line(fmt::format("deburr: {}", message)));
  return code;
}

/// What was wrong, and where the user finds out what is right.
std::string explain(const CLI::App& program, std::string message) {
  std::string command = "deburr";
  for (const CLI::App* sub : program.get_subcommands()) {
    command += " " + sub->get_name();
    message = with_option_name(*sub, message);
  }
  // A word that is not known explains why another one is missing.
  const std::vector<std::string> unknown = program.remaining(true);
  return fmt::format("{} (see {} --help)",
                     unknown.empty() ? message : "unexpected argument " + unknown.front(), command);
}

void add_commands(CLI::App& program) {
  program.require_subcommand(1);
  program.get_formatter()->column_width(36);
  program.set_version_flag("--version", fmt::format("deburr {}", version), "Print the version");
  add_denoise_command(program);
  add_info_command(program);
  add_synth_command(program);
  add_compare_command(program);
  add_view_command(program);
  add_render_command(program);
}

int run(int argc, const char* const* argv) {
  CLI::App program("Takes the noise off point clouds and keeps their edges and corners.", "deburr");
  add_commands(program);
  try {
    program.parse(argc, argv);
    return ok;
  } catch (const CLI::Success& request) {  // --help or --version
    std::ostringstream text;
    program.exit(request, text, text);
    print(text.str());
    return ok;
  } catch (const CLI::ParseError& error) {
    return fail(usage, explain(program, error.what()));
  } catch (const std::invalid_argument& error) {
    return fail(usage, explain(program, error.what()));
  }
}

/// Opens what is closed of stdin, stdout and stderr, so that no file takes the place of one and
/// gets what is meant for it. The direction is the wrong one: whoever uses it is told.
void hold_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(fd, F_GETFD) >= 0) continue;
    (void)open("/dev/null", (fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) | O_CLOEXEC);
  }
}

int guarded_run(int argc, const char* const* argv) {
  try {
    return run(argc, argv);
  } catch (const Cancelled&) {
    return fail(stopped, "interrupted, nothing was written");
  } catch (const IoError& error) {
    return fail(file, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(file, error.what());
  } catch (const DataError& error) {
    return fail(data, error.what());
  } catch (const std::bad_alloc&) {
    return fail(other, "out of memory");
  } catch (const std::length_error&) {  // a container asked for more than can be addressed
    return fail(other, "out of memory");
  } catch (const std::exception& error) {
    return fail(other, error.what());
  }
}

}  // namespace
}  // namespace deburr::cli

int main(int argc, char** argv) {
  deburr::cli::hold_standard_streams();
  // A closed pipe, or a file beyond the size allowed, is then an error of the write, told like any
  // other.
  (void)std::signal(SIGPIPE, SIG_IGN);
  (void)std::signal(SIGXFSZ, SIG_IGN);
  deburr::cli::catch_interrupts();
  return deburr::cli::guarded_run(argc, argv);
}
