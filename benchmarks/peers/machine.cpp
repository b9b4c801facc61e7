// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <vector>

#include "measure.hpp"

// What one core of this machine can do: machine bandwidth|flops. The number is that of bytes, of
// operations in double precision. Multiplications and additions are not fused, as in deburr.

namespace {

constexpr std::size_t lanes = 8;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// The triad of STREAM, over three arrays far larger than any cache. What is written has to be read
/// first, so that an element moves 32 bytes.
__attribute__((noinline)) void triad(double* a, const double* b, const double* c,
                                     std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 0.5 * c[i];
}

/// Chains that are independent of each other, enough to hide that each waits for its own result.
__attribute__((target_clones("avx512f", "avx2", "default"))) std::size_t chains(std::size_t times,
                                                                                double* out) {
  constexpr std::size_t count = 8;
  std::array<Lanes, count> x{};
  for (std::size_t k = 0; k < count; ++k) x[k] += 1e-3 * static_cast<double>(k);
  for (std::size_t t = 0; t < times; ++t) {
    for (Lanes& v : x) v = v * 0.999 + 0.001;
  }
  Lanes sum{};
  for (const Lanes& v : x) sum += v;
  *out = sum[0];
  return times * count * lanes * 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc == 2 ? argv[1] : "";
  if (what == "bandwidth") {
    constexpr std::size_t size = std::size_t{1} << 24;
    std::vector<double> a(size, 1), b(size, 2), c(size, 3);
    constexpr int times = 5;
    peers::measure([&] {
      // Each reads what the one before has written.
      for (int t = 0; t < times; ++t) {
        triad(a.data(), b.data(), c.data(), size);
        triad(b.data(), a.data(), c.data(), size);
      }
      return 2 * times * 32 * size;
    });
    if (b[size / 2] != 2 + 2 * times * 1.5) peers::fail("the triad is wrong");
  } else if (what == "flops") {
    double out = 0;
    peers::measure([&] { return chains(40000000, &out); });
    if (!(out > 0)) peers::fail("the chains are wrong");
  } else {
    peers::fail("usage: machine bandwidth|flops");
  }
  return 0;
}
