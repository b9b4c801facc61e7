// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/font.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace deburr::view {
namespace {

/// Letters beside each other, a row of dots per line.
struct Letters {
  std::string_view names;
  std::array<std::string_view, letter_height> rows;
};

constexpr std::array<Letters, 3> sheet{
    {{"abcdefghijklm",
      {"..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. .....",
       "..... #.... ..... ....# ..... .#... ..... #.... ..... ..... #.... ..#.. .....",
       ".###. ####. .#### .#### .###. ####. .#### ####. .##.. ..##. #..#. ..#.. ##.#.",
       "....# #...# #.... #...# #...# .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.#",
       ".#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##... ..#.. #.#.#",
       "#...# #...# #.... #...# #.... .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.#",
       ".#### ####. .#### .#### .#### .#... .#### #...# .###. ...#. #..#. .###. #.#.#",
       "..... ..... ..... ..... ..... ..... ....# ..... ..... ...#. ..... ..... .....",
       "..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. ..... ..... ....."}},
     {"nopqrstuvwxyz",
      {"..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....",
       "..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... .....",
       "####. .###. ####. .#### #.##. .#### ####. #...# #...# #...# #...# #...# #####",
       "#...# #...# #...# #...# ##... #.... .#... #...# #...# #.#.# .#.#. #...# ...#.",
       "#...# #...# #...# #...# #.... .###. .#... #...# #...# #.#.# ..#.. #...# ..#..",
       "#...# #...# #...# #...# #.... ....# .#... #...# .#.#. #.#.# .#.#. #...# .#...",
       "#...# .###. ####. .#### #.... ####. ..##. .#### ..#.. .#.#. #...# .#### #####",
       "..... ..... #.... ....# ..... ..... ..... ..... ..... ..... ..... ....# .....",
       "..... ..... #.... ....# ..... ..... ..... ..... ..... ..... ..... .###. ....."}},
     {"0123456789+-.,",
      {".###. ..#.. .###. .###. ...#. ##### .###. ##### .###. .###. ..... ..... ..... .....",
       "#...# .##.. #...# #...# ..##. #.... #.... ....# #...# #...# ..... ..... ..... .....",
       "#..## ..#.. ....# ....# .#.#. ####. #.... ...#. #...# #...# ..#.. ..... ..... .....",
       "#.#.# ..#.. ...#. ..##. #..#. ....# ####. ..#.. .###. .#### ..#.. ..... ..... .....",
       "##..# ..#.. ..#.. ....# ##### ....# #...# .#... #...# ....# ##### .###. ..... .....",
       "#...# ..#.. .#... #...# ...#. #...# #...# .#... #...# ....# ..#.. ..... .##.. .##..",
       ".###. .###. ##### .###. ...#. .###. .###. .#... .###. .###. ..#.. ..... .##.. .##..",
       "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#...",
       "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ....."}}}};

/// Whether a dot of a letter is inked.
bool inked(char letter, int column, int row) {
  if (letter == ' ') return false;
  for (const Letters& letters : sheet) {
    const std::size_t at = letters.names.find(letter);
    if (at == std::string_view::npos) continue;
    const std::size_t dot = at * letter_width + static_cast<std::size_t>(column);
    return letters.rows[static_cast<std::size_t>(row)][dot] == '#';
  }
  constexpr int line = 6;  // row of the foot of a letter
  return row <= line && (row == 0 || row == line || column == 0 || column == letter_width - 2);
}

}  // namespace

void fill(Picture& picture, int left, int top, int width, int height, Rgb colour) {
  for (int y = std::max(top, 0); y < std::min(top + height, picture.height); ++y) {
    for (int x = std::max(left, 0); x < std::min(left + width, picture.width); ++x) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(x));
      std::ranges::copy(colour, picture.rgb.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
}

void write(Picture& picture, int left, int top, std::string_view text, int scale, Rgb colour) {
  for (const char letter : text) {
    for (int row = 0; row < letter_height; ++row) {
      for (int column = 0; column < letter_width - 1; ++column) {
        if (!inked(letter, column, row)) continue;
        fill(picture, left + column * scale, top + row * scale, scale, scale, colour);
      }
    }
    left += letter_width * scale;
  }
}

}  // namespace deburr::view
