// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "places.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <stdexcept>

#include "io/links.hpp"

namespace deburr::cli {
namespace {

namespace fs = std::filesystem;

/// Where a path leads.
struct Place {
  std::optional<int> descriptor{};  ///< if it is open already
  bool is_known = false;            ///< what follows is
  bool is_regular = true;           ///< or will be
  dev_t device{};                   ///< of the file, or of the folder that it will be in
  ino_t inode{};
  std::string name{};  ///< in that folder, of a file that is not there yet
};

Place place_of(const std::string& path, int standard_stream) {
  Place place;
  place.descriptor = path == "-" ? standard_stream : own_descriptor(path);
  struct stat status {};
  if (place.descriptor) {
    place.is_known = fstat(*place.descriptor, &status) == 0;
  } else if (stat(path.c_str(), &status) == 0) {
    place.is_known = true;
  } else {
    const fs::path target = follow_links(path);
    const fs::path folder = target.parent_path();
    place.is_known = stat(folder.empty() ? "." : folder.c_str(), &status) == 0;
    place.name = target.filename();
    status.st_mode = S_IFREG;
  }
  // Devices take what they get from anyone.
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) place.is_known = false;
  place.is_regular = S_ISREG(status.st_mode);
  place.device = status.st_dev;
  place.inode = status.st_ino;
  return place;
}

bool same(const Place& a, const Place& b) {
  if (a.descriptor && a.descriptor == b.descriptor) return true;
  return a.is_known && b.is_known && a.device == b.device && a.inode == b.inode && a.name == b.name;
}

std::string name_of(const NamedPath& given) {
  return given.is_implied ? given.option : given.option + " " + given.path;
}

/// Calls `refuse(a, b)` for every two paths of a list that lead to one place.
template <typename Refuse>
void for_pairs(const std::vector<NamedPath>& paths, int standard_stream, const Refuse& refuse) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (paths[i].path.empty() || paths[k].path.empty()) continue;
      const Place a = place_of(paths[k].path, standard_stream);
      const Place b = place_of(paths[i].path, standard_stream);
      if (same(a, b)) refuse(a, b, name_of(paths[k]) + " and " + name_of(paths[i]));
    }
  }
}

}  // namespace

NamedPath json_output(bool json) {
  return {.option = "--json", .path = json ? "-" : "", .is_implied = true};
}

bool is_open_stream(const std::string& path) { return path == "-" || own_descriptor(path); }

void check_apart(const std::vector<NamedPath>& outputs) {
  for_pairs(outputs, STDOUT_FILENO, [](const Place&, const Place&, const std::string& both) {
    throw std::invalid_argument(both + " would be written to the same place");
  });
}

void check_inputs(const std::vector<NamedPath>& inputs) {
  for_pairs(inputs, STDIN_FILENO, [](const Place& a, const Place& b, const std::string& both) {
    // A file can be opened twice.
    if (a.is_regular && (!a.descriptor || a.descriptor != b.descriptor)) return;
    throw std::invalid_argument(both + " would be read from the same stream");
  });
}

void check_kept(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) {
  for (const NamedPath& output : outputs) {
    for (const NamedPath& input : inputs) {
      if (output.path.empty() || input.path.empty()) continue;
      const Place place = place_of(output.path, STDOUT_FILENO);
      // A socket or a terminal can be both.
      if (!place.is_regular || !same(place, place_of(input.path, STDIN_FILENO))) continue;
      throw std::invalid_argument(
          fmt::format("{} would overwrite {}", name_of(output), name_of(input)));
    }
  }
}

}  // namespace deburr::cli
