// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "lent_result.hpp"

#include <utility>

#include "columns.hpp"
#include "parallel.hpp"

namespace deburr {

LentResult::LentResult(const AutomaticInput& input, const Shares& shares, AutomaticResult& result,
                       const Execution& execution)
    : input_(input) {
  const auto is_elsewhere = [&](std::size_t i) {
    return result.points[i] != bounded(shares.places[i], input.points[i], input.max_move) ||
           result.normals[i] != shares.normals[i];
  };
  pick(
      result.points.size(), is_elsewhere, [&](std::size_t count) { elsewhere_.resize(count); },
      [&](std::size_t i, std::size_t k) {
        elsewhere_[k] = {static_cast<std::uint32_t>(i), result.points[i], result.normals[i]};
      },
      execution);
  release(result.points);
  release(result.normals);
}

void LentResult::give_back(std::vector<Vec3> places, std::vector<Vec3> normals,
                           AutomaticResult& result, const Execution& execution) const {
  const std::size_t count = input_.points.size();
  result.points = std::move(places);
  result.normals = std::move(normals);
  result.points.resize(count);
  result.normals.resize(count);
  parallel_for(count, without_progress(execution), [&](std::size_t i) {
    result.points[i] = bounded(result.points[i], input_.points[i], input_.max_move);
  });
  for (const Elsewhere& e : elsewhere_) {
    result.points[e.point] = e.place;
    result.normals[e.point] = e.normal;
  }
}

}  // namespace deburr
