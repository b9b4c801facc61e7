// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace deburr {

/// A file in memory, with what a reader needs beside it.
struct Source {
  std::filesystem::path path;
  std::string_view data;
  std::function<bool()> cancelled{};
  std::shared_ptr<const char> owner{};  ///< of the data, where load() has read them

  /// Throws Cancelled if the caller has asked to stop.
  void check_cancelled() const;
  /// Throws an IoError about this file.
  [[noreturn]] void fail(const std::string& what) const;
};

/// Reads a whole file, or a pipe up to its end; "-" is the standard input. What is open already
/// (/dev/stdin, /dev/fd/3) is read from where it stands.
/// @throws IoError  if it cannot be read
[[nodiscard]] Source load(const std::filesystem::path& path,
                          const std::function<bool()>& cancelled = {});

/// Whether a byte tells that a file is no text.
[[nodiscard]] constexpr bool is_binary_byte(char c) {
  const auto byte = static_cast<unsigned char>(c);
  constexpr unsigned char of_ms_dos = 0x1a;  // at the end of old texts
  return byte == 127 || (byte < 32 && (byte < '\t' || byte > '\r') && byte != of_ms_dos);
}

/// Name of the kind of file for those that are often taken for a point cloud, else empty.
[[nodiscard]] std::string name_of_other_format(std::string_view data);

}  // namespace deburr
