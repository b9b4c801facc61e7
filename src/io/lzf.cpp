// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/lzf.hpp"

#include <algorithm>
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

std::size_t byte_at(std::string_view data, std::size_t i) {
  return static_cast<unsigned char>(data[i]);
}

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

char* put_literals(char* to, const char* from, std::size_t size) {
  while (size > 0) {
    const std::size_t count = std::min(size, longest_literal);
    *to++ = static_cast<char>(count - 1);
    std::memcpy(to, from, count);
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

bool LzfUnpacker::fill() {
  const std::size_t kept = std::min(end_, farthest);
  std::memmove(window_.data(), window_.data() + end_ - kept, kept);
  taken_ = end_ = kept;
  while (at_ < packed_.size() && end_ < farthest + room) {
    const std::size_t code = byte_at(packed_, at_++);
    if (!(code < longest_literal ? unpack_literals(code) : unpack_copy(code))) return false;
  }
  return true;
}

bool LzfUnpacker::unpack_literals(std::size_t code) {
  const std::size_t count = code + 1;
  const std::size_t left = packed_.size() - at_;
  if (left < count) return false;
  std::memcpy(window_.data() + end_, packed_.data() + at_,
              left < longest_literal ? count : longest_literal);
  at_ += count;
  end_ += count;
  return true;
}

bool LzfUnpacker::unpack_copy(std::size_t code) {
  std::size_t length = (code >> 5) + 2;
  if (length == 9) {
    if (at_ == packed_.size()) return false;
    length += byte_at(packed_, at_++);
  }
  if (at_ == packed_.size()) return false;
  const std::size_t back = ((code & 31) << 8 | byte_at(packed_, at_++)) + 1;
  if (back > end_) return false;
  char* const to = window_.data() + end_;
  constexpr std::size_t word = 8;
  if (back >= word) {
    for (std::size_t k = 0; k < length; k += word) std::memcpy(to + k, to + k - back, word);
  } else {
    // Byte by byte: the copy runs into what it has written itself.
    for (std::size_t k = 0; k < length; ++k) to[k] = *(to + k - back);
  }
  end_ += length;
  return true;
}

void lzf_append(std::string& packed, std::string_view data) {
  const std::size_t before = packed.size();
  packed.resize(before + data.size() + data.size() / longest_literal + 1);
  char* to = packed.data() + before;
  const char* const begin = data.data();
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
    to = put_literals(to, begin + literals, i - literals);
    to = put_copy(to, back, length);
    i += length;
    literals = i;
  }
  to = put_literals(to, begin + literals, data.size() - literals);
  packed.resize(static_cast<std::size_t>(to - packed.data()));
}

}  // namespace deburr
