// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "deburr/denoise.hpp"

namespace deburr {

/// Ingredients of the default method that can be left out, to measure what each contributes; not
/// for users. The method is all of them. Steps are those of docs/method/automatic.md.
struct AutomaticParts {
  bool fits = true;          ///< steps 2 to 9; without them the pilot is the result
  bool second_pass = true;   ///< steps 4 and 5; without them the landing of the survey is
  bool pool = true;          ///< the scale is not left to the curve of the nearest node alone
  bool cloud_misfit = true;  ///< nor to surroundings alone, which differ by chance
  bool local_sigma = true;   ///< surroundings have a noise of their own in step 5
  bool guards = true;        ///< growth may end before the chosen scale
  std::size_t levels = 3;    ///< of nodes that are fitted over, 1 to node_levels
  bool surer_sheet = true;   ///< a fit that went astray is passed over
  bool blend = true;         ///< the own sheet is not left alone
  bool creases = true;       ///< sheets end where they meet; without that there are no shares
  bool shares = true;        ///< points by an edge are of several sheets
  bool noise_levels = true;  ///< one run for each level of noise that differs from place to place
};

/// denoise() with some ingredients of the default method left out.
[[nodiscard]] DenoiseResult denoise_with(const AutomaticParts& parts, PointCloud cloud,
                                         const DenoiseOptions& options = {},
                                         const Execution& execution = {});

}  // namespace deburr
