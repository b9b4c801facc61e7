// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/denoise.hpp"

namespace deburr {

/// Takes the outliers out of every array of a result, attributes among them. Other elements of the
/// file that refer to points by number, such as faces, would be wrong then and go too.
void remove_outliers(DenoiseResult& result);

}  // namespace deburr
