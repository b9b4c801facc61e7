// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "automatic.hpp"
#include "node_levels.hpp"
#include "scale_choice.hpp"
#include "sheet_set.hpp"

namespace deburr {

/// Which nodes are fitted: one of every so many. Nodes follow each other closely in space.
struct FitSteps {
  std::size_t survey;  ///< in the first pass
  std::size_t even;    ///< in the second
  std::size_t edges;   ///< in the second, by edges
  std::size_t around;  ///< nodes around a point whose sheets, as far as they have one, it lands on
};

/// The more nodes the noise makes the smallest fits need, the more they overlap.
/// @param ratio  standard deviation of the noise, in spacings of the nodes
/// @param merged  whether nodes are of several points
FitSteps fit_steps(double ratio, bool merged, const AutomaticParts& parts);

/// The fits of the first pass.
struct Survey {
  NodeSheets sheets;
  ScaleSurvey scales;
};

/// Fits one of every `step` nodes at small scales, and some of these at all.
Survey survey_nodes(const NodeLevels& levels, double noise, std::size_t step,
                    const AutomaticParts& parts, const Execution& execution);

/// Fits nodes at the scales that the survey of the nodes of the first pass makes best.
/// @param by_edge  of each node, whether it is to be fitted as one by an edge
NodeSheets fit_nodes(const ScaleSurvey& survey, const NodeLevels& levels,
                     std::span<const std::uint8_t> by_edge, double noise, const FitSteps& steps,
                     const AutomaticParts& parts, const Execution& execution);

}  // namespace deburr
