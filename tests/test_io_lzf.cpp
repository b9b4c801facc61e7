// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "io/lzf.hpp"

namespace deburr {
namespace {

/// A copy as the format has it.
std::string copy(std::size_t back, std::size_t length) {
  const std::size_t far = back - 1;
  const std::size_t code = length - 2;
  std::string bytes(1, static_cast<char>(std::min<std::size_t>(code, 7) << 5 | far >> 8));
  if (code >= 7) bytes += static_cast<char>(code - 7);
  return bytes + static_cast<char>(far & 0xff);
}

std::string literals(const std::string& text) {
  return std::string(1, static_cast<char>(text.size() - 1)) + text;
}

// Copies are made of words: each distance around their size, and each length.
TEST(LzfCopies, AreThoseOfSingleBytes) {
  std::mt19937 random(1);
  std::string start(32, '\0');
  for (char& c : start) c = static_cast<char>(random());
  for (std::size_t back = 1; back <= 32; ++back) {
    for (std::size_t length = 3; length <= 264; ++length) {
      const std::string packed = literals(start) + copy(back, length) + literals("end");
      std::string expected = start;
      for (std::size_t k = 0; k < length; ++k) expected += expected[expected.size() - back];
      expected += "end";
      LzfUnpacker unpacker(packed);
      std::string data(expected.size(), '\0');
      ASSERT_TRUE(unpacker.read(data.data(), data.size())) << back << ' ' << length;
      ASSERT_TRUE(unpacker.at_end());
      ASSERT_EQ(data, expected) << back << ' ' << length;
    }
  }
}

TEST(LzfCopies, FromBeforeTheBeginningAreRefused) {
  std::string data(8, '\0');
  for (std::size_t back = 1; back <= 9; ++back) {
    const std::string packed = literals("abcd") + copy(back, 4);
    LzfUnpacker unpacker(packed);
    EXPECT_EQ(unpacker.read(data.data(), data.size()), back <= 4) << back;
  }
}

}  // namespace
}  // namespace deburr
