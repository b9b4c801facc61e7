// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "io/lzf.hpp"
#include "support/broken_files.hpp"
#include "support/cloud_files.hpp"
#include "support/ply_files.hpp"
#include "support/same_cloud.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr Encoding pcd_encodings[] = {Encoding::PcdAscii, Encoding::PcdBinary,
                                      Encoding::PcdCompressed};

std::string pcd_head(const std::string& fields, const std::string& sizes, const std::string& types,
                     const std::string& points, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " +
         sizes + "\nTYPE " + types + "\nWIDTH " + points + "\nHEIGHT 1\nPOINTS " + points +
         "\nDATA " + data + "\n";
}

/// Eight points with what PCD can hold.
PointCloud full_pcd(Encoding encoding) {
  PointCloud cloud = full_cloud(Encoding::None);
  cloud.layout = {};
  cloud.layout.encoding = encoding;
  cloud.layout.comments = {"by hand", ""};
  std::erase_if(cloud.attributes, [](const Attribute& a) { return a.is_list(); });
  cloud.attributes.push_back({"i64", extremes<std::int64_t>(), {}});
  cloud.attributes.push_back({"u64", extremes<std::uint64_t>(), {}});
  std::vector<float> histogram;
  std::vector<std::size_t> offsets;
  for (std::size_t i = 0; i <= 8; ++i) offsets.push_back(3 * i);
  for (int i = 0; i < 24; ++i) histogram.push_back(0.1F * static_cast<float>(i));
  cloud.attributes.push_back({"histogram", histogram, offsets, ScalarType::UInt8});
  cloud.layout.fields = {{"y", ScalarType::Float64}};
  for (const Attribute& a : cloud.attributes) cloud.layout.fields.push_back({a.name, a.type()});
  for (const char* name : {"z", "x", "normal_x", "normal_y", "normal_z"}) {
    cloud.layout.fields.push_back({name, ScalarType::Float64});
  }
  cloud.layout.blocks = {{"PCD viewpoint", "1 2 3 0.5 0.5 0.5 0.5"}, {"PCD rows", "2"}};
  return cloud;
}

TEST(Pcd, KeepsEverythingInEveryEncoding) {
  const TempDir dir;
  for (const Encoding encoding : pcd_encodings) {
    SCOPED_TRACE(static_cast<int>(encoding));
    const PointCloud cloud = full_pcd(encoding);
    EXPECT_THAT(write_cloud(dir / "a.pcd", cloud), IsEmpty());
    const PointCloud again = read_cloud(dir / "a.pcd");
    expect_same(again, cloud);
    ASSERT_EQ(again.layout.blocks.size(), 2U);
    EXPECT_EQ(again.layout.blocks[0].data, "1 2 3 0.5 0.5 0.5 0.5");
    (void)write_cloud(dir / "b.pcd", again);
    EXPECT_EQ(get(dir / "a.pcd"), get(dir / "b.pcd"));
  }
}

TEST(Pcd, WritesTheseBytes) {
  const TempDir dir;
  using namespace std::string_literals;
  PointCloud cloud = parsed(pcd_head("x y z i", "4 4 4 2", "F F F U", "1", "binary") +
                            "\0\0\x80\x3f\0\0\0\x40\0\0\0\xc0\x02\x01"s);
  EXPECT_THAT(cloud.points, ElementsAre(Vec3{1, 2, -2}));
  EXPECT_THAT(values_of<std::uint16_t>(cloud, "i"), ElementsAre(258));
  EXPECT_EQ(written_as(dir, cloud, "a.pcd"),
            "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z i\n"
            "SIZE 4 4 4 2\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\n"
            "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA binary\n"
            "\0\0\x80\x3f\0\0\0\x40\0\0\0\xc0\x02\x01"s);
  cloud.layout.encoding = Encoding::PcdAscii;
  EXPECT_THAT(written_as(dir, cloud, "a.pcd"), testing::EndsWith("DATA ascii\n1 2 -2 258\n"));
}

