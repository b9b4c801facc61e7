// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/position_update.hpp"
#include "sweep_plan.hpp"

namespace deburr {

/// sweep_in_place over all points, along a plan that was made for its order.
FeatureField sweep_along(const SweepPlan& plan, Points original, std::vector<Vec3>& points,
                         Normals normals, const Neighborhoods& neighborhoods,
                         const FeatureOptions& feature_options,
                         const PositionUpdateOptions& options, const Execution& execution);

}  // namespace deburr
