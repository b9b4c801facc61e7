// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "deburr/vec3.hpp"

namespace deburr {

/// Scalar types that a field of a file can have.
enum class ScalarType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64,
  Text
};

/// The values of one attribute; the alternatives are in the order of ScalarType.
using Values =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>,
                 std::vector<double>, std::vector<std::string>>;

/// A named quantity with one value, or one list of values, per item.
struct Attribute {
  std::string name;
  Values values;
  /// For a list attribute: item i owns values [offsets[i], offsets[i+1]), items + 1 entries.
  /// Empty for one value per item.
  std::vector<std::size_t> offsets;
  /// For a list attribute: the type that its lengths have in the file.
  ScalarType length_type = ScalarType::UInt8;

  [[nodiscard]] ScalarType type() const { return static_cast<ScalarType>(values.index()); }
  [[nodiscard]] bool is_list() const { return !offsets.empty(); }
};

/// Name and type of one field, where it stands in a file.
struct Field {
  std::string name;
  ScalarType type = ScalarType::Float64;

  friend bool operator==(const Field&, const Field&) = default;
};

/// Anything in a file that is not about points, e.g. the faces of a mesh; kept and written back.
struct Element {
  std::string name;
  std::size_t size = 0;
  std::vector<Attribute> attributes;
  bool before_points = false;  ///< stands before the points in the file
};

/// How a file holds its data.
enum class Encoding : std::uint8_t {
  None,
  PlyAscii,
  PlyLittleEndian,
  PlyBigEndian,
  Text,
  PcdAscii,
  PcdBinary,
  PcdCompressed,
  Las,
  Obj,
  Off,
  StlAscii,
  StlBinary
};

/// Whether and how a text file names its columns.
enum class TextHeader : std::uint8_t {
  None,
  Plain,  ///< as a line of its own
  Marked  ///< behind a comment mark
};

/// The shape of a text file.
struct TextLayout {
  char separator = ' ';  ///< ',' ';' '\t' or ' '
  TextHeader header = TextHeader::None;
  std::string mark = "#";   ///< what a comment starts with
  bool count_line = false;  ///< the number of points stands in the first line
};

/// A part of a file that only its own format understands, e.g. a record of LAS; kept as it is.
struct HeaderBlock {
  std::string name;  ///< the format first: "LAS record LASF_Projection 34735"
  std::string data;
};

/// What a file says beyond its points, kept so that writing it back changes nothing else.
struct FileLayout {
  Encoding encoding = Encoding::None;  ///< None for a cloud that does not come from a file
  TextLayout text;                     ///< used where encoding is Text
  /// Of the points, in file order, coordinates among them. A list has the type of its values.
  std::vector<Field> fields;
  std::vector<std::string> comments;  ///< without their comment marks
  std::vector<std::string> obj_info;  ///< the comments that PLY marks so, which programs read
  std::vector<Element> elements;
  std::vector<HeaderBlock> blocks;
  /// Length by which coordinates have to be told apart, in their unit, where a format rounds them
  /// to a grid (LAS): the grid of the file is refined to it. 0 keeps the grid.
  double resolution = 0;
};

/// Points with whatever was measured at them. Order and attributes survive every operation.
struct PointCloud {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< empty, or one per point
  std::vector<Attribute> attributes;
  FileLayout layout;

  [[nodiscard]] std::size_t size() const { return points.size(); }
};

}  // namespace deburr