TEST(Pcd, UnpacksColoursAndPacksThemAgain) {
  const TempDir dir;
  for (const std::string type : {"F", "U", "I"}) {
    PointCloud cloud = parsed(pcd_head("x y z rgb", "4 4 4 4", "F F F " + type, "1", "binary") +
                              std::string(12, '\0') + std::string("\x03\x02\x01\0", 4));
    EXPECT_THAT(field_names(cloud), ElementsAre("x", "y", "z", "red", "green", "blue"));
    EXPECT_THAT(values_of<std::uint8_t>(cloud, "red"), ElementsAre(1));
    EXPECT_THAT(values_of<std::uint8_t>(cloud, "green"), ElementsAre(2));
    EXPECT_THAT(values_of<std::uint8_t>(cloud, "blue"), ElementsAre(3));
    EXPECT_THAT(written_as(dir, cloud, "a.pcd"),
                testing::EndsWith(std::string("\x03\x02\x01\0", 4)));
    EXPECT_THAT(get(dir / "a.pcd"), HasSubstr("FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\n"));
    EXPECT_THAT(field_names(parsed(written_as(dir, cloud, "a.ply"))),
                ElementsAre("x", "y", "z", "red", "green", "blue"));
  }
  const PointCloud text =
      parsed(pcd_head("x y z rgb", "4 4 4 4", "F F F F", "1", "ascii") + "1 2 3 2.3418052e-38\n");
  EXPECT_THAT(values_of<std::uint8_t>(text, "red"), ElementsAre(255));
  const PointCloud alpha =
      parsed(pcd_head("x y z rgba", "4 4 4 4", "F F F U", "1", "ascii") + "1 2 3 4278190081\n");
  EXPECT_THAT(values_of<std::uint8_t>(alpha, "alpha"), ElementsAre(255));
  EXPECT_THAT(written_as(dir, alpha, "a.pcd"), testing::EndsWith("1 2 3 4278190081\n"));
}

// Also a list has a name that no colour may take.
TEST(Pcd, LeavesPackedColoursAloneWhereTheirNamesAreTaken) {
  const TempDir dir;
  const std::string file =
      "# .PCD\nFIELDS x y z rgb blue\nSIZE 4 4 4 4 1\nTYPE F F F U U\nCOUNT 1 1 1 1 2\nWIDTH 1\n"
      "HEIGHT 1\nDATA ascii\n1 2 3 66051 4 5\n";
  const PointCloud cloud = parsed(file);
  EXPECT_THAT(field_names(cloud), ElementsAre("x", "y", "z", "rgb", "blue"));
  EXPECT_THAT(values_of<std::uint32_t>(cloud, "rgb"), ElementsAre(66051));
  expect_same(parsed(written_as(dir, cloud, "a.pcd")), cloud);
}

PointCloud colored(Values red, Values green, Values blue) {
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}};
  cloud.attributes = {
      {"red", std::move(red), {}}, {"green", std::move(green), {}}, {"blue", std::move(blue), {}}};
  return cloud;
}

TEST(Pcd, PacksColoursOf16BitsBesideTheirFields) {
  const TempDir dir;
  using Words = std::vector<std::uint16_t>;
  // 128 and 129 are on the two sides of half a step of 257.
  const PointCloud cloud = colored(Words{65535, 128}, Words{257, 129}, Words{0, 65407});
  std::vector<std::string> warnings;
  const std::string file = written_as(dir, cloud, "a.pcd", &warnings);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_THAT(file, HasSubstr("FIELDS x y z rgb red green blue\n"));
  const PointCloud again = parsed(file);
  expect_same(again.attributes, cloud.attributes);
  EXPECT_EQ(written_as(dir, again, "b.pcd"), file);
  // What other programs see.
  std::string other = file;
  other.replace(other.find(" red green blue"), 15, " r__ g____ b___");
  const PointCloud seen = parsed(other);
  EXPECT_THAT(values_of<std::uint8_t>(seen, "red"), ElementsAre(255, 0));
  EXPECT_THAT(values_of<std::uint8_t>(seen, "green"), ElementsAre(1, 1));
  EXPECT_THAT(values_of<std::uint8_t>(seen, "blue"), ElementsAre(0, 255));
  // Changed by another program, they say something else.
  PointCloud changed = again;
  changed.layout.blocks.clear();
  changed.attributes.insert(changed.attributes.begin(),
                            {"rgb", std::vector<std::uint32_t>{1, 2}, {}});
  changed.layout.fields.insert(changed.layout.fields.begin() + 3, {"rgb", ScalarType::UInt32});
  expect_same(parsed(written_as(dir, changed, "c.pcd")).attributes, changed.attributes);
}

