// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

#include "deburr/denoise.hpp"
#include "deburr/synth.hpp"

// Bytes that are in use at once, counted where they are asked for: unlike what
// the system lends to the process, that does not depend on the C library or the
// machine.

namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> most_in_use{0};

void* counted(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  const std::size_t now = in_use += malloc_usable_size(block);
  std::size_t most = most_in_use;
  while (now > most && !most_in_use.compare_exchange_weak(most, now)) {
  }
  return block;
}

void give_back(void* block) {
  if (block != nullptr) in_use -= malloc_usable_size(block);
  std::free(block);  // NOLINT(*-no-malloc)
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(std::max<std::size_t>(size, 1)));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto to = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(to, (std::max<std::size_t>(size, 1) + to - 1) / to * to));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace deburr {
namespace {

/// Peak beyond the input, in bytes.
std::size_t peak(std::size_t points, double noise_spacings) {
  PointCloud cloud =
      synthesize_part({.points = points, .noise = noise_spacings, .noise_unit = NoiseUnit::Spacing})
          .cloud;
  const std::size_t before = in_use;
  most_in_use = before;
  const DenoiseResult result = denoise(std::move(cloud), {}, {.threads = 1});
  EXPECT_EQ(result.cloud.size(), points);
  return most_in_use - before;
}

/// What each further point of a cloud takes; buffers of threads are there whatever its size.
double bytes_each(double noise_spacings) {
  constexpr std::size_t few = 20000;
  constexpr std::size_t many = 60000;
  return static_cast<double>(peak(many, noise_spacings) - peak(few, noise_spacings)) / (many - few);
}

TEST(Memory, OfTheDefaultMethodIsBounded) {
  for (const double noise : {0.2, 0.7, 2.0}) EXPECT_LE(bytes_each(noise), 400) << noise;
}

}  // namespace
}  // namespace deburr
