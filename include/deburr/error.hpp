// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

// A caller's mistake (an option out of its range, spans of different lengths) throws
// std::invalid_argument naming the option and the value. The types below are for the rest.

namespace deburr {

/// A file that cannot be read or written.
class IoError : public std::runtime_error {
 public:
  /// @param path  the file
  /// @param what  what is wrong, with the place in the file ("line 7: ...", "byte 123: ...")
  IoError(const std::filesystem::path& path, const std::string& what)
      : std::runtime_error(path.string() + ": " + what), path_(path) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Well-formed data on which the request has no answer: normals asked to be kept where there are
/// none, neighbourhoods larger than any memory.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown out of a computation when Execution::cancelled returned true. Nothing was changed.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace deburr
