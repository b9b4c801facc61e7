// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

#include "io/bytes.hpp"
#include "io/faces.hpp"
#include "io/stl.hpp"
#include "io/text_row.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< faces between two looks at the cancel callback
constexpr std::size_t stl_head = 84;
constexpr std::size_t stl_face = 50;

struct VertexHash {
  std::size_t operator()(const std::array<std::uint64_t, 3>& bits) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t b : bits) {
      hash = (hash ^ b) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// Gathers triangles; corners at the same place are one point.
class StlMesh {
 public:
  void add_corner(const Vec3& p) {
    // -0 is 0, and a NaN is itself.
    const std::array<std::uint64_t, 3> key{std::bit_cast<std::uint64_t>(p.x + 0.0),
                                           std::bit_cast<std::uint64_t>(p.y + 0.0),
                                           std::bit_cast<std::uint64_t>(p.z + 0.0)};
    const auto [place, is_new] =
        index_.try_emplace(key, static_cast<std::int32_t>(cloud.points.size()));
    if (is_new) cloud.points.push_back(p);
    corners_.push_back(place->second);
  }
  void add_normal(const Vec3& n) {
    nx_.push_back(n.x);
    ny_.push_back(n.y);
    nz_.push_back(n.z);
  }
  [[nodiscard]] std::size_t corner_count() const { return corners_.size(); }
  [[nodiscard]] std::size_t face_count() const { return corners_.size() / 3; }

  PointCloud finish(ScalarType type, std::vector<Attribute> more) {
    std::vector<std::size_t> offsets(face_count() + 1);
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = 3 * i;
    Element faces = make_faces(std::move(corners_), std::move(offsets));
    add_normals(faces, "nx", std::move(nx_), type);
    add_normals(faces, "ny", std::move(ny_), type);
    add_normals(faces, "nz", std::move(nz_), type);
    for (Attribute& a : more) faces.attributes.push_back(std::move(a));
    for (const char* name : {"x", "y", "z"}) cloud.layout.fields.push_back({name, type});
    cloud.layout.elements.push_back(std::move(faces));
    return std::move(cloud);
  }

  PointCloud cloud;

 private:
  static void add_normals(Element& faces, const char* name, std::vector<double> values,
                          ScalarType type) {
    if (type == ScalarType::Float64) {
      faces.attributes.push_back({name, std::move(values), {}});
    } else {
      faces.attributes.push_back({name, std::vector<float>(values.begin(), values.end()), {}});
    }
  }

  std::unordered_map<std::array<std::uint64_t, 3>, std::int32_t, VertexHash> index_;
  std::vector<std::int32_t> corners_;
  std::vector<double> nx_;
  std::vector<double> ny_;
  std::vector<double> nz_;
};

PointCloud read_binary(const Source& source) {
  const std::string_view data = source.data;
  const auto fail_at_end = [&](const std::string& what) {
    source.fail(fmt::format("byte {}: the file ends in {}", data.size(), what));
  };
  if (data.size() < stl_head) fail_at_end("the header");
  const std::size_t count = load_little<std::uint32_t>(data, stl_head - 4);
  const std::size_t held = (data.size() - stl_head) / stl_face;
  if (count > held) fail_at_end(fmt::format("face {} of {}", held + 1, count));
  StlMesh mesh;
  std::vector<std::uint16_t> words;
  for (std::size_t face = 0; face < count; ++face) {
    if (face % block == 0) source.check_cancelled();
    std::size_t at = stl_head + face * stl_face;
    const auto take = [&] {
      const Vec3 v{load_little<float>(data, at), load_little<float>(data, at + 4),
                   load_little<float>(data, at + 8)};
      at += 12;
      return v;
    };
    mesh.add_normal(take());
    for (int corner = 0; corner < 3; ++corner) mesh.add_corner(take());
    words.push_back(load_little<std::uint16_t>(data, at));
  }
  std::vector<Attribute> more;
  if (std::ranges::any_of(words, [](std::uint16_t w) { return w != 0; })) {
    more.push_back({"attribute", std::move(words), {}});
  }
  PointCloud cloud = mesh.finish(ScalarType::Float32, std::move(more));
  const std::string_view head = data.substr(0, stl_head - 4);
  if (head.find_first_not_of('\0') != std::string_view::npos) {
    cloud.layout.blocks.push_back({"STL header", std::string(head)});
  }
  cloud.layout.encoding = Encoding::StlBinary;
  return cloud;
}

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return result;
}

