// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "io/ply_body.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

/// Bytes that an item has at least; exact without lists.
std::size_t least_bytes(const PlyElement& element, bool is_text) {
  std::size_t bytes = 0;
  for (const PlyProperty& p : element.properties) {
    bytes += is_text ? 2 : size_of(p.is_list ? p.length_type : p.type);
  }
  return bytes;
}

}  // namespace

void PlyBodyReader::fail_at_end(const PlyElement& element, std::size_t row) const {
  source_.fail(fmt::format("byte {}: the file ends in row {} of {} of element '{}'",
                           source_.data.size(), row + 1, element.size, element.name));
}

void PlyBodyReader::check_size(const PlyElement& element) const {
  const bool is_text = header_.encoding == Encoding::PlyAscii;
  const std::size_t bytes = least_bytes(element, is_text);
  if (bytes == 0) return;
  // The last number of a text needs no line end.
  const std::size_t left = source_.data.size() - std::min(offset_, source_.data.size());
  const std::size_t rows = (left + (is_text ? 1 : 0)) / bytes;
  if (element.size > rows) fail_at_end(element, rows);
}

void PlyBodyReader::read(const PlyElement& element, std::vector<PlyTarget>& targets) {
  if (targets.empty()) return;  // rows without properties take no room
  if (header_.encoding == Encoding::PlyAscii) return read_text(element, targets);
  const bool has_list =
      std::ranges::any_of(targets, [](const PlyTarget& t) { return t.property.is_list; });
  has_list ? read_rows(element, targets) : read_scalars(element, targets);
}

void PlyBodyReader::read_scalars(const PlyElement& element, std::vector<PlyTarget>& targets) {
  const std::size_t stride = least_bytes(element, false);
  // Column by column, in blocks of rows that stay in the cache.
  for (std::size_t begin = 0; begin < element.size; begin += ply_block) {
    source_.check_cancelled();
    const std::size_t end = std::min(element.size, begin + ply_block);
    std::size_t offset = offset_ + begin * stride;
    for (PlyTarget& t : targets) {
      with_ply_type(t.property.type, [&]<typename T>(std::type_identity<T>) {
        const auto value = [&](std::size_t i) { return load<T>(offset + (i - begin) * stride); };
        if (t.vectors != nullptr) {
          for (std::size_t i = begin; i < end; ++i) {
            (*t.vectors)[i].*t.axis = static_cast<double>(value(i));
          }
        } else {
          auto& values = std::get<std::vector<T>>(t.attribute->values);
          for (std::size_t i = begin; i < end; ++i) values[i] = value(i);
        }
      });
      offset += size_of(t.property.type);
    }
  }
  offset_ += element.size * stride;
}

void PlyBodyReader::read_rows(const PlyElement& element, std::vector<PlyTarget>& targets) {
  for (std::size_t row = 0; row < element.size; ++row) {
    if (row % ply_block == 0) source_.check_cancelled();
    for (PlyTarget& t : targets) {
      if (t.property.is_list) {
        read_list(element, row, t);
        continue;
      }
      with_ply_type(t.property.type, [&]<typename T>(std::type_identity<T>) {
        if (source_.data.size() - offset_ < sizeof(T)) fail_at_end(element, row);
        const T value = load<T>(offset_);
        offset_ += sizeof(T);
        if (t.vectors != nullptr) {
          (*t.vectors)[row].*t.axis = static_cast<double>(value);
        } else {
          std::get<std::vector<T>>(t.attribute->values)[row] = value;
        }
      });
    }
  }
}

void PlyBodyReader::read_list(const PlyElement& element, std::size_t row, PlyTarget& target) {
  const std::size_t length_size = size_of(target.property.length_type);
  if (source_.data.size() - offset_ < length_size) fail_at_end(element, row);
  const auto length =
      with_ply_type(target.property.length_type, [&]<typename T>(std::type_identity<T>) {
        return static_cast<std::int64_t>(load<T>(offset_));
      });
  if (length < 0) {
    source_.fail(fmt::format("byte {}: a list of element '{}', row {}, has length {}", offset_,
                             element.name, row + 1, length));
  }
  offset_ += length_size;
  const auto count = static_cast<std::size_t>(length);
  with_ply_type(target.property.type, [&]<typename T>(std::type_identity<T>) {
    if ((source_.data.size() - offset_) / sizeof(T) < count) fail_at_end(element, row);
    auto& values = std::get<std::vector<T>>(target.attribute->values);
    for (std::size_t i = 0; i < count; ++i) values.push_back(load<T>(offset_ + i * sizeof(T)));
    target.attribute->offsets.push_back(values.size());
  });
  offset_ += count * size_of(target.property.type);
}

}  // namespace deburr
