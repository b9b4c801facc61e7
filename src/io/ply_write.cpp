// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <set>

#include "io/comments.hpp"
#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/losses.hpp"
#include "io/numbers.hpp"
#include "io/ply.hpp"
#include "io/ply_body.hpp"
#include "io/ply_header.hpp"
#include "io/ply_types.hpp"
#include "io/scalar_type.hpp"
#include "io/strided.hpp"

namespace deburr {
namespace {

/// A property and where its values come from.
struct PlySource {
  PlyProperty property;
  const Column* coordinate = nullptr;
  const Attribute* attribute = nullptr;
};

class PlyWriter {
 public:
  explicit PlyWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    const Encoding encoding = cloud_.layout.encoding;
    const bool is_ply_layout = encoding == Encoding::PlyAscii ||
                               encoding == Encoding::PlyLittleEndian ||
                               encoding == Encoding::PlyBigEndian;
    header_.encoding = is_ply_layout ? encoding : Encoding::PlyLittleEndian;
    header_.comments = cloud_.layout.comments;
    header_.obj_info = cloud_.layout.obj_info;
    add_elements(true);
    add_vertices(is_ply_layout);
    add_elements(false);
    losses_.add_changed_comments(CommentLines(cloud_.layout, "PLY").changed());
    losses_.add_foreign_blocks(cloud_.layout, "PLY ");
  }

  std::vector<std::string> write() {
    buffer_ = format_ply_header(header_);
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      header_.encoding == Encoding::PlyAscii ? write_text(header_.elements[k].size, sources_[k])
                                             : write_binary(header_.elements[k].size, sources_[k]);
    }
    flush();
    return losses_.take();
  }

 private:
  void add_elements(bool before_points) {
    for (const Element& element : cloud_.layout.elements) {
      if (element.before_points != before_points) continue;
      std::vector<PlySource> sources;
      std::set<std::string> names;
      for (const Attribute& a : element.attributes) add_attribute(sources, names, a, a.name);
      if (sources.empty() && !element.attributes.empty()) continue;  // said of its attributes
      add_element(element.name, element.size, std::move(sources));
    }
  }

  void add_vertices(bool is_ply_layout) {
    std::vector<PlySource> sources;
    std::set<std::string> names;
    // Names of coordinates in a text file mean nothing to readers of PLY.
    const auto name_of = [&](const Column& c) {
      return is_ply_layout ? c.name : std::string(role_names[static_cast<std::size_t>(c.role)]);
    };
    for (const Column& c : columns_) {
      if (c.role != no_role) names.insert(name_of(c));
    }
    const bool is_text = header_.encoding == Encoding::PlyAscii;
    const bool promote_points = !hold_exactly(columns_, 0, is_text);
    const bool promote_normals = !hold_exactly(columns_, 3, is_text);
    for (const Column& c : columns_) {
      if (c.role == no_role) {
        if (add_attribute(sources, names, *c.attribute, c.name)) losses_.add_renamed(c);
        continue;
      }
      const bool promote = c.role < 3 ? promote_points : promote_normals;
      sources.push_back({{name_of(c), promote ? ScalarType::Float64 : c.type}, &c, nullptr});
    }
    add_element("vertex", cloud_.size(), std::move(sources));
  }

  /// Whether PLY can hold it.
  bool add_attribute(std::vector<PlySource>& sources, std::set<std::string>& names,
                     const Attribute& attribute, const std::string& name) {
    const Attribute* held = &attribute;
    if (!is_ply_type(attribute.type())) {
      std::optional<Attribute> narrow = narrow_to_ply(attribute);
      if (!narrow) {
        losses_.add(attribute);
        return false;
      }
      held = &narrowed_.emplace_back(std::move(*narrow));
    }
    sources.push_back({{ply_name(name, names), held->type(), held->is_list(),
                        held->is_list() ? length_type_of(*held) : ScalarType::UInt8},
                       nullptr,
                       held});
    return true;
  }

  void add_element(const std::string& name, std::size_t size, std::vector<PlySource> sources) {
    PlyElement element{ply_name(name, element_names_), size, {}};
    for (const PlySource& s : sources) element.properties.push_back(s.property);
    header_.elements.push_back(std::move(element));
    sources_.push_back(std::move(sources));
  }

