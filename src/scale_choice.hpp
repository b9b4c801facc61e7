// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "automatic_parts.hpp"
#include "deburr/execution.hpp"
#include "kd_tree.hpp"
#include "sheet_fit.hpp"

namespace deburr {

/// Chooses the scale of the fits around each place from the curves of all nodes near it.
///
/// The misfit at a scale is what the residuals there exceed those at small scales; it takes
/// thousands of points to tell it from chance. So the misfit of the whole cloud is taken for each
/// node, but for as much as the nodes around it differ significantly. The scale is the one that
/// makes the squared misfit and the variance together least. See docs/method/automatic.md.
///
/// @param tree  of the nodes that the sheets and curves are of
/// @param places,normals  where choices are wanted
/// @param noise  standard deviation of the noise of the cloud
/// @param levels  the nodes that were surveyed
std::vector<ScaleChoice> choose_scales(const KdTree& tree, std::span<const Sheet> sheets,
                                       std::span<const ScaleCurve> curves, Points places,
                                       Normals normals, double noise, const NodeLevels& levels,
                                       const Execution& execution,
                                       const AutomaticParts& parts = {});

}  // namespace deburr
