// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "view/raster.hpp"

// Letters for pictures, so that these need no font and look the same everywhere.

namespace deburr::view {

/// Pixels of a letter at scale 1, with the gap to the next; the last two rows hang below the line.
inline constexpr int letter_width = 6;
inline constexpr int letter_height = 9;

/// Pixels from the left of the first letter to the right of the last.
[[nodiscard]] constexpr int text_width(std::string_view text, int scale) {
  return text.empty() ? 0 : (static_cast<int>(text.size()) * letter_width - 1) * scale;
}

/// Fills the pixels of a rectangle that lie in the picture.
void fill(Picture& picture, int left, int top, int width, int height, Rgb colour);

/// Writes small letters, digits and the signs + - . , and space; a box stands for any other.
/// @param left, top  of the first letter
/// @param scale      pixels per dot, >= 1
void write(Picture& picture, int left, int top, std::string_view text, int scale, Rgb colour);

}  // namespace deburr::view
