// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "view/colours.hpp"
#include "view/font.hpp"

namespace deburr::view {
namespace {

// Lengths in dots of a letter.
constexpr int pad = 4;
constexpr int bar_height = 8;
constexpr int patch_side = 7;
constexpr int patch_gap = 3;  // between a patch and its name
constexpr int between = 12;   // two patches
constexpr int widest_bar = 300;
constexpr int height_per_scale = 350;  // pixels of the picture
constexpr int largest_share = 4;       // the strip takes no more than one part of so many

/// The values at the ends of the bar and in its middle.
std::array<std::string, 3> ticks(const Legend& legend) {
  const bool is_signed = legend.low < 0;
  const auto text = [is_signed](double value) {
    return is_signed && value > 0 ? fmt::format("+{:.4g}", value) : fmt::format("{:.4g}", value);
  };
  return {text(legend.low), text(0.5 * legend.low + 0.5 * legend.high), text(legend.high)};
}

int width_of(const Patch& patch) { return patch_side + patch_gap + text_width(patch.name, 1); }

/// Dots that the narrowest legend of these values takes.
int least_width(const Legend& legend) {
  int width = 2 * pad;
  if (legend.patches.empty()) {
    int widest = 0;
    for (const std::string& tick : ticks(legend)) widest = std::max(widest, text_width(tick, 1));
    return width + 3 * widest + 2 * between;
  }
  for (const Patch& patch : legend.patches) width += width_of(patch) + between;
  return width - between;
}

int dots_high(const Legend& legend) {
  return legend.patches.empty() ? letter_height + bar_height + letter_height + 3 * pad
                                : letter_height + 2 * pad;
}

struct Pen {
  Picture& picture;
  int scale;
  int top;  ///< of the strip
  Rgb ink;
};

void draw_patches(const Legend& legend, const Pen& pen) {
  int left = (pen.picture.width - (least_width(legend) - 2 * pad) * pen.scale) / 2;
  const int top = pen.top + pad * pen.scale;
  for (const Patch& patch : legend.patches) {
    const int side = patch_side * pen.scale;
    fill(pen.picture, left, top, side, side, patch.colour);
    write(pen.picture, left + (patch_side + patch_gap) * pen.scale, top, patch.name, pen.scale,
          pen.ink);
    left += (width_of(patch) + between) * pen.scale;
  }
}

void draw_bar(const Legend& legend, const Pen& pen) {
  Picture& picture = pen.picture;
  const int width =
      std::min({picture.width - 2 * pad * pen.scale,
                std::max(widest_bar, least_width(legend)) * pen.scale, picture.width});
  const int left = (picture.width - width) / 2;
  int top = pen.top + pad * pen.scale / 2;
  const int title = text_width(legend.title, pen.scale);
  if (title <= picture.width) {
    write(picture, (picture.width - title) / 2, top, legend.title, pen.scale, pen.ink);
  }
  top += (letter_height + pad / 2) * pen.scale;
  for (int x = 0; x < width; ++x) {
    const double share = width > 1 ? static_cast<double>(x) / (width - 1) : 0.5;
    fill(picture, left + x, top, 1, bar_height * pen.scale, sample(legend.map, share));
  }
  top += (bar_height + pad / 2) * pen.scale;
  const std::array<std::string, 3> texts = ticks(legend);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const int room = width - text_width(texts[k], pen.scale);
    write(picture, left + room * static_cast<int>(k) / 2, top, texts[k], pen.scale, pen.ink);
  }
}

}  // namespace

LegendSize size_of(const Legend& legend, int width, int height) {
  const int scale = std::min({std::max(height / height_per_scale, 1), width / least_width(legend),
                              height / (largest_share * dots_high(legend))});
  return {scale, scale * dots_high(legend)};
}

void append(const Legend& legend, const LegendSize& size, Rgb background, Picture& picture) {
  if (size.scale < 1) return;
  const int top = picture.height;
  picture.height += size.height;
  picture.rgb.resize(3U * static_cast<std::size_t>(picture.width) *
                     static_cast<std::size_t>(picture.height));
  fill(picture, 0, top, picture.width, size.height, background);
  constexpr int half = 128 * 3;
  const bool is_light = background[0] + background[1] + background[2] >= half;
  const Pen pen{picture, size.scale, top, is_light ? Rgb{40, 40, 40} : Rgb{230, 230, 230}};
  legend.patches.empty() ? draw_bar(legend, pen) : draw_patches(legend, pen);
}

}  // namespace deburr::view
