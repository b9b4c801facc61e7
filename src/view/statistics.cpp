// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace deburr::view {
namespace {

std::vector<double> magnitudes(std::span<const double> values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double value : values) {
    if (std::isfinite(value)) result.push_back(std::abs(value));
  }
  return result;
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const std::size_t at = std::min(static_cast<std::size_t>(std::max(rank, 1.0)), values.size()) - 1;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(at);
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace

Summary summarise(std::span<const double> values) {
  std::vector<double> finite = magnitudes(values);
  if (finite.empty()) return {};
  Summary summary{.count = finite.size(), .maximum = std::ranges::max(finite)};
  const auto count = static_cast<double>(finite.size());
  for (const double value : finite) {
    const double share = summary.maximum > 0 ? value / summary.maximum : 0;  // cannot overflow
    summary.mean += share;
    summary.rms += share * share;
  }
  summary.mean *= summary.maximum / count;
  summary.rms = summary.maximum * std::sqrt(summary.rms / count);
  summary.percentile_95 = quantile(finite, 0.95);
  return summary;
}

double magnitude_quantile(std::span<const double> values, double share) {
  std::vector<double> finite = magnitudes(values);
  return quantile(finite, share);
}

Histogram histogram_of(std::span<const double> values, double high, std::size_t bins) {
  const bool is_signed = std::ranges::any_of(values, [](double value) { return value < 0; });
  Histogram histogram{
      .low = is_signed ? -high : 0.0, .high = high, .counts = std::vector<std::size_t>(bins)};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (value < histogram.low) {
      ++histogram.below;
    } else if (value > histogram.high) {
      ++histogram.above;
    } else {
      const double along = high > 0 ? (value - histogram.low) / (high - histogram.low) : 0;
      const auto bin = static_cast<std::size_t>(along * static_cast<double>(bins));
      ++histogram.counts[std::min(bin, bins - 1)];
    }
  }
  return histogram;
}

}  // namespace deburr::view
