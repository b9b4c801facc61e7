// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "io/fields.hpp"

// Which type of PLY holds which values.

namespace deburr {

/// Whether the three columns with the roles from `first_role` on hold all their values exactly in
/// the types that the layout wishes. In a text, float also holds a double that the nearest float
/// equals in all digits that are written: so do values that were floats before.
[[nodiscard]] bool hold_exactly(const std::vector<Column>& columns, int first_role, bool is_text);

/// The attribute in the smallest type of PLY that holds all its values; none for text and for
/// integers that not even double holds.
[[nodiscard]] std::optional<Attribute> narrow_to_ply(const Attribute& attribute);

/// The type for the lengths of a list attribute: its own where that holds them all.
[[nodiscard]] ScalarType length_type_of(const Attribute& attribute);

}  // namespace deburr
