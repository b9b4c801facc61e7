// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/normal_filter.hpp"

#include <algorithm>
#include <array>

#include "columns.hpp"
#include "lane_spectrum.hpp"
#include "lanes.hpp"
#include "normal_votes.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "sweep.hpp"

namespace deburr {
namespace {

/// Votes for point i, put into lane l. A zero normal never votes, since rho is not negative.
DEBURR_MULTIVERSION
void count_votes(std::size_t i, const Row* normals, std::span<const std::uint32_t> neighbors,
                 double rho, std::size_t l, Votes& votes) {
  const Lanes3 n = all_lanes(Vec3(normals[i]));
  LanesSym3 tensor;
  Lanes count{};
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    const Lanes3 m = load(normals, neighbors, k);
    const Lanes vote = dot(n, m) > rho ? all_lanes(1) : Lanes{};
    tensor.add_outer(vote, m);
    count += vote;
  }
  set_lane(votes.sum, l, sum(tensor));
  votes.count[l] = sum(count);
}

/// B n for the voting tensor: the sum of the projections of n onto the dominant directions.
DEBURR_LANES_INLINE Lanes3 project_on_dominant(const LanesSym3& tensor,
                                               const NormalFilterOptions& options,
                                               const Lanes3& n) {
  const LanesSpectrum s = spectrum(tensor, options.eigen_tolerance);
  const Lanes total = s.values[0] + s.values[1] + s.values[2];
  Lanes3 projected = dot(s.vectors[0], n) * s.vectors[0];
  for (std::size_t q = 1; q < 3; ++q) {
    const LaneBits minor = s.values[q] < options.tau * total;
    projected = choose(minor, projected, projected + dot(s.vectors[q], n) * s.vectors[q]);
  }
  return projected;
}

void validate(const NormalFilterOptions& options) {
  require(options.rho >= 0 && options.rho < 1, "normal_filter.rho", "in [0, 1)", options.rho);
  require(options.tau > 0 && options.tau < 1, "normal_filter.tau", "in (0, 1)", options.tau);
  require(options.damping >= 0 && options.damping <= 1e6, "normal_filter.damping", "in [0, 1e6]",
          options.damping);
}

template <typename Lists>
std::vector<Vec3> filter(Normals normals, const Lists& lists, const NormalFilterOptions& options,
                         Voteless voteless, const Execution& execution) {
  require_size("neighborhoods", lists.size(), normals.size());
  validate(options);
  const std::vector<Row> rows = make_rows(normals, execution);
  auto filtered = make_column<Vec3>(normals.size(), execution);
  parallel_blocks(normals.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::array<std::uint32_t, lane_count> batch{};
    NearBatch near;
    for (std::size_t from = begin; from < end; from += lane_count) {
      const std::size_t count = std::min(lane_count, end - from);
      for (std::size_t l = 0; l < count; ++l) batch[l] = static_cast<std::uint32_t>(from + l);
      const std::span points(batch.data(), count);
      near.read(lists, points);
      Votes votes;
      for (std::size_t l = 0; l < count; ++l) {
        count_votes(from + l, rows.data(), near[l], options.rho, l, votes);
      }
      turn_by_votes(votes, points, rows.data(), options, voteless,
                    std::span(filtered).subspan(from, count));
    }
  });
  return filtered;
}

}  // namespace

DEBURR_MULTIVERSION
void turn_by_votes(const Votes& votes, std::span<const std::uint32_t> points, const Row* normals,
                   const NormalFilterOptions& options, Voteless voteless,
                   std::span<Vec3> filtered) {
  LanesSym3 tensor = votes.sum;
  tensor.scale(1 / votes.count);
  Lanes3 n;
  for (std::size_t l = 0; l < points.size(); ++l) set_lane(n, l, Vec3(normals[points[l]]));
  const Lanes3 result =
      unit(all_lanes(options.damping) * n + project_on_dominant(tensor, options, n));
  for (std::size_t l = 0; l < points.size(); ++l) {
    const std::uint32_t i = points[l];
    if (votes.count[l] != 0) {
      filtered[l] = lane(result, l);
    } else {
      filtered[l] = voteless == Voteless::Keep ? Vec3(normals[i]) : Vec3{};
    }
  }
}

std::vector<Vec3> filter_normals(Normals normals, const Neighborhoods& neighborhoods,
                                 const NormalFilterOptions& options, Voteless voteless,
                                 const Execution& execution) {
  return filter(normals, neighborhoods, options, voteless, execution);
}

std::vector<Vec3> filter_normals(Normals normals, const NearLists& lists,
                                 const NormalFilterOptions& options, Voteless voteless,
                                 const Execution& execution) {
  return filter(normals, lists, options, voteless, execution);
}

}  // namespace deburr
