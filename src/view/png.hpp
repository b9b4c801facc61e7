// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "view/raster.hpp"

namespace deburr::view {

/// The bytes of a PNG file, 8 bits per channel, without a date: the same picture gives the same
/// bytes.
/// @throws std::invalid_argument  for a picture without pixels, or with too few bytes
[[nodiscard]] std::string png_bytes(const Picture& picture);

}  // namespace deburr::view
