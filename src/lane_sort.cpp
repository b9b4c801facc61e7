// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "lane_sort.hpp"

#include <cstring>
#include <utility>

#include "lanes.hpp"

// Bitonic sorting (Batcher 1968) of rows of eight lanes. Value k stands in row k % rows of lane
// k / rows, so that most comparisons are of whole rows. Every merge begins with a comparison to the
// mirrored place, after which all others put the smaller value first.

namespace deburr {
namespace {

/// As many lanes as a vector of the processor has: of wider ones, the compiler would compare and
/// permute lane by lane.
template <std::size_t width>
using Vector [[gnu::vector_size(width * sizeof(double))]] = double;

/// Rows of eight lanes, each made of `parts` vectors.
template <std::size_t width>
class Rows {
 public:
  DEBURR_LANES_INLINE Rows(double* values, std::size_t count) : values_(values), count_(count) {}

  DEBURR_LANES_INLINE void sort() {
    for (std::size_t run = 2; run <= count_; run *= 2) {
      merge_rows(run);
      clean_rows(run / 4);
    }
    merge_lanes<2>();
    merge_lanes<4>();
    merge_lanes<8>();
  }

 private:
  using V = Vector<width>;
  static constexpr std::size_t parts = lane_count / width;

  [[nodiscard]] DEBURR_LANES_INLINE V load(std::size_t row, std::size_t part) const {
    V v;
    std::memcpy(&v, values_ + lane_count * row + width * part, sizeof v);
    return v;
  }
  DEBURR_LANES_INLINE void store(std::size_t row, std::size_t part, const V& v) {
    std::memcpy(values_ + lane_count * row + width * part, &v, sizeof v);
  }

  /// The lanes in the order l ^ flip.
  template <std::size_t flip>
  DEBURR_LANES_INLINE static V flipped(const V& v) {
    return [&]<std::size_t... l>(std::index_sequence<l...>) __attribute__((always_inline)) {
      return __builtin_shufflevector(v, v, (l ^ flip)...);
    }
    (std::make_index_sequence<width>{});
  }

  /// The first where the number of the lane has not the bit, else the second.
  template <std::size_t bit>
  DEBURR_LANES_INLINE static V by_bit(std::size_t part, const V& without, const V& with) {
    if (bit >= width) return (part * width & bit) == 0 ? without : with;
    return [&]<std::size_t... l>(std::index_sequence<l...>) __attribute__((always_inline)) {
      return __builtin_shufflevector(without, with, ((l & bit) == 0 ? l : l + width)...);
    }
    (std::make_index_sequence<width>{});
  }

  DEBURR_LANES_INLINE static void order(V& a, V& b) {
    const V low = a < b ? a : b;
    b = a < b ? b : a;
    a = low;
  }
  /// Puts the smaller values into the first row.
  DEBURR_LANES_INLINE void order_rows(std::size_t first, std::size_t second) {
    for (std::size_t p = 0; p < parts; ++p) {
      const V a = load(first, p);
      const V b = load(second, p);
      store(first, p, a < b ? a : b);
      store(second, p, a < b ? b : a);
    }
  }
  /// Merges runs of run / 2 rows, up to cleaning.
  DEBURR_LANES_INLINE void merge_rows(std::size_t run) {
    for (std::size_t begin = 0; begin < count_; begin += run) {
      for (std::size_t k = 0; k < run / 2; ++k) order_rows(begin + k, begin + run - 1 - k);
    }
  }
  /// Compares rows at `apart`, apart / 2, ..., 1; at two distances at once, since reading and
  /// writing take longer than comparing.
  DEBURR_LANES_INLINE void clean_rows(std::size_t apart) {
    for (; apart > 1; apart /= 4) {
      for (std::size_t begin = 0; begin < count_; begin += 2 * apart) {
        for (std::size_t k = 0; k < apart / 2; ++k) order_four(begin + k, apart / 2);
      }
    }
    if (apart == 0) return;
    for (std::size_t row = 0; row < count_; row += 2) order_rows(row, row + 1);
  }
  DEBURR_LANES_INLINE void order_four(std::size_t first, std::size_t step) {
    for (std::size_t p = 0; p < parts; ++p) {
      V a = load(first, p);
      V b = load(first + step, p);
      V c = load(first + 2 * step, p);
      V d = load(first + 3 * step, p);
      order(a, c);
      order(b, d);
      order(a, b);
      order(c, d);
      store(first, p, a);
      store(first + step, p, b);
      store(first + 2 * step, p, c);
      store(first + 3 * step, p, d);
    }
  }

  /// Compares lanes at `apart`.
  template <std::size_t apart>
  DEBURR_LANES_INLINE void clean_lanes() {
    for (std::size_t row = 0; row < count_; ++row) {
      for (std::size_t p = 0; p < parts; ++p) {
        const V a = load(row, p);
        if constexpr (apart < width) {
          const V b = flipped<apart>(a);
          store(row, p, by_bit<apart>(p, a < b ? a : b, a < b ? b : a));
        } else if ((p & apart / width) == 0) {
          const V b = load(row, p + apart / width);
          store(row, p, a < b ? a : b);
          store(row, p + apart / width, a < b ? b : a);
        }
      }
    }
  }

  /// Merges runs of lanes / 2 whole lanes.
  template <std::size_t lanes>
  DEBURR_LANES_INLINE void merge_lanes() {
    constexpr std::size_t flip = lanes - 1;
    for (std::size_t row = 0; row < count_ / 2; ++row) {
      const std::size_t mirror = count_ - 1 - row;
      for (std::size_t p = 0; p < parts; ++p) {
        const V a = load(row, p);
        const V b = flipped<flip % width>(load(mirror, p ^ flip / width));
        const V low = a < b ? a : b;
        const V high = a < b ? b : a;
        store(row, p, by_bit<lanes / 2>(p, low, high));
        store(mirror, p ^ flip / width, flipped<flip % width>(by_bit<lanes / 2>(p, high, low)));
      }
    }
    if constexpr (lanes == 8) clean_lanes<2>();
    if constexpr (lanes >= 4) clean_lanes<1>();
    clean_rows(count_ / 2);
  }

  double* values_;
  std::size_t count_;
};

}  // namespace

/// One of these is taken when the program starts.
namespace for_each_processor {

#ifdef DEBURR_TARGETS
[[gnu::target("avx512f")]] void sort_rows(double* values, std::size_t rows) {
  Rows<8>(values, rows).sort();
}
[[gnu::target("avx2")]] void sort_rows(double* values, std::size_t rows) {
  Rows<4>(values, rows).sort();
}
[[gnu::target("default")]]
#endif
void sort_rows(double* values, std::size_t rows) {
  Rows<2>(values, rows).sort();
}

}  // namespace for_each_processor

void sort_in_lanes(double* values, std::size_t size) {
  const std::size_t rows = size / lane_count;
  for_each_processor::sort_rows(values, rows);
  std::array<double, lane_sort_sizes.back()> sorted;
  for (std::size_t l = 0; l < lane_count; ++l) {
    for (std::size_t row = 0; row < rows; ++row) {
      sorted[l * rows + row] = values[row * lane_count + l];
    }
  }
  std::memcpy(values, sorted.data(), size * sizeof(double));
}

}  // namespace deburr
