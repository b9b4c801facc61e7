// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "view/fields.hpp"
#include "view/raster.hpp"

// What the colours of a still picture mean, in a strip below it.

namespace deburr::view {

/// A colour and what it stands for; in small letters, as font.hpp has them.
struct Patch {
  std::string name;
  Rgb colour;
};

/// A bar of colours with values at its ends and in its middle, or patches with names.
struct Legend {
  std::string title;           ///< above the bar; left out where there is no room for it
  std::span<const Rgb> map{};  ///< of the bar, from low to high
  double low = 0;              ///< of the first colour, input units
  double high = 0;
  std::vector<Patch> patches{};  ///< instead of a bar
};

/// How large a legend is in a picture.
struct LegendSize {
  int scale = 0;   ///< pixels per dot of a letter; 0 where the picture has no room for a legend
  int height = 0;  ///< pixels of the strip
};

/// A size that takes no more than a fourth of the height; larger pictures have larger letters.
[[nodiscard]] LegendSize size_of(const Legend& legend, int width, int height);

/// Adds a strip of that size to the foot of a picture.
void append(const Legend& legend, const LegendSize& size, Rgb background, Picture& picture);

}  // namespace deburr::view
