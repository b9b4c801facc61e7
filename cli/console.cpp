// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "deburr/error.hpp"

namespace deburr::cli {
namespace {

constexpr double first_shown = 0.5;  // seconds
constexpr double interval = 0.1;     // seconds
constexpr int bar_width = 24;
constexpr int line_width = 72;

std::string remaining(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s left", std::ceil(seconds));
  const double minutes = std::ceil(seconds / 60);
  if (minutes < 60) return fmt::format("{:.0f} min left", minutes);
  return fmt::format("{:.1f} h left", seconds / 3600);
}

}  // namespace

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw IoError("standard output", std::strerror(errno));
  }
}

std::string as_line(std::string_view text) {
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte == '\n') {
      line += "\\n";
    } else if (byte == '\t') {
      line += "\\t";
    } else if (byte < 0x20 || byte == 0x7f) {
      line += fmt::format("\\x{:02x}", byte);
    } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {  // U+0080 to U+009F
      line += fmt::format("\\x{:02x}\\x{:02x}", byte, next);
      ++i;
    } else {
      line += text[i];
    }
  }
  return line + '\n';
}

std::string warning_line(std::string_view text) {
  return as_line(fmt::format("deburr: warning: {}", text));
}

void tell(const std::string& text) { (void)std::fputs(text.c_str(), stderr); }

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProgressBar::ProgressBar(bool quiet)
    : enabled_(!quiet && isatty(STDERR_FILENO) != 0),
      start_(steady_seconds()),
      next_(start_ + first_shown) {}

void ProgressBar::update(const Progress& progress) {
  if (!enabled_) return;
  const double now = steady_seconds();
  if (now < next_) return;
  next_ = now + interval;
  const double done = progress.fraction;
  const int cells = static_cast<int>(done * bar_width);
  const std::string left = done > 0 ? remaining((now - start_) * (1 - done) / done) : std::string();
  const std::string line = fmt::format("{:>3.0f} % [{:<{}}] {} {}", 100 * done,
                                       std::string(static_cast<std::size_t>(cells), '#'), bar_width,
                                       progress.stage, left);
  // Blanks instead of a terminal's control codes wipe what an earlier, longer line left.
  tell(fmt::format("\r{:<{}.{}}", line, line_width, line_width));
  visible_ = true;
}

std::function<void(const Progress&)> ProgressBar::part(std::string_view stage, double from,
                                                       double to) {
  return [this, stage, from, to](const Progress& inner) {
    update({stage, from + (to - from) * inner.fraction});
  };
}

void ProgressBar::clear() {
  if (visible_) tell(fmt::format("\r{:{}}\r", "", line_width));
  visible_ = false;
}

}  // namespace deburr::cli
