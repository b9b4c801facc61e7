// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "args.hpp"

#include <fmt/ranges.h>

#include "deburr/io.hpp"
#include "deburr/version.hpp"

namespace deburr::cli {

void add_common_options(CLI::App& command, CommonArgs& args, const char* examples) {
  command.add_option("--threads", args.threads, "Number of threads; 0 uses every core")
      ->check(refuse_negative)
      ->option_text(fmt::format("N [{}]", args.threads));
  command.add_flag("--json", args.json, "Print one JSON object on stdout instead of text");
  command.add_flag("--quiet", args.quiet, "Print nothing on stderr but errors");
  command.set_version_flag("--version", fmt::format("deburr {}", version), "Print the version");
  command.footer(fmt::format("Examples:\n{}", examples));
}

void add_in_format(CLI::App& command, std::string& format) {
  command
      .add_option("--in-format", format,
                  "Format of the input, e.g. csv; without it, its content and extension tell")
      ->option_text("NAME");
}

void add_format(CLI::App& command, std::string& format) {
  command
      .add_option(
          "--format", format,
          fmt::format("Format of OUT instead of its extension: {}", fmt::join(format_names(), " ")))
      ->option_text("NAME");
}

std::string refuse_negative(const std::string& number) {
  return number.find('-') == std::string::npos ? "" : "must be >= 0, got " + number;
}

std::string refuse_no_name(const std::string& path) {
  return path.empty() ? "must name a file, got an empty name" : "";
}

std::string with_option_name(const CLI::App& command, const std::string& message) {
  const std::size_t end = message.find(" must be ");
  if (end == std::string::npos) return message;
  std::string name = message.substr(0, end);
  name.erase(0, name.rfind('.') + 1);
  std::ranges::replace(name, '_', '-');
  name.insert(0, "--");
  if (command.get_option_no_throw(name) == nullptr) return message;
  return name + message.substr(end);
}

CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& value,
                      const std::string& description) {
  return command.add_option(name, value, description)
      ->required()
      ->type_name("")
      ->check(refuse_no_name);
}

CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& value,
                             const std::string& description, const std::string& kind) {
  return command.add_option(name, value, description)->option_text(kind)->check(refuse_no_name);
}

}  // namespace deburr::cli