  /// PLY separates names by blanks.
  std::string ply_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted;
    std::ranges::replace_if(
        name, [](char c) { return c == '\n' || is_blank(c); }, '_');
    if (name.empty()) name = "_";
    while (!taken.insert(name).second) name += '_';
    losses_.add_name(wanted, name);
    return name;
  }

  void flush() { job_.flush(buffer_); }

  template <typename T>
  void store(std::size_t offset, T value) {
    if (needs_swap(header_.encoding)) value = swap_bytes(value);
    std::memcpy(buffer_.data() + offset, &value, sizeof(T));
  }

  template <typename T>
  void append(T value) {
    buffer_.resize(buffer_.size() + sizeof(T));
    store(buffer_.size() - sizeof(T), value);
  }

  void write_binary(std::size_t size, const std::vector<PlySource>& sources) {
    const bool has_list =
        std::ranges::any_of(sources, [](const PlySource& s) { return s.property.is_list; });
    if (sources.empty()) return;
    for (std::size_t begin = 0; begin < size; begin += ply_block) {
      const std::size_t end = std::min(size, begin + ply_block);
      has_list ? write_rows(begin, end, sources) : write_scalars(begin, end, sources);
      flush();
    }
  }

  /// Column by column.
  void write_scalars(std::size_t begin, std::size_t end, const std::vector<PlySource>& sources) {
    std::size_t stride = 0;
    for (const PlySource& s : sources) stride += size_of(s.property.type);
    const std::size_t start = buffer_.size();
    buffer_.resize(start + (end - begin) * stride);
    char* to = buffer_.data() + start;
    for (const PlySource& s : sources) {
      with_ply_type(s.property.type, [&]<typename T>(std::type_identity<T>) {
        if (s.coordinate != nullptr) {
          const Column& c = *s.coordinate;
          scatter_axis<T>(c.vectors->data() + begin, c.axis(), end - begin, to, stride);
        } else {
          const auto& values = std::get<std::vector<T>>(s.attribute->values);
          scatter(values.data() + begin, end - begin, to, stride);
        }
        if (header_.encoding != Encoding::PlyBigEndian) return;
        for (std::size_t i = 0; i < end - begin; ++i) {
          std::reverse(to + i * stride, to + i * stride + sizeof(T));
        }
      });
      to += size_of(s.property.type);
    }
  }

  void write_rows(std::size_t begin, std::size_t end, const std::vector<PlySource>& sources) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const PlySource& s : sources) {
        with_ply_type(s.property.type, [&]<typename T>(std::type_identity<T>) {
          if (!s.property.is_list) return append(value<T>(s, i));
          const auto& values = std::get<std::vector<T>>(s.attribute->values);
          const std::size_t from = s.attribute->offsets[i];
          const std::size_t to = s.attribute->offsets[i + 1];
          with_ply_type(s.property.length_type, [&]<typename L>(std::type_identity<L>) {
            append(static_cast<L>(to - from));
          });
          for (std::size_t k = from; k < to; ++k) append(values[k]);
        });
      }
    }
  }

  template <typename T>
  static T value(const PlySource& s, std::size_t i) {
    return s.coordinate != nullptr ? static_cast<T>(s.coordinate->coordinate(i))
                                   : std::get<std::vector<T>>(s.attribute->values)[i];
  }

  void write_text(std::size_t size, const std::vector<PlySource>& sources) {
    if (sources.empty()) return;
    for (std::size_t i = 0; i < size; ++i) {
      if (i % ply_block == 0) flush();
      for (const PlySource& s : sources) {
        append_text(s, i);
        buffer_ += ' ';
      }
      buffer_.back() = '\n';
    }
  }

  void append_text(const PlySource& s, std::size_t i) {
    with_ply_type(s.property.type, [&]<typename T>(std::type_identity<T>) {
      if (s.property.is_list) {
        const auto& values = std::get<std::vector<T>>(s.attribute->values);
        const std::size_t from = s.attribute->offsets[i];
        const std::size_t to = s.attribute->offsets[i + 1];
        append_number(buffer_, to - from);
        for (std::size_t k = from; k < to; ++k) append_number(buffer_ += ' ', values[k]);
      } else if (s.coordinate != nullptr && std::floating_point<T>) {
        // The double also where the type is float: see hold_exactly().
        append_number(buffer_, s.coordinate->coordinate(i));
      } else {
        append_number(buffer_, value<T>(s, i));
      }
    });
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  PlyHeader header_;
  std::set<std::string> element_names_;
  std::vector<std::vector<PlySource>> sources_;  ///< of each element
  std::deque<Attribute> narrowed_;               ///< attributes in a type that PLY has
  Losses losses_{"PLY"};
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_ply(const WriteJob& job) { return PlyWriter(job).write(); }

}  // namespace deburr
