// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "deburr/point_cloud.hpp"

namespace deburr {

/// Makes clouds of a few points with fields of any kind, the same for the same seed.
class RandomClouds {
 public:
  explicit RandomClouds(unsigned seed) : random_(seed) {}

  PointCloud next() {
    PointCloud cloud;
    const std::size_t points = 3 + below(30);
    for (std::size_t i = 0; i < points; ++i) {
      cloud.points.push_back({5e5 + real(), 5.4e6 + real(), real()});
    }
    if (below(2) == 0) {
      for (std::size_t i = 0; i < points; ++i) cloud.normals.push_back({0.6, 0.0, 0.8});
    }
    const std::size_t fields = below(6);
    for (std::size_t k = 0; k < fields; ++k) cloud.attributes.push_back(attribute(k, points));
    if (below(2) == 0) add_colors(cloud);
    if (below(2) == 0) add_faces(cloud);
    for (std::size_t k = below(3); k > 0; --k) {
      cloud.layout.comments.push_back(below(2) == 0 ? "comment " + std::to_string(k) : comment());
    }
    return cloud;
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  double real() { return std::uniform_real_distribution<>(-100, 100)(random_); }

  template <typename T>
  std::vector<T> values(std::size_t count) {
    std::vector<T> result;
    for (std::size_t i = 0; i < count; ++i) {
      if constexpr (std::is_same_v<T, std::string>) {
        constexpr const char* words[] = {"wall", "",    "a b", "say \"hi\"",
                                         "1",    "x,y", "#",   "\x01\r"};
        result.emplace_back(words[below(std::size(words))]);
      } else if constexpr (std::is_floating_point_v<T>) {
        result.push_back(static_cast<T>(below(3) == 0 ? std::round(real()) : real()));
      } else {
        // As many as words of 32 bits have, and of 64 bits.
        const std::uint64_t large = std::uint64_t{random_()} << (below(2) == 0 ? 32 : 0);
        result.push_back(static_cast<T>(below(4) == 0 ? large : below(20)));
      }
    }
    return result;
  }

  Values of_type(std::size_t type, std::size_t count) {
    switch (type) {
      case 0:
        return values<std::int8_t>(count);
      case 1:
        return values<std::uint8_t>(count);
      case 2:
        return values<std::int16_t>(count);
      case 3:
        return values<std::uint16_t>(count);
      case 4:
        return values<std::int32_t>(count);
      case 5:
        return values<std::uint32_t>(count);
      case 6:
        return values<std::int64_t>(count);
      case 7:
        return values<std::uint64_t>(count);
      case 8:
        return values<float>(count);
      case 9:
        return values<double>(count);
      default:
        return values<std::string>(count);
    }
  }

  Attribute attribute(std::size_t number, std::size_t points) {
    // Some have fields of a few bits in LAS, some are no words for every format.
    constexpr const char* names[] = {"intensity",
                                     "gps_time",
                                     "classification",
                                     "label",
                                     "return_number",
                                     "range",
                                     "number_of_returns",
                                     "user_data",
                                     "scan_direction_flag",
                                     "point_source_id",
                                     "scan_angle",
                                     "scan_angle_rank",
                                     "two words",
                                     "\x1b[0m",
                                     "overlap"};
    Attribute result;
    const std::string own = "f" + std::to_string(number);
    // All different: five numbers, three names for each.
    result.name = below(3) > 0 ? names[number + 5 * below(3)] : own;
    const std::size_t type = below(11);
    const std::size_t shape = type == 10 ? 0 : below(6);
    if (shape == 0 || shape > 2) {
      result.values = of_type(type, points);
      return result;
    }
    result.offsets = {0};
    for (std::size_t i = 0; i < points; ++i) {
      result.offsets.push_back(result.offsets.back() + (shape == 1 ? 3 : below(4)));
    }
    result.values = of_type(type, result.offsets.back());
    return result;
  }

  std::string comment() {
    constexpr const char* texts[] = {"",
                                     " c",
                                     "c ",
                                     "#c",
                                     "x y z",
                                     "x y z f0",
                                     "vtk",
                                     ".PCD v0.7",
                                     "a\tb",
                                     "\t",
                                     "a\x01"
                                     "b",
                                     "\r",
                                     "a\nb",
                                     "//",
                                     "1 2 3"};
    return texts[below(std::size(texts))];
  }

  void add_colors(PointCloud& cloud) {
    const std::size_t type = std::vector<std::size_t>{1, 3, 8}[below(3)];
    for (const char* name : {"red", "green", "blue", "alpha"}) {
      if (std::string(name) == "alpha" && below(2) == 0) continue;
      cloud.attributes.push_back({name, of_type(type, cloud.size()), {}});
    }
  }

  void add_faces(PointCloud& cloud) {
    std::vector<std::int32_t> corners;
    std::vector<std::size_t> offsets{0};
    // Every point is a corner, so that STL has them all.
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        corners.push_back(static_cast<std::int32_t>((i + k) % cloud.size()));
      }
      offsets.push_back(corners.size());
    }
    const std::size_t faces = cloud.size();
    cloud.layout.elements = {
        {"face",
         faces,
         {{"vertex_indices", std::move(corners), std::move(offsets), ScalarType::UInt8}},
         false}};
  }

  std::mt19937 random_;
};

}  // namespace deburr
