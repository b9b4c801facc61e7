// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_threshold.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace deburr {
namespace {

/// Share of surface points among the flagged ones that is aimed for.
constexpr double false_share = 0.035;

/// Between these scores only outliers are left, as dense as between the points of the surface.
constexpr double outside_from = 5;
constexpr double outside_to = 6.5;

/// A share of a normal distribution, and what the absolute value exceeds outside of it.
struct Quantile {
  double share;
  double score;
};
constexpr Quantile quantiles[] = {{0.9, 1.6449}, {0.95, 1.96}, {0.98, 2.3263}, {0.99, 2.5758}};

constexpr double largest_factor = 2;

/// Scores in ascending order.
class Scores {
 public:
  explicit Scores(std::vector<double> scores) : sorted_(std::move(scores)) {
    std::sort(sorted_.begin(), sorted_.end());
    outside_ = (static_cast<double>(below(outside_to)) - static_cast<double>(below(outside_from))) /
               (outside_to - outside_from);
    inside_ = inside_below(outside_to);
  }

  [[nodiscard]] double above(double score) const {
    return static_cast<double>(sorted_.size() - below(score));
  }
  [[nodiscard]] double size() const { return static_cast<double>(sorted_.size()); }

  /// The score that a share of the points of the surface has at most.
  [[nodiscard]] double quantile(double share) const {
    double low = 0;
    double high = outside_to;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = (low + high) / 2;
      (inside_below(middle) < share * inside_ ? low : high) = middle;
    }
    return high;
  }

 private:
  [[nodiscard]] std::size_t below(double score) const {
    return static_cast<std::size_t>(std::upper_bound(sorted_.begin(), sorted_.end(), score) -
                                    sorted_.begin());
  }
  [[nodiscard]] double inside_below(double score) const {
    return static_cast<double>(below(score)) - score * outside_;
  }

  std::vector<double> sorted_;
  double outside_ = 0;  ///< outliers per unit of the score
  double inside_ = 0;   ///< points of the surface
};

}  // namespace

double score_threshold(std::vector<double> scores) {
  const Scores sorted(std::move(scores));
  double factor = 1;
  for (const Quantile& q : quantiles) {
    factor = std::max(factor, sorted.quantile(q.share) / q.score);
  }
  factor = std::min(factor, largest_factor);
  // Benjamini and Hochberg 1995: the share expected by chance among those found. Scores in steps,
  // since a threshold that rounding decides would not be the same in another unit.
  constexpr int per_unit = 20;
  for (int step = 5 * per_unit / 2; step < 4 * per_unit; ++step) {
    const double score = static_cast<double>(step) / per_unit;
    const double by_chance = sorted.size() * std::erfc(score / std::numbers::sqrt2);
    if (by_chance <= false_share * sorted.above(factor * score)) return factor * score;
  }
  return 4 * factor;
}

}  // namespace deburr
