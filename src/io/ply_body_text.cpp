// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/ply_body.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

/// Takes numbers off the front of a line.
class Row {
 public:
  Row(const Source& source, const PlyElement& element, const Lines& lines)
      : source_(source), element_(element), number_(lines.number()), rest_(lines.line()) {}

  template <typename T>
  T take(const PlyProperty& property) {
    const std::string_view token = next_token(rest_);
    if (token.empty()) {
      fail(fmt::format("the row ends before property '{}' of element '{}'", property.name,
                       element_.name));
    }
    const std::optional<T> value = parse_number<T>(token);
    if (!value) fail(fmt::format("'{}' is no value for property '{}'", token, property.name));
    return *value;
  }

  std::size_t take_length(const PlyProperty& property) {
    const auto length = take<std::int64_t>(property);
    if (length < 0) fail(fmt::format("list '{}' has length {}", property.name, length));
    return static_cast<std::size_t>(length);
  }

  void expect_end() {
    const std::string_view extra = next_token(rest_);
    if (!extra.empty()) {
      fail(fmt::format("unexpected '{}' behind the last property of element '{}'", extra,
                       element_.name));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    source_.fail(fmt::format("line {}: {}", number_, what));
  }

  const Source& source_;
  const PlyElement& element_;
  std::size_t number_;
  std::string_view rest_;
};

void read_value(Row& row, std::size_t i, PlyTarget& target) {
  if (target.vectors != nullptr) {
    // The text is more exact than a declared type of float.
    (*target.vectors)[i].*target.axis = row.take<double>(target.property);
    return;
  }
  with_ply_type(target.property.type, [&]<typename T>(std::type_identity<T>) {
    auto& values = std::get<std::vector<T>>(target.attribute->values);
    if (!target.property.is_list) {
      values[i] = row.take<T>(target.property);
      return;
    }
    for (std::size_t n = row.take_length(target.property); n > 0; --n) {
      values.push_back(row.take<T>(target.property));
    }
    target.attribute->offsets.push_back(values.size());
  });
}

}  // namespace

void PlyBodyReader::read_text(const PlyElement& element, std::vector<PlyTarget>& targets) {
  Lines lines(source_.data, offset_, line_);
  for (std::size_t i = 0; i < element.size; ++i) {
    if (i % ply_block == 0) source_.check_cancelled();
    if (!lines.next_full()) fail_at_end(element, i);
    Row row(source_, element, lines);
    for (PlyTarget& target : targets) read_value(row, i, target);
    row.expect_end();
  }
  offset_ = lines.end_offset();
  line_ = lines.number();
}

}  // namespace deburr
