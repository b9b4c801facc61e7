// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "view/fields.hpp"

// Colours that people with any kind of colour vision can tell apart. The page has the same ones in
// viewer/src/colour/maps.ts.

namespace deburr::view {

/// From low to high through grey: Moreland, Diverging Color Maps for Scientific Visualization,
/// 2009.
inline constexpr std::array<Rgb, 9> diverging{{{59, 76, 192},
                                               {98, 130, 234},
                                               {141, 176, 254},
                                               {184, 208, 249},
                                               {221, 221, 221},
                                               {245, 196, 173},
                                               {244, 154, 123},
                                               {222, 96, 77},
                                               {180, 4, 38}}};

/// From dark to bright: viridis, of van der Walt and Smith.
inline constexpr std::array<Rgb, 9> sequential{{{68, 1, 84},
                                                {71, 45, 123},
                                                {59, 82, 139},
                                                {44, 114, 142},
                                                {33, 145, 140},
                                                {40, 174, 128},
                                                {94, 201, 98},
                                                {173, 220, 48},
                                                {253, 231, 37}}};

/// Of the values of Feature, after Okabe and Ito.
inline constexpr std::array<Rgb, 4> label_colours{
    {{190, 190, 190}, {213, 94, 0}, {0, 114, 178}, {0, 158, 115}}};
inline constexpr Rgb outlier_colour{204, 121, 167};
inline constexpr Rgb unknown_colour{128, 128, 128};
/// Of a surface of which only the shape is shown.
inline constexpr Rgb plain_colour{205, 205, 200};

/// The colour at a share in [0, 1] of the way along a map, beyond its ends theirs; grey for NaN.
[[nodiscard]] Rgb sample(std::span<const Rgb> map, double share);

}  // namespace deburr::view
