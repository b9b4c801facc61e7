// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "args.hpp"
#include "view/up.hpp"

namespace deburr::cli {

inline constexpr Choice<view::Up> up_axes[] = {{"z", view::Up::Z},       {"y", view::Up::Y},
                                               {"x", view::Up::X},       {"-z", view::Up::MinusZ},
                                               {"-y", view::Up::MinusY}, {"-x", view::Up::MinusX}};

/// Adds --up, the axis that pictures have upwards.
inline void add_up(CLI::App& command, view::Up& up) {
  add_choice(command, "--up", up, up_axes, "Axis of the file that points up");
}

}  // namespace deburr::cli
