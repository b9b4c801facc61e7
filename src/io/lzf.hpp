// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// The LZF compression that binary_compressed PCD files use: literals behind a byte below 32 that
// tells how many less one; otherwise a copy of earlier bytes, of length (byte >> 5) + 2, where 7
// says that another byte is to be added, from ((byte & 31) << 8 | next) + 1 bytes back.

namespace deburr {

/// No byte of input gives more bytes of output than this.
inline constexpr std::size_t lzf_most_growth = 88;

/// Unpacks piece by piece, so that the whole is never in memory.
class LzfUnpacker {
 public:
  explicit LzfUnpacker(std::string_view packed);

  /// The next bytes.
  /// @return false if the data are damaged, or end before
  [[nodiscard]] bool read(char* to, std::size_t size);
  /// Whether all has been read.
  [[nodiscard]] bool at_end() const { return taken_ == end_ && at_ == packed_.size(); }

 private:
  [[nodiscard]] bool fill();

  std::string_view packed_;
  std::size_t at_ = 0;
  std::vector<char> window_;  ///< what copies may reach back to, and what nobody has read yet
  std::size_t taken_ = 0;     ///< of the window
  std::size_t end_ = 0;       ///< of the window
};

/// Packs the data and appends them; what is appended piece by piece unpacks as one. A piece never
/// grows to more than 33/32 of it and one byte.
void lzf_append(std::string& packed, std::string_view data);

}  // namespace deburr
