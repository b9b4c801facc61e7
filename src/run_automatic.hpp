// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "automatic_parts.hpp"
#include "published.hpp"
#include "stage_clock.hpp"
#include "working_set.hpp"

namespace deburr {

/// The default method from the points of a cloud to their new places: looks for outliers, which
/// stay where they are, finds spacing and noise, and denoises the rest.
/// @param set  as it was when this returns, but for its normals
/// @param[in,out] outliers  one for each point of the set; 1 where it is one
/// @param[in,out] report  gets what was found
State run_automatic(const AutoOptions& options, const AutomaticParts& parts, WorkingSet& set,
                    std::vector<std::uint8_t>& outliers, Report& report, StageClock& clock,
                    const Execution& execution);

}  // namespace deburr
