// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "deburr/error.hpp"
#include "io/bytes.hpp"
#include "io/faces.hpp"
#include "io/fields.hpp"
#include "io/losses.hpp"
#include "io/numbers.hpp"
#include "io/scalar_type.hpp"
#include "io/stl.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< faces that are written at once

Vec3 normal_of(const std::array<Vec3, 3>& corners) {
  const Vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = norm(n);
  return length > 0 && std::isfinite(length) ? (1 / length) * n : Vec3{};
}

class StlWriter {
 public:
  explicit StlWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    is_text_ = cloud_.layout.encoding == Encoding::StlAscii;
    find_faces_and_more();
    for (const Attribute& a : cloud_.attributes) losses_.add(a);
    if (!cloud_.normals.empty()) {
      losses_.add("STL cannot hold normals of points, which were left out");
    }
    losses_.add_foreign_blocks(cloud_.layout, "STL ");
    losses_.add_comments(cloud_.layout);
    if (!is_text_) losses_.add_coarse_floats(cloud_.points);
    find_lonely_points();
  }

  std::vector<std::string> write() {
    if (is_text_) {
      write_text();
    } else {
      write_binary();
    }
    job_.flush(buffer_);
    return losses_.take();
  }

 private:
  void find_faces_and_more() {
    faces_ = valid_faces(cloud_.layout, cloud_.size());
    if (faces_.attribute == nullptr || (faces_.corners.empty() && cloud_.size() > 0)) {
      throw DataError("STL holds faces only, and there are none");
    }
    std::vector<const Attribute*> kept{faces_.attribute};
    for (const Element& element : cloud_.layout.elements) {
      if (element.name != "face") continue;
      const auto find = [&](std::string_view name) -> const Attribute* {
        const auto found = std::ranges::find(element.attributes, name, &Attribute::name);
        if (found == element.attributes.end() || found->is_list()) return nullptr;
        return &*found;
      };
      constexpr std::array names{"nx", "ny", "nz"};
      for (std::size_t k = 0; k < 3; ++k) {
        const Attribute* const a = find(names.at(k));
        const bool is_real =
            a != nullptr && !is_integer_type(a->type()) && a->type() != ScalarType::Text;
        normals_.at(k) = is_real ? a : nullptr;
        if (is_real) kept.push_back(a);
      }
      if (const Attribute* const a = find(is_text_ ? "solid" : "attribute")) {
        if (is_text_) solids_ = std::get_if<std::vector<std::uint32_t>>(&a->values);
        if (!is_text_) words_ = std::get_if<std::vector<std::uint16_t>>(&a->values);
        if (solids_ != nullptr || words_ != nullptr) kept.push_back(a);
      }
      break;
    }
    losses_.add_elements(cloud_.layout, kept);
    for (const HeaderBlock& b : cloud_.layout.blocks) {
      if (b.name == "STL header" && !is_text_) header_ = b.data;
      if (b.name == "STL names" && is_text_) names_ = b.data;
    }
  }

  void find_lonely_points() {
    std::vector<bool> used(cloud_.size());
    for (const std::uint32_t corner : faces_.corners) used[corner] = true;
    const auto lonely = std::ranges::count(used, false);
    if (lonely > 0) {
      losses_.add(fmt::format("STL holds points of faces only, {} others were left out", lonely));
    }
    std::size_t triangles = 0;
    bool has_others = false;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      const std::size_t corners = faces_[face].size();
      has_others = has_others || corners != 3;
      triangles += corners < 3 ? 0 : corners - 2;
    }
    if (has_others) losses_.add("STL holds triangles only, other faces were split or left out");
    if (triangles > std::numeric_limits<std::uint32_t>::max()) {
      throw DataError("STL cannot hold more than 2^32 triangles");
    }
    triangles_ = triangles;
  }

  /// Calls f(face, corners, normal) for all triangles.
  template <typename F>
  void for_each_triangle(const F& f) {
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (face % block == 0) job_.flush(buffer_);
      const std::span<const std::uint32_t> indices = faces_[face];
      for (std::size_t k = 2; k < indices.size(); ++k) {
        const std::array<Vec3, 3> corners{place(indices[0]), place(indices[k - 1]),
                                          place(indices[k])};
        f(face, corners, normal(face, corners));
      }
    }
  }

  /// A point as it is written, so that the normal is that of the face that will be read.
  [[nodiscard]] Vec3 place(std::uint32_t i) const {
    const Vec3& p = cloud_.points[i];
    if (is_text_) return p;
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }

  /// The normal of the input stays, to the last bit, where it still is one; zero stands for none.
  [[nodiscard]] Vec3 normal(std::size_t face, const std::array<Vec3, 3>& corners) const {
    const Vec3 now = normal_of(corners);
    if (std::ranges::count(normals_, nullptr) > 0) return now;
    const auto value = [&](std::size_t k) {
      const auto* const doubles = std::get_if<std::vector<double>>(&normals_.at(k)->values);
      return doubles != nullptr
                 ? (*doubles)[face]
                 : double{std::get<std::vector<float>>(normals_.at(k)->values)[face]};
    };
    const Vec3 before{value(0), value(1), value(2)};
    constexpr double same = 1e-5;
    return before == Vec3{} || norm(before - now) < same ? before : now;
  }

  void write_binary() {
    buffer_ = padded(header_, 80);
    append_little(buffer_, static_cast<std::uint32_t>(triangles_));
    for_each_triangle([&](std::size_t face, const std::array<Vec3, 3>& corners, const Vec3& n) {
      for (const Vec3& v : {n, corners[0], corners[1], corners[2]}) {
        for (const double Vec3::*axis : axes) append_little(buffer_, static_cast<float>(v.*axis));
      }
      append_little(buffer_, words_ != nullptr ? (*words_)[face] : std::uint16_t{0});
    });
  }

  /// The name of a solid, with a blank in front if there is one.
  [[nodiscard]] std::string name_of(std::size_t solid) const {
    std::string_view rest = names_;
    for (; solid > 0; --solid) rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
    const std::string_view name = rest.substr(0, rest.find('\n'));
    return name.empty() ? "" : fmt::format(" {}", name);
  }

  void write_text() {
    std::size_t solid = 0;
    const auto count =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::ranges::count(names_, '\n')));
    buffer_ = fmt::format("solid{}\n", name_of(0));
    for_each_triangle([&](std::size_t face, const std::array<Vec3, 3>& corners, const Vec3& n) {
      // Solids stand in the order of their faces.
      const std::size_t wanted = solids_ != nullptr ? (*solids_)[face] : 0;
      while (solid < wanted && solid + 1 < count) end_solid(solid);
      buffer_ += "facet normal";
      append(n);
      buffer_ += "outer loop\n";
      for (const Vec3& corner : corners) {
        buffer_ += "vertex";
        append(corner);
      }
      buffer_ += "endloop\nendfacet\n";
    });
    while (solid + 1 < count) end_solid(solid);
    buffer_ += fmt::format("endsolid{}\n", name_of(solid));
  }

  void end_solid(std::size_t& solid) {
    buffer_ += fmt::format("endsolid{}\n", name_of(solid));
    ++solid;
    buffer_ += fmt::format("solid{}\n", name_of(solid));
  }

  void append(const Vec3& v) {
    for (const double Vec3::*axis : axes) append_number(buffer_ += ' ', v.*axis);
    buffer_ += '\n';
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  bool is_text_ = false;
  Faces faces_;
  std::array<const Attribute*, 3> normals_{};
  const std::vector<std::uint16_t>* words_ = nullptr;
  const std::vector<std::uint32_t>* solids_ = nullptr;
  std::string header_;
  std::string names_;
  std::size_t triangles_ = 0;
  Losses losses_{"STL"};
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_stl(const WriteJob& job) { return StlWriter(job).write(); }

}  // namespace deburr