class StlTextReader {
 public:
  explicit StlTextReader(const Source& source) : source_(source), lines_(source.data) {}

  PointCloud read() {
    while (lines_.next_full()) {
      if (lines_.number() % block == 0) source_.check_cancelled();
      TextRow row(source_, lines_);
      read_line(row);
    }
    if (in_facet_ || !ended_) {
      source_.fail(fmt::format("line {}: the file ends before endsolid", lines_.number()));
    }
    std::vector<Attribute> more;
    if (names_.size() > 1) more.push_back({"solid", std::move(solids_), {}});
    PointCloud cloud = mesh_.finish(ScalarType::Float64, std::move(more));
    std::string names;
    for (const std::string& name : names_) names += name + '\n';
    if (names.size() > 1) cloud.layout.blocks.push_back({"STL names", names});
    cloud.layout.encoding = Encoding::StlAscii;
    return cloud;
  }

 private:
  void read_line(TextRow& row) {
    const std::string word = lower(row.word());
    if (word == "solid") {
      const std::string_view line = lines_.line();
      if (line.find('\0') != std::string_view::npos) row.fail("a zero byte in a text");
      names_.emplace_back(trim(line.substr(std::min<std::size_t>(5, line.size()))));
      ended_ = false;
    } else if (word == "facet") {
      if (in_facet_ || names_.empty()) row.fail("a facet inside of a facet, or outside of a solid");
      in_facet_ = true;
      (void)row.word();  // normal
      mesh_.add_normal(take(row));
      solids_.push_back(static_cast<std::uint32_t>(names_.size() - 1));
      first_corner_ = mesh_.corner_count();
    } else if (word == "vertex") {
      if (!in_facet_) row.fail("a vertex outside of a facet");
      mesh_.add_corner(take(row));
    } else if (word == "endfacet") {
      if (!in_facet_ || mesh_.corner_count() != first_corner_ + 3) {
        row.fail("a facet with another number of vertices than 3");
      }
      in_facet_ = false;
    } else if (word == "endsolid") {
      ended_ = true;
    } else if (word != "outer" && word != "endloop") {
      row.fail(fmt::format("unknown keyword '{}'", word.substr(0, 40)));
    }
  }

  static Vec3 take(TextRow& row) {
    const auto x = row.take<double>("x");
    const auto y = row.take<double>("y");
    return {x, y, row.take<double>("z")};
  }

  const Source& source_;
  Lines lines_;
  StlMesh mesh_;
  std::vector<std::string> names_;
  std::vector<std::uint32_t> solids_;
  std::size_t first_corner_ = 0;
  bool in_facet_ = false;
  bool ended_ = false;
};

bool has_binary_size(std::string_view data) {
  return data.size() >= stl_head &&
         data.size() ==
             stl_head + std::size_t{load_little<std::uint32_t>(data, stl_head - 4)} * stl_face;
}

/// Some binary files begin with "solid" as well, but no text has a zero byte.
bool begins_as_text(std::string_view data) {
  const std::string head = lower(data.substr(0, 256));
  return trim(head).starts_with("solid") && head.find('\0') == std::string::npos;
}

}  // namespace

Match match_stl(std::string_view data) {
  if (begins_as_text(data)) {
    const std::string head = lower(data.substr(0, 4096));
    const bool has_more =
        head.find("facet") != std::string::npos || head.find("endsolid") != std::string::npos;
    return has_more ? Match::Sure : Match::Possible;
  }
  // A text of just this size is no binary file: its bytes 81 to 84 would announce 2^29 faces.
  return has_binary_size(data) ? Match::Sure : Match::Possible;
}

PointCloud read_stl(const Source& source) {
  return begins_as_text(source.data) ? StlTextReader(source).read() : read_binary(source);
}

}  // namespace deburr
