// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "distance_error.hpp"

#include <algorithm>
#include <cmath>

namespace deburr {

DistanceError summarize(std::vector<double> distances, double diagonal) {
  std::erase_if(distances, [](double d) { return std::isnan(d); });
  DistanceError error;
  error.diagonal = diagonal;
  error.count = distances.size();
  if (distances.empty()) return error;
  double sum = 0;
  double sum_of_squares = 0;
  for (const double d : distances) {
    sum += d;
    sum_of_squares += d * d;
    error.maximum = std::max(error.maximum, d);
  }
  error.mean = sum / static_cast<double>(error.count);
  error.rms = std::sqrt(sum_of_squares / static_cast<double>(error.count));
  // By rank, in integers: the ceil(0.95 n)-th of n.
  const auto at =
      distances.begin() + static_cast<std::ptrdiff_t>((95 * error.count + 99) / 100 - 1);
  std::nth_element(distances.begin(), at, distances.end());
  error.percentile_95 = *at;
  return error;
}

}  // namespace deburr
