// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

// The LZF compression that binary_compressed PCD files use: literals behind a byte below 32 that
// tells how many less one; otherwise a copy of earlier bytes, of length (byte >> 5) + 2, where 7
// says that another byte is to be added, from ((byte & 31) << 8 | next) + 1 bytes back.

namespace deburr {

/// No byte of input gives more bytes of output than this.
inline constexpr std::size_t lzf_most_growth = 88;

/// @param size  of the result
/// @return none if the data are damaged or have another size
[[nodiscard]] std::optional<std::string> lzf_unpack(std::string_view packed, std::size_t size);

/// Never longer than 33/32 of the data and one byte.
[[nodiscard]] std::string lzf_pack(std::string_view data);

}  // namespace deburr
