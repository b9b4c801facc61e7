// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace deburr {

/// Random numbers with the same bits on every machine. std::mt19937_64 is specified to the bit, the
/// distributions of the standard library are not, and neither is std::log; what is used here is
/// +, -, *, /, sqrt and frexp, all exactly rounded.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// Normal with mean 0 and standard deviation 1.
  /// Source: Marsaglia and Bray, A convenient method for generating normal variables, 1964.
  double gaussian() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    double u = 0;
    double v = 0;
    double s = 0;
    do {
      u = 2 * uniform() - 1;
      v = 2 * uniform() - 1;
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    const double factor = std::sqrt(-2 * log(s) / s);
    spare_ = v * factor;
    has_spare_ = true;
    return u * factor;
  }

  /// Natural logarithm of a finite x > 0, to a few roundings.
  static double log(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // in [1/2, 1)
    if (m < std::numbers::sqrt2 / 2) {
      m *= 2;
      --exponent;
    }
    // log m = 2 atanh f; f^2 < 0.03, so that eleven terms of the series reach the last bit.
    const double f = (m - 1) / (m + 1);
    double series = 0;
    for (int k = 21; k >= 1; k -= 2) series = series * f * f + 1.0 / k;
    return exponent * std::numbers::ln2 + 2 * f * series;
  }

 private:
  std::mt19937_64 engine_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace deburr
