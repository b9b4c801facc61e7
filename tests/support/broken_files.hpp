// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "deburr/error.hpp"
#include "io/format.hpp"

namespace deburr {

/// What reading a file with this content says: the message of its IoError without the path, or ""
/// if it can be read. Any other exception goes on to the test.
inline std::string error_of(const std::string& data) {
  const std::filesystem::path path = "broken";
  try {
    const PointCloud cloud = parse_cloud({path, data, {}});
    EXPECT_TRUE(cloud.normals.empty() || cloud.normals.size() == cloud.size());
    return "";
  } catch (const IoError& e) {
    EXPECT_EQ(e.path(), path);
    return std::string(e.what()).substr(path.string().size() + 2);
  }
}

/// Reads a few thousand damaged versions of a file; each must be read or refused.
inline void fuzz(const std::string& file, unsigned seed, int runs) {
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return random() % n; };
  using namespace std::string_view_literals;
  constexpr std::string_view tricky = "0123456789-+.,;:# \n\r\t\"eExyzn/\0\x7f\x80\xff"sv;
  int read = 0;
  for (int run = 0; run < runs; ++run) {
    std::string broken = file;
    for (std::size_t n = 1 + below(4); n > 0 && !broken.empty(); --n) {
      const std::size_t at = below(broken.size());
      switch (below(5)) {
        case 0:
          broken[at] = static_cast<char>(below(256));
          break;
        case 1:
          broken[at] = tricky[below(tricky.size())];
          break;
        case 2:
          broken.erase(at, 1 + below(8));
          break;
        case 3:
          broken.insert(at, broken.substr(below(broken.size()), below(20)));
          break;
        default:
          broken.insert(at, 1, tricky[below(tricky.size())]);
      }
    }
    read += error_of(broken).empty() ? 1 : 0;
  }
  // Otherwise the damage is so large, or so small, that only one of the two is tried.
  EXPECT_GT(read, runs / 100);
  EXPECT_LT(read, runs);
}

}  // namespace deburr