TEST(Pcd, PacksSmallIntegersOfAnyType) {
  const TempDir dir;
  const PointCloud cloud =
      colored(std::vector<std::int64_t>{0, 255}, std::vector<std::uint16_t>{7, 8},
              std::vector<std::int8_t>{1, 2});
  const PointCloud again = parsed(written_as(dir, cloud, "a.pcd"));
  EXPECT_THAT(values_of<std::uint8_t>(again, "red"), ElementsAre(0, 255));
  EXPECT_THAT(values_of<std::uint8_t>(again, "green"), ElementsAre(7, 8));
  // What is no colour stays as it is.
  for (const std::int64_t other : {-1, 65536}) {
    const PointCloud no_colors =
        colored(std::vector<std::int64_t>{0, other}, std::vector<std::uint16_t>{7, 8},
                std::vector<std::int8_t>{1, 2});
    expect_same(parsed(written_as(dir, no_colors, "a.pcd")).attributes, no_colors.attributes);
  }
}

TEST(Pcd, ReadsOldAndSparseHeaders) {
  EXPECT_EQ(parsed("VERSION .5\r\nCOLUMNS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\nPOINTS 1\r\n"
                   "DATA ascii\r\n1 2 3\r\n")
                .points,
            (std::vector<Vec3>{{1, 2, 3}}));
  // Padding is no field.
  const PointCloud cloud = parsed(
      "# .PCD\n# note\nFIELDS x _ y _ z\nSIZE 4 1 4 1 4\nTYPE F U F U F\nCOUNT 1 2 1 1 1\nWIDTH 1\n"
      "HEIGHT 1\nDATA ascii\n1 0 0 2 0 3\n");
  EXPECT_THAT(cloud.points, ElementsAre(Vec3{1, 2, 3}));
  EXPECT_THAT(cloud.attributes, IsEmpty());
  EXPECT_THAT(cloud.layout.comments, ElementsAre("note"));
}

TEST(Pcd, LosesItsRowsWithTheFirstPointThatGoes) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points.resize(6);
  cloud.layout.encoding = Encoding::PcdBinary;
  cloud.layout.blocks = {{"PCD rows", "2"}};
  EXPECT_THAT(written_as(dir, cloud, "a.pcd"), HasSubstr("WIDTH 3\nHEIGHT 2\n"));
  cloud.points.resize(5);
  EXPECT_THAT(written_as(dir, cloud, "a.pcd"), HasSubstr("WIDTH 5\nHEIGHT 1\n"));
}

TEST(Pcd, WritesFloatsAsFloatsAndSaysIfTheyAreCoarse) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{500000.1, 1, 1}, {500001.3, 2, 2}};
  EXPECT_THAT(write_cloud(dir / "a.pcd", cloud), IsEmpty());
  EXPECT_EQ(read_cloud(dir / "a.pcd").points, cloud.points);
  EXPECT_THAT(doubts_about(read_cloud(dir / "a.pcd")), IsEmpty());
  for (const char* name : {"x", "y", "z"}) {
    cloud.layout.fields.push_back({name, ScalarType::Float32});
  }
  EXPECT_THAT(write_cloud(dir / "a.pcd", cloud), ElementsAre(HasSubstr("0.031 apart")));
  EXPECT_THAT(doubts_about(read_cloud(dir / "a.pcd")), ElementsAre(HasSubstr("0.031 apart")));
  EXPECT_EQ(read_cloud(dir / "a.pcd").points[0].x, 500000.09375);
  cloud.points = {{0.1, 1, 1}, {2, 2, 2}};
  EXPECT_THAT(write_cloud(dir / "a.pcd", cloud), IsEmpty());
}

