// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/pcd_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "io/comments.hpp"
#include "io/scalar_type.hpp"
#include "io/text_row.hpp"

namespace deburr {
namespace {

struct PcdType {
  char letter;
  std::size_t size;
  ScalarType type;
};

constexpr std::array<PcdType, 10> types{{{'I', 1, ScalarType::Int8},
                                         {'U', 1, ScalarType::UInt8},
                                         {'I', 2, ScalarType::Int16},
                                         {'U', 2, ScalarType::UInt16},
                                         {'I', 4, ScalarType::Int32},
                                         {'U', 4, ScalarType::UInt32},
                                         {'I', 8, ScalarType::Int64},
                                         {'U', 8, ScalarType::UInt64},
                                         {'F', 4, ScalarType::Float32},
                                         {'F', 8, ScalarType::Float64}}};

struct EncodingName {
  std::string_view name;
  Encoding encoding;
};
constexpr std::array<EncodingName, 3> encodings{{{"ascii", Encoding::PcdAscii},
                                                 {"binary", Encoding::PcdBinary},
                                                 {"binary_compressed", Encoding::PcdCompressed}}};

class PcdHeaderParser {
 public:
  explicit PcdHeaderParser(const Source& source) : source_(source), lines_(source.data) {}

  PcdHeader parse() {
    while (lines_.next_full()) {
      if (lines_.line().starts_with('#')) {
        // The first line, which is written anew.
        const bool is_first = lines_.number() == 1;
        if (is_first && trim(lines_.line().substr(1)).starts_with(".PCD")) continue;
        header_.comments.push_back(comment_behind(lines_.raw(), lines_.raw().find('#') + 1));
        continue;
      }
      TextRow row(source_, lines_);
      parse_line(row.word(), row);
      if (done_) return finish(row);
    }
    source_.fail("the header of the PCD file does not end with DATA");
  }

 private:
  void parse_line(std::string_view key, TextRow& row) {
    if (key == "VERSION") {
      (void)row.word();
    } else if (key == "FIELDS" || key == "COLUMNS") {
      while (!row.at_end()) names_.emplace_back(row.word());
    } else if (key == "SIZE") {
      while (!row.at_end()) sizes_.push_back(row.take<std::size_t>("SIZE"));
    } else if (key == "TYPE") {
      while (!row.at_end()) letters_.emplace_back(row.word());
    } else if (key == "COUNT") {
      while (!row.at_end()) counts_.push_back(row.take<std::size_t>("COUNT"));
    } else if (key == "WIDTH") {
      width_ = row.take<std::size_t>("WIDTH");
    } else if (key == "HEIGHT") {
      height_ = row.take<std::size_t>("HEIGHT");
    } else if (key == "VIEWPOINT") {
      parse_viewpoint(row);
    } else if (key == "POINTS") {
      points_ = row.take<std::size_t>("POINTS");
    } else if (key == "DATA") {
      const std::string_view name = row.word();
      const auto* const found = std::ranges::find(encodings, name, &EncodingName::name);
      if (found == encodings.end()) row.fail(fmt::format("unknown DATA '{}'", name));
      header_.encoding = found->encoding;
      done_ = true;
    } else {
      row.fail(fmt::format("unknown keyword '{}' in the header", key.substr(0, 40)));
    }
  }

  void parse_viewpoint(TextRow& row) {
    header_.viewpoint.clear();
    for (int k = 0; k < 7; ++k) {
      const std::string_view word = row.word();
      (void)row.parse<double>(word, "VIEWPOINT");
      header_.viewpoint += header_.viewpoint.empty() ? "" : " ";
      header_.viewpoint += word;
    }
  }

  PcdHeader finish(const TextRow& row) {
    const std::size_t n = names_.size();
    if (n == 0) row.fail("the header has no FIELDS");
    if (counts_.empty()) counts_.assign(n, 1);
    const auto check = [&](std::string_view key, std::size_t count) {
      if (count != n) row.fail(fmt::format("{} FIELDS, but {} of {}", n, count, key));
    };
    check("SIZE", sizes_.size());
    check("TYPE", letters_.size());
    check("COUNT", counts_.size());
    std::set<std::string_view> seen;
    for (std::size_t k = 0; k < n; ++k) add_field(row, k, seen);
    header_.width = width_.value_or(points_.value_or(0));
    header_.height = width_ ? height_.value_or(1) : 1;
    const bool overflows =
        header_.height != 0 && header_.width > SIZE_MAX / header_.height / header_.point_bytes;
    if (overflows) row.fail(fmt::format("{} x {} points", header_.width, header_.height));
    if (points_ && *points_ != header_.points()) {
      row.fail(fmt::format("WIDTH {} x HEIGHT {} are not {} POINTS", header_.width, header_.height,
                           *points_));
    }
    if (!points_ && !width_) row.fail("the header has no POINTS");
    header_.bytes = std::min(lines_.end_offset(), source_.data.size());
    header_.lines = lines_.number();
    return std::move(header_);
  }

  void add_field(const TextRow& row, std::size_t k, std::set<std::string_view>& seen) {
    const auto* const found = std::ranges::find_if(types, [&](const PcdType& t) {
      return letters_[k].size() == 1 && t.letter == letters_[k][0] && t.size == sizes_[k];
    });
    if (found == types.end()) {
      row.fail(fmt::format("field '{}' has the unknown TYPE {} of SIZE {}", names_[k], letters_[k],
                           sizes_[k]));
    }
    constexpr std::size_t most = std::size_t{1} << 24;  // values of a field
    if (counts_[k] == 0 || counts_[k] > most) {
      row.fail(fmt::format("field '{}' has COUNT {}", names_[k], counts_[k]));
    }
    const PcdField field{names_[k], found->type, counts_[k], header_.point_bytes};
    if (!field.is_padding() && !seen.insert(names_[k]).second) {
      row.fail(fmt::format("two fields have the name '{}'", names_[k]));
    }
    header_.point_bytes += sizes_[k] * counts_[k];
    header_.fields.push_back(field);
  }

  const Source& source_;
  Lines lines_;
  PcdHeader header_;
  std::vector<std::string> names_;
  std::vector<std::size_t> sizes_;
  std::vector<std::string> letters_;
  std::vector<std::size_t> counts_;
  std::optional<std::size_t> width_;
  std::optional<std::size_t> height_;
  std::optional<std::size_t> points_;
  bool done_ = false;
};

}  // namespace

PcdHeader parse_pcd_header(const Source& source) { return PcdHeaderParser(source).parse(); }

std::string format_pcd_header(const PcdHeader& header, std::string_view comments) {
  std::string names;
  std::string sizes;
  std::string letters;
  std::string counts;
  for (const PcdField& field : header.fields) {
    const auto* const type = std::ranges::find(types, field.type, &PcdType::type);
    names += ' ' + field.name;
    sizes += fmt::format(" {}", type->size);
    letters += fmt::format(" {}", type->letter);
    counts += fmt::format(" {}", field.count);
  }
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
  text += comments;
  text += fmt::format(
      "VERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\nWIDTH {}\nHEIGHT {}\nVIEWPOINT {}\n"
      "POINTS {}\nDATA {}\n",
      names, sizes, letters, counts, header.width, header.height, header.viewpoint, header.points(),
      std::ranges::find(encodings, header.encoding, &EncodingName::encoding)->name);
  return text;
}

}  // namespace deburr
