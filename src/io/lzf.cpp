// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/lzf.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "io/bytes.hpp"

namespace deburr {
namespace {

constexpr std::size_t longest_literal = 32;
constexpr std::size_t shortest_copy = 3;
constexpr std::size_t longest_copy = 264;
constexpr std::size_t farthest = 8192;
constexpr unsigned hash_bits = 14;

constexpr std::size_t room = 65536;  ///< what is unpacked at once, at least
/// Behind the window: copies of fixed size, which are fast, write more than they should.
constexpr std::size_t slack = longest_copy + longest_literal;

/// The next three bytes of at least four.
std::uint32_t three_at(const char* from) { return load_little<std::uint32_t>(from) & 0xffffffU; }

std::size_t hash_of(std::uint32_t three) { return (three * 2654435761U) >> (32 - hash_bits); }

/// How many bytes are the same at both places, up to `most`.
std::size_t common_length(const char* a, const char* b, std::size_t most) {
  std::size_t length = 0;
  for (; length + 8 <= most; length += 8) {
    const std::uint64_t difference =
        load_little<std::uint64_t>(a + length) ^ load_little<std::uint64_t>(b + length);
    if (difference != 0) return length + static_cast<std::size_t>(std::countr_zero(difference)) / 8;
  }
  while (length < most && a[length] == b[length]) ++length;
  return length;
}

/// Copies of fixed size, which are fast, where there is as much; there is always room for them.
char* put_literals(char* to, const char* from, std::size_t size, const char* stop) {
  while (size > 0) {
    const std::size_t count = std::min(size, longest_literal);
    const bool has_more = static_cast<std::size_t>(stop - from) >= longest_literal;
    *to++ = static_cast<char>(count - 1);
    std::memcpy(to, from, has_more ? longest_literal : count);
    to += count;
    from += count;
    size -= count;
  }
  return to;
}

char* put_copy(char* to, std::size_t back, std::size_t length) {
  const std::size_t far = back - 1;
  const std::size_t code = length - 2;
  if (code < 7) {
    *to++ = static_cast<char>(code << 5 | far >> 8);
  } else {
    *to++ = static_cast<char>(7U << 5 | far >> 8);
    *to++ = static_cast<char>(code - 7);
  }
  *to++ = static_cast<char>(far & 0xff);
  return to;
}

/// Copies bytes from further back, and maybe some more behind them: see `slack`.
void copy_back(char* to, std::size_t back, std::size_t length) {
  constexpr std::size_t word = 8;
  constexpr std::size_t wide = 16;
  if (back >= wide) {
    for (std::size_t k = 0; k < length; k += wide) std::memcpy(to + k, to + k - back, wide);
    return;
  }
  if (back < word) {
    // The copy runs into what it has written itself: a few bytes repeat, which a product does as
    // well, without waiting for each of them. Then so do as many bytes from further back.
    constexpr std::array<std::uint64_t, word> repeats{0,
                                                      0x0101010101010101U,
                                                      0x0001000100010001U,
                                                      0x0001000001000001U,
                                                      0x0000000100000001U,
                                                      0x0000010000000001U,
                                                      0x0001000000000001U,
                                                      0x0100000000000001U};
    const std::uint64_t some = load_little<std::uint64_t>(to - back);
    const std::uint64_t few = some & ((std::uint64_t{1} << 8 * back) - 1);
    store_little(to, few * repeats[back]);
    back *= (word + back - 1) / back;
    for (std::size_t k = word; k < length; k += word) std::memcpy(to + k, to + k - back, word);
    return;
  }
  for (std::size_t k = 0; k < length; k += word) std::memcpy(to + k, to + k - back, word);
}

}  // namespace

LzfUnpacker::LzfUnpacker(std::string_view packed)
    : packed_(packed), window_(farthest + room + slack) {}

bool LzfUnpacker::read(char* to, std::size_t size) {
  while (size > 0) {
    if (taken_ == end_ && (!fill() || taken_ == end_)) return false;
    const std::size_t count = std::min(size, end_ - taken_);
    std::memcpy(to, window_.data() + taken_, count);
    taken_ += count;
    to += count;
    size -= count;
  }
  return true;
}

/// All that the loop needs is local: bytes that are stored could be part of any member.
bool LzfUnpacker::fill() {
  const std::size_t kept = std::min(end_, farthest);
  std::memmove(window_.data(), window_.data() + end_ - kept, kept);
  char* const begin = window_.data();
  char* const full = begin + farthest + room;
  char* to = begin + kept;
  const char* from = packed_.data() + at_;
  const char* const stop = packed_.data() + packed_.size();
  while (from != stop && to < full) {
    const std::size_t code = static_cast<unsigned char>(*from++);
    if (code < longest_literal) {
      const std::size_t count = code + 1;
      const auto left = static_cast<std::size_t>(stop - from);
      if (left < count) return false;
      std::memcpy(to, from, left < longest_literal ? count : longest_literal);
      from += count;
      to += count;
      continue;
    }
    std::size_t length = (code >> 5) + 2;
    if (length == 9) {
      if (from == stop) return false;
      length += static_cast<unsigned char>(*from++);
    }
    if (from == stop) return false;
    const std::size_t back = ((code & 31) << 8 | static_cast<unsigned char>(*from++)) + 1;
    if (back > static_cast<std::size_t>(to - begin)) return false;
    copy_back(to, back, length);
    to += length;
  }
  at_ = static_cast<std::size_t>(from - packed_.data());
  taken_ = kept;
  end_ = static_cast<std::size_t>(to - begin);
  return true;
}

void lzf_append(std::string& packed, std::string_view data) {
  const std::size_t before = packed.size();
  packed.resize(before + data.size() + data.size() / longest_literal + 1 + longest_literal);
  char* to = packed.data() + before;
  const char* const begin = data.data();
  const char* const stop = begin + data.size();
  // The last place, plus one, of every hash of three bytes.
  std::vector<std::uint32_t> last(std::size_t{1} << hash_bits);
  std::size_t literals = 0;  // where those not yet written begin
  std::size_t i = 0;
  while (i + shortest_copy < data.size()) {
    const std::uint32_t three = three_at(begin + i);
    std::uint32_t& place = last[hash_of(three)];
    const std::size_t back = place > 0 ? i + 1 - place : 0;
    place = static_cast<std::uint32_t>(i + 1);
    if (back == 0 || back > farthest || three_at(begin + i - back) != three) {
      // Where nothing repeats for long, it is looked for less often.
      i += 1 + std::min<std::size_t>((i - literals) / 64, 7);
      continue;
    }
    const std::size_t length =
        common_length(begin + i - back, begin + i, std::min(data.size() - i, longest_copy));
    to = put_literals(to, begin + literals, i - literals, stop);
    to = put_copy(to, back, length);
    i += length;
    literals = i;
  }
  to = put_literals(to, begin + literals, data.size() - literals, stop);
  packed.resize(static_cast<std::size_t>(to - packed.data()));
}

}  // namespace deburr
