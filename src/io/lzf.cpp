// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/lzf.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace deburr {
namespace {

constexpr std::size_t longest_literal = 32;
constexpr std::size_t shortest_copy = 3;
constexpr std::size_t longest_copy = 264;
constexpr std::size_t farthest = 8192;
constexpr unsigned hash_bits = 14;

std::uint32_t byte_at(std::string_view data, std::size_t i) {
  return static_cast<unsigned char>(data[i]);
}

std::uint32_t hash_of_three(std::string_view data, std::size_t i) {
  const std::uint32_t three =
      byte_at(data, i) << 16 | byte_at(data, i + 1) << 8 | byte_at(data, i + 2);
  return (three * 2654435761U) >> (32 - hash_bits);
}

void append_literals(std::string& packed, std::string_view data) {
  while (!data.empty()) {
    const std::size_t count = std::min(data.size(), longest_literal);
    packed += static_cast<char>(count - 1);
    packed += data.substr(0, count);
    data.remove_prefix(count);
  }
}

void append_copy(std::string& packed, std::size_t back, std::size_t length) {
  const std::size_t far = back - 1;
  const std::size_t code = length - 2;
  if (code < 7) {
    packed += static_cast<char>(code << 5 | far >> 8);
  } else {
    packed += static_cast<char>(7U << 5 | far >> 8);
    packed += static_cast<char>(code - 7);
  }
  packed += static_cast<char>(far & 0xff);
}

}  // namespace

std::optional<std::string> lzf_unpack(std::string_view packed, std::size_t size) {
  std::string data(size, '\0');
  char* const begin = data.data();
  std::size_t done = 0;
  for (std::size_t i = 0; i < packed.size();) {
    const std::size_t code = byte_at(packed, i++);
    if (code < longest_literal) {
      const std::size_t count = code + 1;
      if (packed.size() - i < count || size - done < count) return std::nullopt;
      std::copy_n(packed.data() + i, count, begin + done);
      i += count;
      done += count;
      continue;
    }
    std::size_t length = (code >> 5) + 2;
    if (length == 9) {
      if (i == packed.size()) return std::nullopt;
      length += byte_at(packed, i++);
    }
    if (i == packed.size()) return std::nullopt;
    const std::size_t back = ((code & 31) << 8 | byte_at(packed, i++)) + 1;
    if (back > done || size - done < length) return std::nullopt;
    // Byte by byte: a copy may run into what it has written itself.
    char* const to = begin + done;
    for (std::size_t k = 0; k < length; ++k) to[k] = *(to - back + k);
    done += length;
  }
  if (done != size) return std::nullopt;
  return data;
}

std::string lzf_pack(std::string_view data) {
  std::string packed;
  packed.reserve(data.size() / 2);
  // The last place, plus one, of every hash of three bytes.
  std::vector<std::size_t> last(std::size_t{1} << hash_bits);
  std::size_t literals = 0;  // where those not yet written begin
  std::size_t i = 0;
  while (i + shortest_copy <= data.size()) {
    std::size_t& place = last[hash_of_three(data, i)];
    const std::size_t from = place;
    place = i + 1;
    const bool known = from > 0 && i - (from - 1) <= farthest &&
                       data.substr(from - 1, shortest_copy) == data.substr(i, shortest_copy);
    if (!known) {
      ++i;
      continue;
    }
    const std::size_t most = std::min(data.size() - i, longest_copy);
    std::size_t length = shortest_copy;
    while (length < most && data[from - 1 + length] == data[i + length]) ++length;
    append_literals(packed, data.substr(literals, i - literals));
    append_copy(packed, i - (from - 1), length);
    i += length;
    literals = i;
  }
  append_literals(packed, data.substr(literals));
  return packed;
}

}  // namespace deburr
