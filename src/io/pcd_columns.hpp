// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/pcd_header.hpp"
#include "io/text_row.hpp"

namespace deburr {

/// The columns of a cloud that is read from PCD, and where the values of each field go.
class PcdColumns {
 public:
  /// Takes memory for all points: whoever calls has seen to it that the file is as long.
  /// @throws IoError  if a coordinate is missing
  PcdColumns(const Source& source, const PcdHeader& header);
  PcdColumns(const PcdColumns&) = delete;
  PcdColumns& operator=(const PcdColumns&) = delete;

  /// Takes field k of the points [begin, end) from numbers in binary, which are a stride apart.
  /// @param data  those of point begin
  void take(std::size_t k, const char* data, std::size_t stride, std::size_t begin,
            std::size_t end);
  /// Takes field k of point i from a line of text.
  void take(std::size_t k, TextRow& row, std::size_t i);

  /// The cloud, once everything has been taken.
  [[nodiscard]] PointCloud finish();

 private:
  /// Where the values of a field go.
  struct Target {
    std::vector<Vec3>* vectors = nullptr;
    double Vec3::*axis = nullptr;
    std::size_t attribute = 0;  ///< or the first of four for colours
    bool is_color = false;
  };

  void add_colors(const PcdField& field, Target& target);
  void take_colors(const Target& target, const char* data, std::size_t stride, std::size_t begin,
                   std::size_t end);
  void drop_repeated_colors();

  const PcdHeader& header_;
  PointCloud cloud_;
  std::vector<Target> targets_;
  bool has_color_ = false;
  bool has_alpha_ = false;
};

}  // namespace deburr
