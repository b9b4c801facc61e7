// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deburr/normal_filter.hpp"
#include "deburr/position_update.hpp"
#include "near_lists.hpp"
#include "sweep_plan.hpp"

namespace deburr {

/// The normals of the next round: filter_normals of those of this round, found in the pass over the
/// neighbours that moves the points. Votes are given as points are compared, so rho must be that of
/// FeatureOptions. Points without a vote keep their normal.
struct NextNormals {
  NormalFilterOptions filter;
  std::vector<Vec3> normals;
};

/// @throws std::invalid_argument  naming the option that is out of its range
void validate(const PositionUpdateOptions& options);

/// sweep_at_once, block by block of the lists, so that no copy of all rows is needed. The direction
/// of edges is not kept.
/// @param[out] moved  where the points go; not `points`
/// @param[out] next  null if it is not wanted
std::vector<Feature> sweep_together(Points original, Points points, Normals normals,
                                    const NearLists& lists, const FeatureOptions& feature_options,
                                    const PositionUpdateOptions& options, std::span<Vec3> moved,
                                    NextNormals* next, const Execution& execution);

/// sweep_in_place over all points, along a plan that was made for its order. Neither is here.
/// @param lists  those that the plan was made for
/// @param[out] next  null if it is not wanted
std::vector<Feature> sweep_along(const SweepPlan& plan, Points original, std::vector<Vec3>& points,
                                 Normals normals, const NearLists& lists,
                                 const FeatureOptions& feature_options,
                                 const PositionUpdateOptions& options, NextNormals* next,
                                 const Execution& execution);

/// filter_normals.
std::vector<Vec3> filter_normals(Normals normals, const NearLists& lists,
                                 const NormalFilterOptions& options, Voteless voteless,
                                 const Execution& execution);

}  // namespace deburr
