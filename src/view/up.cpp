// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/up.hpp"

namespace deburr::view {

UpFrame frame_of(Up up) {
  constexpr Vec3 x{1, 0, 0};
  constexpr Vec3 y{0, 1, 0};
  constexpr Vec3 z{0, 0, 1};
  switch (up) {
    case Up::Z:
      break;
    case Up::Y:
      return {x, -z, y};
    case Up::X:
      return {y, z, x};
    case Up::MinusZ:
      return {-x, y, -z};
    case Up::MinusY:
      return {x, z, -y};
    case Up::MinusX:
      return {-y, z, -x};
  }
  return {x, y, z};
}

std::string_view to_string(Up up) {
  switch (up) {
    case Up::Z:
      break;
    case Up::Y:
      return "y";
    case Up::X:
      return "x";
    case Up::MinusZ:
      return "-z";
    case Up::MinusY:
      return "-y";
    case Up::MinusX:
      return "-x";
  }
  return "z";
}

}  // namespace deburr::view
