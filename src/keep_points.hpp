// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/denoise.hpp"

namespace deburr {

/// Takes the outliers out of every array of a result, attributes among them. Faces and edges whose
/// points all stay are kept, with their new numbers. Other elements of the file may refer to points
/// in ways that nobody knows, and go.
void remove_outliers(DenoiseResult& result);

}  // namespace deburr
