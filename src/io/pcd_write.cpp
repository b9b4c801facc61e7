// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "io/bytes.hpp"
#include "io/comments.hpp"
#include "io/fields.hpp"
#include "io/losses.hpp"
#include "io/lzf.hpp"
#include "io/numbers.hpp"
#include "io/pcd.hpp"
#include "io/pcd_plan.hpp"
#include "io/scalar_type.hpp"
#include "io/strided.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;                        ///< points that are written at once
constexpr std::size_t block_bytes = std::size_t{1} << 18;  ///< that are packed at once

class PcdWriter {
 public:
  explicit PcdWriter(const WriteJob& job)
      : job_(job),
        cloud_(job.cloud),
        columns_(columns_of(job.cloud)),
        plan_(cloud_, columns_, losses_) {}

  std::vector<std::string> write() {
    PcdHeader& header = plan_.header;
    const std::size_t size = header.point_bytes * cloud_.size();
    if (header.encoding == Encoding::PcdCompressed &&
        size > std::numeric_limits<std::uint32_t>::max()) {
      header.encoding = Encoding::PcdBinary;
      losses_.add("PCD cannot compress more than 4 GB, the points were written uncompressed");
    }
    const CommentLines comments(cloud_.layout, "PCD");
    losses_.add_changed_comments(comments.changed());
    buffer_ = format_pcd_header(header, comments.text());
    if (header.encoding == Encoding::PcdCompressed) {
      write_compressed(size);
    } else {
      for (std::size_t begin = 0; begin < cloud_.size(); begin += block) {
        const std::size_t end = std::min(cloud_.size(), begin + block);
        header.encoding == Encoding::PcdAscii ? append_text(begin, end) : append_rows(begin, end);
        job_.flush(buffer_);
      }
    }
    job_.flush(buffer_);
    return losses_.take();
  }

 private:
  /// Stores the values of field k for the points [begin, end), a stride apart.
  void store(std::size_t k, char* to, std::size_t stride, std::size_t begin, std::size_t end) {
    const PcdField& field = plan_.header.fields[k];
    const PcdSource& source = plan_.sources[k];
    if (is_color(source)) {
      packed_colors_.resize(end - begin);
      plan_.colors.pack(begin, end, packed_colors_.data());
      return scatter(packed_colors_.data(), end - begin, to, stride);
    }
    with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
      if (source.coordinate != nullptr) {
        const Column& c = *source.coordinate;
        return scatter_axis<T>(c.vectors->data() + begin, c.axis(), end - begin, to, stride);
      }
      const T* from = std::get<std::vector<T>>(source.attribute->values).data();
      from += begin * field.count;
      if (field.count == 1) return scatter(from, end - begin, to, stride);
      const std::size_t count = field.count;
      for (std::size_t i = begin; i < end; ++i, to += stride, from += count) {
        scatter(from, count, to, sizeof(T));
      }
    });
  }

  static bool is_color(const PcdSource& source) {
    return source.coordinate == nullptr && source.attribute == nullptr;
  }

  void append_rows(std::size_t begin, std::size_t end) {
    const std::size_t stride = plan_.header.point_bytes;
    const std::size_t start = buffer_.size();
    buffer_.resize(start + (end - begin) * stride);
    for (std::size_t k = 0; k < plan_.sources.size(); ++k) {
      store(k, buffer_.data() + start + plan_.header.fields[k].offset, stride, begin, end);
    }
  }

  /// Column by column. What comes out is kept until its size is known, which stands before it.
  void write_compressed(std::size_t size) {
    std::string packed;
    packed.reserve(size / 2);
    std::string piece;
    for (std::size_t k = 0; k < plan_.sources.size(); ++k) {
      const PcdField& field = plan_.header.fields[k];
      const std::size_t stride = size_of(field.type) * field.count;
      const std::size_t step = std::max<std::size_t>(1, block_bytes / stride);
      for (std::size_t begin = 0; begin < cloud_.size(); begin += step) {
        job_.flush(buffer_);
        const std::size_t end = std::min(cloud_.size(), begin + step);
        piece.resize((end - begin) * stride);
        store(k, piece.data(), stride, begin, end);
        lzf_append(packed, piece);
      }
    }
    append_little(buffer_, static_cast<std::uint32_t>(packed.size()));
    append_little(buffer_, static_cast<std::uint32_t>(size));
    job_.flush(buffer_);
    job_.flush(packed);
  }

  void append_text(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < plan_.sources.size(); ++k) {
        append_value(k, i);
        buffer_ += ' ';
      }
      buffer_.back() = '\n';
    }
  }

  void append_value(std::size_t k, std::size_t i) {
    const PcdField& field = plan_.header.fields[k];
    const PcdSource& source = plan_.sources[k];
    if (is_color(source)) {
      std::uint32_t color = 0;
      plan_.colors.pack(i, i + 1, &color);
      append_number(buffer_, color);
    } else if (source.coordinate != nullptr) {
      append_number(buffer_, source.coordinate->coordinate(i));
    } else {
      with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
        const auto& values = std::get<std::vector<T>>(source.attribute->values);
        for (std::size_t j = 0; j < field.count; ++j) {
          if (j > 0) buffer_ += ' ';
          append_number(buffer_, values[i * field.count + j]);
        }
      });
    }
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  Losses losses_{"PCD"};
  PcdPlan plan_;
  std::vector<std::uint32_t> packed_colors_;
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_pcd(const WriteJob& job) { return PcdWriter(job).write(); }

}  // namespace deburr
