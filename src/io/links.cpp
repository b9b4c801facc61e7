// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/links.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

namespace deburr {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  ///< as in the kernel

bool is_link(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(path, error);
}

/// One step of following a link, by hand, because the file at its end need not exist.
fs::path step_along(const fs::path& link) {
  std::error_code error;
  return link.parent_path() / fs::read_symlink(link, error);
}

/// The folder that a path is in, without links; empty if it does not exist.
fs::path real_folder(const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.parent_path();
  return fs::canonical(folder.empty() ? "." : folder, error);
}

/// Whether a folder holds the descriptors of this process.
bool holds_own_descriptors(const fs::path& folder) {
  constexpr std::array names{"/proc/self/fd", "/proc/thread-self/fd", "/dev/fd"};
  return !folder.empty() && std::ranges::any_of(names, [&](const char* name) {
    std::error_code error;
    return folder == fs::canonical(name, error);
  });
}

/// The number that a name of digits is.
std::optional<int> number_of(const fs::path& name) {
  const std::string& text = name.native();
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && number >= 0;
  return is_number ? std::optional(number) : std::nullopt;
}

/// The first of what `look` finds in a path, or in one of the links that it leads along.
template <typename Look>
auto find_along(fs::path path, const Look& look) {
  auto found = look(path);
  for (int i = 0; i < most_links && !found && is_link(path); ++i) {
    path = step_along(path);
    found = look(path);
  }
  return found;
}

}  // namespace

fs::path follow_links(fs::path path) {
  for (int i = 0; i < most_links && is_link(path); ++i) path = step_along(path);
  return path;
}

std::optional<int> own_descriptor(fs::path path) {
  return find_along(std::move(path), [](const fs::path& step) {
    const std::optional<int> number = number_of(step.filename());
    return number && holds_own_descriptors(real_folder(step)) ? number : std::nullopt;
  });
}

bool leads_through_descriptor(fs::path path) {
  return find_along(std::move(path), [](const fs::path& step) {
    const fs::path folder = real_folder(step);
    return folder.filename() == "fd" && folder.native().starts_with("/proc/");
  });
}

}  // namespace deburr
