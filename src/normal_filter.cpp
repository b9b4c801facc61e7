// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/normal_filter.hpp"

#include "lanes.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "sym3.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// The sum of n_j n_j^T over the voters for one point, and their number.
struct Votes {
  Sym3 sum;
  double count = 0;
};

/// Votes for the points [begin, end). A zero normal never votes, since rho is not negative.
DEBURR_MULTIVERSION
void count_votes(std::size_t begin, std::size_t end, Normals normals,
                 const Neighborhoods& neighborhoods, double rho, Votes* votes) {
  for (std::size_t i = begin; i < end; ++i) {
    const auto neighbors = neighborhoods[i];
    const Lanes3 n = all_lanes(normals[i]);
    LanesSym3 tensor;
    Lanes count{};
    for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
      const Lanes3 m = load(normals, neighbors, k);
      const Lanes vote = dot(n, m) > rho ? all_lanes(1) : Lanes{};
      tensor.add_outer(vote, m);
      count += vote;
    }
    votes[i - begin] = {sum(tensor), sum(count)};
  }
}

/// B n for the voting tensor: the sum of the projections of n onto the dominant directions.
Vec3 project_on_dominant(const Sym3& tensor, const NormalFilterOptions& options, const Vec3& n) {
  const Spectrum s = spectrum(tensor, options.eigen_tolerance);
  const double total = s.values[0] + s.values[1] + s.values[2];
  Vec3 projected = dot(s.vectors[0], n) * s.vectors[0];
  for (std::size_t q = 1; q < 3; ++q) {
    if (!(s.values[q] < options.tau * total)) projected += dot(s.vectors[q], n) * s.vectors[q];
  }
  return projected;
}

}  // namespace

std::vector<Vec3> filter_normals(Normals normals, const Neighborhoods& neighborhoods,
                                 const NormalFilterOptions& options, Voteless voteless,
                                 const Execution& execution) {
  require_size("neighborhoods", neighborhoods.size(), normals.size());
  require(options.rho >= 0 && options.rho < 1, "normal_filter.rho", "in [0, 1)", options.rho);
  require(options.tau > 0 && options.tau < 1, "normal_filter.tau", "in (0, 1)", options.tau);
  require(options.damping >= 0 && options.damping <= 1e6, "normal_filter.damping", "in [0, 1e6]",
          options.damping);

  std::vector<Vec3> filtered(normals.size());
  parallel_blocks(normals.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::vector<Votes> votes(end - begin);
    count_votes(begin, end, normals, neighborhoods, options.rho, votes.data());
    for (std::size_t i = begin; i < end; ++i) {
      Votes& v = votes[i - begin];
      if (v.count == 0) {
        filtered[i] = voteless == Voteless::Keep ? normals[i] : Vec3{};
        continue;
      }
      v.sum.scale(1 / v.count);
      filtered[i] =
          unit(options.damping * normals[i] + project_on_dominant(v.sum, options, normals[i]));
    }
  });
  return filtered;
}

}  // namespace deburr
