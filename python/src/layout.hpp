// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <string_view>

#include "deburr/point_cloud.hpp"

namespace deburr::python {

/// The name that NumPy has for a type; "str" for text.
[[nodiscard]] const char* type_word(ScalarType type);
/// @throws std::invalid_argument  for a word that is none
[[nodiscard]] ScalarType parse_type(std::string_view word);

[[nodiscard]] nanobind::dict layout_to_python(FileLayout layout);
[[nodiscard]] FileLayout layout_from_python(const nanobind::dict& layout);

/// In cloud.cpp.
[[nodiscard]] nanobind::tuple attribute_to_python(Attribute attribute);
[[nodiscard]] Attribute attribute_from_python(const nanobind::tuple& parts);

}  // namespace deburr::python