TEST(Pcd, NamesWhatIsWrong) {
  const auto head = [](const std::string& points, const std::string& data) {
    return pcd_head("x y z", "4 4 4", "F F F", points, data);
  };
  EXPECT_EQ(error_of(head("1", "ascii") + "1 2 3\n"), "");
  EXPECT_THAT(error_of(head("2", "ascii") + "1 2 3\n"), HasSubstr("the file ends in point 2 of 2"));
  EXPECT_EQ(error_of(head("1", "ascii") + "1 2,5 3\n"),
            "line 10: decimal commas are not read; write numbers with a point, e.g. 1.5");
  EXPECT_EQ(error_of(head("1", "ascii") + "1 2 3 4\n"),
            "line 10: unexpected '4' behind the last field");
  EXPECT_EQ(error_of(head("1", "ascii") + "1 2 \n   "), "line 10: the line ends before z");
  EXPECT_THAT(error_of(head("1", "fast")), StartsWith("line 9: unknown DATA 'fast'"));
  EXPECT_THAT(error_of(head("1099511627776", "binary") + "12345678"),
              HasSubstr("point 1 of 1099511627776"));
  EXPECT_THAT(error_of(head("18446744073709551615", "binary")), HasSubstr("line 9: "));
  EXPECT_THAT(error_of(head("-1", "binary")), HasSubstr("line 6: '-1' is no value for WIDTH"));
  EXPECT_THAT(error_of(pcd_head("x y z", "4 4", "F F F", "1", "ascii")), HasSubstr("2 of SIZE"));
  EXPECT_THAT(error_of(pcd_head("x y z", "4 4 3", "F F F", "1", "ascii")),
              HasSubstr("unknown TYPE F of SIZE 3"));
  EXPECT_THAT(error_of(pcd_head("x y w", "4 4 4", "F F F", "1", "ascii") + "1 2 3\n"),
              HasSubstr("the file has no field 'z'"));
  EXPECT_THAT(error_of(pcd_head("x y z z", "4 4 4 4", "F F F F", "1", "ascii") + "1 2 3 4\n"),
              HasSubstr("two fields have the name 'z'"));
  using namespace std::string_literals;
  EXPECT_THAT(error_of(head("1", "binary_compressed") + "\1\0\0\0\x0c\0\0\0\x40"s),
              HasSubstr("the compressed data are damaged"));
  EXPECT_THAT(error_of(head("1", "binary_compressed") + "\1\0\0\0\x0d\0\0\0\x40"s),
              HasSubstr("13 bytes are announced, 1 points have 12"));
}

/// What comes out, taken in pieces; nothing if the data are damaged or have another size.
std::optional<std::string> unpacked(std::string_view packed, std::size_t size) {
  LzfUnpacker unpacker(packed);
  std::string data(size, '\0');
  for (std::size_t at = 0; at < size;) {
    const std::size_t count = std::min<std::size_t>(size - at, 1 + at % 7000);
    if (!unpacker.read(data.data() + at, count)) return std::nullopt;
    at += count;
  }
  if (!unpacker.at_end()) return std::nullopt;
  return data;
}

std::string packed_from(const std::string& data, std::size_t pieces = 1) {
  std::string packed;
  for (std::size_t k = 0; k < pieces; ++k) {
    const std::size_t begin = data.size() * k / pieces;
    lzf_append(packed,
               std::string_view(data).substr(begin, data.size() * (k + 1) / pieces - begin));
  }
  return packed;
}

TEST(Lzf, UnpacksWhatItPacks) {
  std::mt19937 random(1);
  for (int run = 0; run < 300; ++run) {
    std::string data(random() % 3000, '\0');
    const unsigned variety = 1 + random() % 256;
    for (char& c : data) c = static_cast<char>(random() % variety);
    if (run % 3 == 0) data += data + data;
    const std::string packed = packed_from(data);
    EXPECT_LE(packed.size(), data.size() + data.size() / 32 + 1);
    EXPECT_EQ(unpacked(packed, data.size()), data);
    EXPECT_EQ(unpacked(packed, data.size() + 1), std::nullopt);
    EXPECT_TRUE(data.empty() || !unpacked(packed, data.size() - 1));
    EXPECT_EQ(unpacked(packed_from(data, 3), data.size()), data);
  }
  EXPECT_LT(packed_from(std::string(100000, 'a')).size(), 2000U);
  // Farther than the window of the unpacker, with copies of every distance.
  std::string large;
  for (int run = 0; large.size() < 400000; ++run) {
    const std::size_t length = 1 + random() % 300;
    const std::size_t back = 1 + random() % 9000;
    for (std::size_t k = 0; k < length; ++k) {
      const bool copied = run % 3 != 0 && back <= large.size();
      large += copied ? large[large.size() - back] : static_cast<char>(random());
    }
  }
  EXPECT_EQ(unpacked(packed_from(large), large.size()), large);
  EXPECT_LT(packed_from(large).size(), large.size() / 2);
  // All copies reach back as far as they can.
  std::string period(8192, '\0');
  for (char& c : period) c = static_cast<char>(random());
  std::string periods;
  for (int k = 0; k < 40; ++k) periods += period;
  EXPECT_EQ(unpacked(packed_from(periods), periods.size()), periods);
  EXPECT_LT(packed_from(periods).size(), periods.size() / 5);
  // A literal, then a copy that overlaps itself: from the description of the format.
  EXPECT_EQ(unpacked(std::string("\x00"
                                 "a"
                                 "\x80\x00",
                                 4),
                     7),
            "aaaaaaa");
  EXPECT_EQ(unpacked(std::string("\x00"
                                 "a"
                                 "\xe0\x01\x00",
                                 5),
                     11),
            "aaaaaaaaaaa");
}

}  // namespace
}  // namespace deburr
