// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "deburr/error.hpp"
#include "support/cloud_files.hpp"
#include "support/las_files.hpp"
#include "support/same_cloud.hpp"

// Every format to every other one and back: what is not named in a warning is there.

namespace deburr {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A mesh whose values every format holds exactly: multiples of powers of two.
PointCloud small_mesh() {
  PointCloud cloud;
  for (int i = 0; i < 8; ++i) {
    cloud.points.push_back({0.25 * i, 0.5 * (i % 3), 500000 + 0.125 * (i * i % 5)});
  }
  const auto bytes = [](int factor) {
    std::vector<std::uint8_t> values;
    for (int i = 0; i < 8; ++i) values.push_back(static_cast<std::uint8_t>(factor * i));
    return values;
  };
  const auto numbers = [](double factor) {
    std::vector<double> values;
    for (int i = 0; i < 8; ++i) values.push_back(1e5 + factor * i / 3);
    return values;
  };
  cloud.attributes = {{"red", bytes(30), {}},
                      {"green", bytes(36), {}},
                      {"blue", bytes(1), {}},
                      {"gps_time", numbers(1e-7), {}},
                      {"intensity", std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5, 65535, 7}, {}},
                      {"quality", numbers(0.5), {}}};
  cloud.normals.assign(8, {0, 0.6, 0.8});
  cloud.layout.comments = {"made by hand"};
  cloud.layout.elements = {
      {"face",
       6,
       {{"vertex_indices",
         std::vector<std::int32_t>{0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 5, 4, 5, 6, 5, 6, 7},
         {0, 3, 6, 9, 12, 15, 18},
         ScalarType::UInt8}},
       false}};
  return cloud;
}

double as_double(const Attribute& attribute, std::size_t i) {
  return std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if constexpr (std::is_same_v<T, std::string>) {
          return std::nan("");
        } else {
          return static_cast<double>(values[i]);
        }
      },
      attribute.values);
}

/// What of a cloud is there: names of its fields, and of the rest.
std::set<std::string> parts_of(const PointCloud& cloud) {
  std::set<std::string> parts;
  for (const Attribute& a : cloud.attributes) parts.insert(a.name);
  if (!cloud.normals.empty()) parts.insert("normals");
  if (!cloud.layout.comments.empty()) parts.insert("comments");
  for (const Element& e : cloud.layout.elements) parts.insert(e.name);
  return parts;
}

/// The words by which a warning names a part.
bool is_named(const std::vector<std::string>& warnings, const std::string& part) {
  return std::ranges::any_of(
      warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

class Convert : public testing::TestWithParam<std::string> {};

TEST_P(Convert, KeepsWhatTheFormatHoldsAndNamesTheRest) {
  const TempDir dir;
  const PointCloud mesh = small_mesh();
  const std::string first = "a." + GetParam();
  const std::vector<std::string> warnings = write_cloud(dir / first, mesh);
  const PointCloud once = read_cloud(dir / first);
  ASSERT_EQ(once.size(), mesh.size());
  for (const std::string& part : parts_of(mesh)) {
    const bool is_there = parts_of(once).contains(part);
    EXPECT_NE(is_there, is_named(warnings, part)) << part;
  }
  for (const std::string& name : format_names()) {
    SCOPED_TRACE(GetParam() + " to " + name);
    const bool no_faces = once.layout.elements.empty();
    if (name == "stl" && no_faces) {
      EXPECT_THROW((void)write_cloud(dir / ("b." + name), once), DataError);
      continue;
    }
    const std::vector<std::string> more = write_cloud(dir / ("b." + name), once);
    const PointCloud twice = read_cloud(dir / ("b." + name));
    ASSERT_EQ(twice.size(), mesh.size());
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      ASSERT_LT(norm(twice.points[i] - mesh.points[i]), 1e-8) << i;
    }
    for (const std::string& part : parts_of(once)) {
      EXPECT_TRUE(parts_of(twice).contains(part) || is_named(more, part)) << part;
    }
    for (const Attribute& before : once.attributes) {
      const Attribute* const after = find_attribute(twice, before.name);
      if (after == nullptr) continue;
      for (std::size_t i = 0; i < mesh.size(); ++i) {
        ASSERT_EQ(as_double(*after, i), as_double(before, i)) << before.name;
      }
    }
    if (!twice.normals.empty() && !once.normals.empty()) {
      EXPECT_TRUE(same_values(twice.normals, once.normals));
    }
    for (const Element& before : once.layout.elements) {
      for (const Element& after : twice.layout.elements) {
        EXPECT_TRUE(after.name != before.name || after.size == before.size);
      }
    }
  }
}

TEST_P(Convert, WritesItsOwnFilesBackByteByByte) {
  const TempDir dir;
  const std::string name = "a." + GetParam();
  (void)write_cloud(dir / name, small_mesh());
  const std::string file = get(dir / name);
  std::vector<std::string> warnings;
  EXPECT_EQ(written_as(dir, read_cloud(dir / name), name, &warnings), file);
  EXPECT_TRUE(warnings.empty()) << warnings[0];
}

TEST_P(Convert, WritesNoPointsSoThatTheyCanBeRead) {
  const TempDir dir;
  PointCloud empty;
  empty.layout.elements = {
      {"face",
       0,
       {{"vertex_indices", std::vector<std::int32_t>{}, {0}, ScalarType::UInt8}},
       false}};
  (void)write_cloud(dir / ("a." + GetParam()), empty);
  EXPECT_EQ(read_cloud(dir / ("a." + GetParam())).size(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Formats, Convert, testing::ValuesIn(format_names()),
                         [](const auto& instance) { return instance.param; });

TEST(ConvertLas, NamesItsRecords) {
  const TempDir dir;
  const PointCloud cloud = parsed(las_file({}));
  for (const std::string name : {"a.ply", "a.pcd", "a.csv", "a.obj", "a.off"}) {
    EXPECT_THAT(write_cloud(dir / name, cloud),
                Contains(HasSubstr("LAS header, LAS record LASF_Projection 34735")))
        << name;
  }
}

TEST(ReadMesh, TakesFacesFromEveryFormatThatHasThem) {
  const TempDir dir;
  for (const std::string name : {"a.ply", "a.stl", "a.obj", "a.off"}) {
    (void)write_cloud(dir / name, small_mesh());
    EXPECT_EQ(read_mesh(dir / name).triangles.size(), 6U) << name;
  }
}

TEST(Formats, AreFoundByContentThenByExtension) {
  const TempDir dir;
  for (const std::string& name : format_names()) {
    (void)write_cloud(dir / ("a." + name), small_mesh());
    std::filesystem::rename(dir / ("a." + name), dir / "b.ply");
    const Encoding found = read_cloud(dir / "b.ply").layout.encoding;
    EXPECT_EQ(found, parsed(get(dir / "b.ply"), name).layout.encoding) << name;
  }
  EXPECT_THROW((void)parsed("1 2 3\n", "docx"), std::invalid_argument);
  EXPECT_THROW((void)parsed("1 2 3\n", "las"), IoError);
  EXPECT_THROW((void)write_cloud(dir / "a.ply", {}, {}, "docx"), std::invalid_argument);
  (void)write_cloud(dir / "a.dat", small_mesh(), {}, "las");
  EXPECT_EQ(read_cloud(dir / "a.dat").layout.encoding, Encoding::Las);
}

}  // namespace
}  // namespace deburr
