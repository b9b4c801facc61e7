// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_threshold.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "columns.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

/// Share of surface points among the flagged ones, at most.
constexpr double false_share = 0.04;

/// Between these scores, times the factor, only outliers are left, as dense as between the points
/// of the surface.
constexpr double outside_from = 4;
constexpr double outside_to = 6.5;

/// A share of a normal distribution, and what its absolute value has at most there: where the tail
/// begins that hides outliers.
struct Quantile {
  double share;
  double score;
};
constexpr Quantile quantiles[] = {{0.98, 2.3263}, {0.99, 2.5758}, {0.995, 2.8070}, {0.998, 3.0902}};

/// Scores of the surface over those of a normal distribution. A small one is that of two sheets
/// taken for one thick one, which have hardly a tail.
constexpr double smallest_factor = 0.8;
constexpr double largest_factor = 2;

/// Thresholds to choose from, times the factor.
constexpr double lowest = 2;
constexpr double highest = 4;

/// Scores below this are only counted: no quantile that low matters.
constexpr double uncounted = 1;

/// Scores in ascending order.
class Scores {
 public:
  Scores(std::span<const double> scores, const Execution& execution) {
    pick(
        scores.size(), [&](std::size_t i) { return !(scores[i] < uncounted); },
        [&](std::size_t count) { resize_column(sorted_, count, execution); },
        [&](std::size_t i, std::size_t k) { sorted_[k] = scores[i]; }, execution);
    low_ = static_cast<double>(scores.size() - sorted_.size());
    // Which of two equal numbers comes first cannot be told.
    parallel_sort(sorted_, execution);
    set_factor(1);
    // What counts as outside depends on the factor, and the other way round.
    for (int round = 0; round < 5; ++round) set_factor(find_factor());
  }

  [[nodiscard]] double factor() const { return factor_; }
  [[nodiscard]] double above(double score) const {
    return low_ + static_cast<double>(sorted_.size()) - below(score);
  }
  /// Points of the surface that have more than a score by chance.
  [[nodiscard]] double inside_above(double score) const {
    return inside_ * std::erfc(score / factor_ / std::numbers::sqrt2);
  }
  /// Outliers that have less.
  [[nodiscard]] double outside_below(double score) const { return score * outside_; }

 private:
  void set_factor(double factor) {
    factor_ = factor;
    const double from = factor * outside_from;
    const double to = factor * outside_to;
    outside_ = (above(from) - above(to)) / (to - from);
    inside_ = inside_below(from);
  }
  [[nodiscard]] double find_factor() const {
    double factor = smallest_factor;
    for (const Quantile& q : quantiles) factor = std::max(factor, quantile(q.share) / q.score);
    return std::min(factor, largest_factor);
  }
  /// The score that a share of the points of the surface has at most.
  [[nodiscard]] double quantile(double share) const {
    double low = 0;
    double high = factor_ * outside_from;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = (low + high) / 2;
      (inside_below(middle) < share * inside_ ? low : high) = middle;
    }
    return high;
  }
  [[nodiscard]] double below(double score) const {
    return low_ + static_cast<double>(std::upper_bound(sorted_.begin(), sorted_.end(), score) -
                                      sorted_.begin());
  }
  [[nodiscard]] double inside_below(double score) const {
    return below(score) - outside_below(score);
  }

  double low_ = 0;  ///< number of scores that are only counted
  std::vector<double> sorted_;
  double factor_ = 1;
  double outside_ = 0;  ///< outliers per unit of the score
  double inside_ = 0;   ///< points of the surface
};

}  // namespace

double score_threshold(std::span<const double> scores, const Execution& execution) {
  const Scores sorted(scores, execution);
  // In steps, since a threshold that rounding decides would not be the same in another unit.
  constexpr int per_unit = 50;
  for (int step = 0; step < per_unit * static_cast<int>(highest - lowest); ++step) {
    const double score = sorted.factor() * (lowest + static_cast<double>(step) / per_unit);
    // As many points of the surface go as outliers stay: precision and recall are the same.
    const double allowed = std::min(sorted.outside_below(score), false_share * sorted.above(score));
    if (sorted.inside_above(score) <= allowed) return score;
  }
  return sorted.factor() * highest;
}

}  // namespace deburr
