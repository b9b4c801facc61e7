// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <clocale>
#include <random>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "support/broken_files.hpp"
#include "support/cloud_files.hpp"
#include "support/comma_locale.hpp"
#include "support/same_cloud.hpp"
#include "support/temp_dir.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

PointCloud read(const TempDir& dir, std::string_view data) {
  put(dir / "read", data);
  return read_cloud(dir / "read");
}

/// What is written of a cloud under a name.
std::string written(const TempDir& dir, const PointCloud& cloud, const std::string& name) {
  (void)write_cloud(dir / name, cloud);
  return get(dir / name);
}

std::vector<std::string> names(const PointCloud& cloud) {
  std::vector<std::string> result;
  result.reserve(cloud.layout.fields.size());
  for (const Field& field : cloud.layout.fields) result.push_back(field.name);
  return result;
}

template <typename T>
std::vector<T> values(const PointCloud& cloud, std::size_t k) {
  return std::get<std::vector<T>>(cloud.attributes.at(k).values);
}

TEST(Text, ReadsCommentsBehindAHeaderWithoutPoints) {
  const PointCloud cloud = parsed("x,y,z,a\n# c\n", "csv");
  EXPECT_EQ(cloud.size(), 0U);
  EXPECT_EQ(cloud.layout.fields.size(), 4U);
  EXPECT_EQ(cloud.layout.comments, std::vector<std::string>{"c"});
}

TEST(Text, TakesTheSimplestTypeForIntegers) {
  const auto type_of = [](const std::string& first, const std::string& second) {
    const PointCloud cloud = parsed("1 2 3 " + first + "\n4 5 6 " + second + "\n", "xyz");
    return cloud.attributes.at(0).type();
  };
  EXPECT_EQ(type_of("9223372036854775807", "-1"), ScalarType::Int64);
  EXPECT_EQ(type_of("9223372036854775808", "1"), ScalarType::UInt64);
  EXPECT_EQ(type_of("1", "9223372036854775808"), ScalarType::UInt64);
  EXPECT_EQ(type_of("9223372036854775808", "-1"), ScalarType::Text);
  EXPECT_EQ(type_of("-1", "9223372036854775808"), ScalarType::Text);
  EXPECT_EQ(type_of("18446744073709551616", "1"), ScalarType::Text);
  EXPECT_EQ(type_of("9223372036854775808", "1.5"), ScalarType::Float64);
  EXPECT_EQ(type_of("9223372036854775808", "a"), ScalarType::Text);
}

// Each of these is written back as it is, so its shape is understood and kept.
TEST(Text, WritesBackWhatItRead) {
  const TempDir dir;
  const std::string files[] = {"1 2 3\n4 5 6\n",
                               "1,2,3\n4,5,6\n",
                               "1;2;3;word\n4;5;6;two words\n",
                               "1\t2\t3\t7\n4\t5\t6\t8\n",
                               "x y z\n1 2 3\n",
                               "x,y,z,intensity\n1,2,3,0.5\n4,5,6,1.0\n",
                               "//X,Y,Z\n1.5,2.5,3.5\n",
                               "# x y z\n1 2 3\n",
                               "#a b c x y z\n1 2 3 4 5 6\n",
                               "# a comment\n#\n1 2 3 -5\n",
                               "#c\n# c\n#\tc\n#  c  \n// d\n  #e\n# \n1 2 3\n",
                               "1 2 3\n#vtk\n//x y z\n4 5 6\n",
                               "x,y,z,most\n1,2,3,18446744073709551615\n4,5,6,0\n",
                               "x,y,z,beyond\n1,2,3,18446744073709551616\n4,5,6,1\n",
                               "x,y,z,both\n1,2,3,9223372036854775808\n4,5,6,-1\n",
                               "// a comment\nz;x;y\n1;2;3\n",
                               "1 2 3 0 0 1\n4 5 6 0 0 0\n7 8 9 0.6 -0.8 0\n",
                               "x,y,z,name\n1,2,3,\"a, \"\"b\"\"\"\n4,5,6,\n",
                               "x,y,z,big\n1,2,3,9223372036854775807\n4,5,6,-9223372036854775808\n",
                               "x,y,z,bigger\n1,2,3,9223372036854775808\n4,5,6,1\n",
                               "x y z v\n1 nan -inf inf\n-nan 0.00001 500000.123456789 nan\n",
                               "1 2 3 car\n4 5 6 \"red car\"\n"};
  for (const std::string& file : files) {
    EXPECT_EQ(written(dir, read(dir, file), "a.txt"), file);
    const PointCloud cloud = read(dir, file);
    expect_same(read(dir, written(dir, cloud, "a.txt")), cloud);
  }
}

TEST(Text, ReadsCountLines) {
  const TempDir dir;
  const PointCloud cloud = read(dir, "2\n1 2 3 -10 255 0 0\n4 5 6 20 0 0 1\n");
  EXPECT_TRUE(cloud.layout.text.count_line);
  EXPECT_THAT(names(cloud), ElementsAre("x", "y", "z", "intensity", "red", "green", "blue"));
  EXPECT_THAT(names(read(dir, "1\n1 2 3 -10\n")), ElementsAre("x", "y", "z", "intensity"));
  EXPECT_EQ(written(dir, cloud, "a.pts"), "2\n1 2 3 -10 255 0 0\n4 5 6 20 0 0 1\n");
  EXPECT_EQ(written(dir, cloud, "a.xyz"), "1 2 3 -10 255 0 0\n4 5 6 20 0 0 1\n");
  EXPECT_EQ(read(dir, "2\n# c\nx y z\n1 2 3\n4 5 6\n").size(), 2U);
  EXPECT_EQ(read(dir, "0\n").size(), 0U);
  EXPECT_THAT(error_of("3\n1 2 3\n4 5 6\n"), HasSubstr("announces 3 points and has 2"));
}

TEST(Text, FindsColumnsByName) {
  const TempDir dir;
  for (const char* file :
       {"n,Z,Y,X\n9,3,2,1\n", "n;Height;northing;EASTING\n9;3;2;1\n", "n elevation y x\n9 3 2 1\n",
        "\"n\",\"z\",\"y\",\"x\"\r\n\"9\",\"3\",\"2\",\"1\"\r\n", "\xef\xbb\xbfn z y x\n9 3 2 1\n",
        "n,z,y,x\n9 3 2 1\n", "// n z y x\n9,3,2,1\n", "\n  n ,z, y , x\n\n 9 , 3,2,1 \n"}) {
    const PointCloud cloud = read(dir, file);
    EXPECT_THAT(cloud.points, ElementsAre(Vec3{1, 2, 3})) << file;
    EXPECT_THAT(values<std::int64_t>(cloud, 0), ElementsAre(9)) << file;
    EXPECT_EQ(cloud.attributes[0].name, "n") << file;
  }
  // x is a name for x before easting is.
  EXPECT_THAT(read(dir, "easting,x,y,z\n1,2,3,4\n").points, ElementsAre(Vec3{2, 3, 4}));
  for (const char* header :
       {"x y z nx ny nz", "x y z Normal_X Normal_Y Normal_Z", "x y z normalx normaly normalz"}) {
    EXPECT_THAT(read(dir, std::string(header) + "\n1 2 3 4 5 6\n").normals,
                ElementsAre(Vec3{4, 5, 6}));
  }
  EXPECT_THAT(read(dir, "x y z nx ny\n1 2 3 4 5\n").normals, IsEmpty());
}

TEST(Text, TakesAByteOrderMarkForNothing) {
  for (const std::string file :
       {"1 2 3\n4 5 6\n", "x,y,z\n1,2,3\n4,5,6\n", "# c\n1 2 3\n4 5 6\n", "2\n1 2 3\n4 5 6\n",
        "OFF\n2 0 0\n1 2 3\n4 5 6\n", "v 1 2 3\nv 4 5 6\n"}) {
    const PointCloud cloud = parse_cloud({"marked", "\xef\xbb\xbf" + file, {}});
    EXPECT_EQ(cloud.points, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}})) << file;
    EXPECT_EQ(cloud.layout.encoding, parse_cloud({"plain", file, {}}).layout.encoding) << file;
  }
  EXPECT_EQ(error_of("\xef\xbb\xbf"), "empty file");
  EXPECT_EQ(error_of("\xef\xbb\xbf\xfe\xff,x,y,z\n1,2,3,4\n"),
            "not a point cloud, but UTF-16 text");
}

TEST(Text, FindsTypesThatChangeOnTheWay) {
  const TempDir dir;
  const PointCloud cloud = read(dir,
                                "0 0 0 -0 1 99999999999999999999 5\n"
                                "0 0 0 2 2 1 6\n"
                                "# between\n"
                                "0 0 0 0.5 a 1.5 7\n");
  const auto& numbers = std::get<std::vector<double>>(cloud.attributes[0].values);
  EXPECT_THAT(numbers, ElementsAre(0, 2, 0.5));
  EXPECT_TRUE(std::signbit(numbers[0]));
  EXPECT_THAT(std::get<std::vector<std::string>>(cloud.attributes[1].values),
              ElementsAre("1", "2", "a"));
  EXPECT_THAT(std::get<std::vector<double>>(cloud.attributes[2].values), ElementsAre(1e20, 1, 1.5));
  EXPECT_THAT(std::get<std::vector<std::int64_t>>(cloud.attributes[3].values),
              ElementsAre(5, 6, 7));
  EXPECT_THAT(cloud.layout.comments, ElementsAre("between"));
}

TEST(Text, TellsNormalsFromOtherColumns) {
  const TempDir dir;
  EXPECT_THAT(read(dir, "1 2 3 0 0 0.9995\n4 5 6 0 0 0\n").normals,
              ElementsAre(Vec3{0, 0, 0.9995}, Vec3{}));
  EXPECT_THAT(read(dir, "1 2 3 0 0 0\n4 5 6 0 0 0\n").normals, IsEmpty());
  EXPECT_THAT(read(dir, "1 2 3 0 0 1\n4 5 6 0 0 0.99\n").normals, IsEmpty());
  EXPECT_THAT(read(dir, "1 2 3 0 0 1\n4 5 6 0 0 nan\n").normals, IsEmpty());
  EXPECT_THAT(read(dir, "1 2 3 0 0 1 5\n").normals, IsEmpty());
  const PointCloud colors = read(dir, "1 2 3 0 0 1\n4 5 6 255 0 0\n");
  EXPECT_THAT(names(colors), ElementsAre("x", "y", "z", "column_4", "column_5", "column_6"));
  EXPECT_THAT(values<std::int64_t>(colors, 0), ElementsAre(0, 255));
}

TEST(Text, FindsTheTypeOfEveryColumn) {
  const TempDir dir;
  const PointCloud cloud = read(dir,
                                "x,y,z,i,f,t,e,h\n"
                                "1,2,3,+7,1,a,1,9223372036854775808\n"
                                "1,2,3,-8,NaN,2,,1.5\n");
  EXPECT_THAT(values<std::int64_t>(cloud, 0), ElementsAre(7, -8));
  EXPECT_THAT(values<double>(cloud, 1), ElementsAre(1, testing::IsNan()));
  EXPECT_THAT(values<std::string>(cloud, 2), ElementsAre("a", "2"));
  EXPECT_THAT(values<std::string>(cloud, 3), ElementsAre("1", ""));
  EXPECT_THAT(values<double>(cloud, 4), ElementsAre(9223372036854775808.0, 1.5));
}

TEST(Text, NamesDecimalCommas) {
  for (const char* file : {"1,5 2,5 3,5\n", "1,5;2,5;3,5\n", "1,5, 2,5, 3,5\n", "1,5\t2\t3\n",
                           "x;y;z\n1,5;2,5;3,5\n", "x y z\n1,5 2,5 3,5\n", "1,5 2,5 3,5 4,5\n"}) {
    EXPECT_THAT(error_of(file), HasSubstr("decimal commas are not read")) << file;
    EXPECT_THAT(error_of(file), StartsWith("line ")) << file;
  }
  EXPECT_THAT(error_of("1 2 3\n4 5,5 6\n"), StartsWith("line 2: decimal commas"));
  EXPECT_THAT(error_of("1 2 3 4\n\n1 2 3 4,5\n"), StartsWith("line 3: decimal commas"));
}

TEST(Text, NamesTheLineOfABadRow) {
  EXPECT_EQ(error_of("1 2 3\n# c\n\n4 5\n"), "line 4: 2 columns, but 3 before");
  EXPECT_EQ(error_of("1,2,3\n4,,6\n"), "line 2: '' in column 'y' is not a number");
  EXPECT_EQ(error_of("1 2 3\n4 5 6x\n"), "line 2: '6x' in column 'z' is not a number");
  EXPECT_EQ(error_of("1 2 3\n4 5 \"6\n"), "line 2: a quote does not end");
  EXPECT_EQ(error_of("x y z w\n1 2 3\n"),
            "line 1: the header has 4 names, the first row 3 columns");
  EXPECT_EQ(error_of("x,y,z\n1\n"), "line 1: the header has 3 names, the first row 1 columns");
  EXPECT_EQ(error_of("x,y,z,a,a\n1,2,3,4,5\n"), "two columns have the name 'a'");
}

TEST(Text, NamesWhatIsNoCloud) {
  using namespace std::string_literals;
  const auto other = [](const std::string& name) { return "not a point cloud, but " + name; };
  EXPECT_EQ(error_of("ASTM-E57\1"), other("an E57 file"));
  EXPECT_EQ(error_of("# vtk DataFile Version 3.0\n"), other("a VTK file"));
  EXPECT_EQ(error_of("\x1f\x8b\x08"), other("a gzip archive"));
  EXPECT_EQ(error_of(std::string(80, ' ') + "\1\0\0\0"s), other("binary data"));
  EXPECT_EQ(error_of(""), "empty file");
  for (const char* file : {"\n\n", "# only comments\n", "hello\n", "one two three four\n1 2 3 4\n",
                           "1 2\n3 4\n", "a,b,c\n1,2,3\n"}) {
    EXPECT_THAT(error_of(file), StartsWith("not a point cloud: ")) << file;
  }
}

TEST(Text, WritesCloudsFromElsewhere) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 100000}, {0.5, -0.0, 1e20}};
  EXPECT_EQ(written(dir, cloud, "a.xyz"), "1 2 100000\n0.5 -0 1e+20\n");
  EXPECT_EQ(written(dir, cloud, "a.CSV"), "1,2,100000\n0.5,-0,1e+20\n");
  EXPECT_EQ(written(dir, cloud, "a.pts"), "2\n1 2 100000\n0.5 -0 1e+20\n");
  cloud.normals = {{0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(written(dir, cloud, "a.asc"), "1 2 100000 0 0 1\n0.5 -0 1e+20 0 0 0\n");
  cloud.normals = {{0, 0, 2}, {0, 0, 0}};  // would not be seen as normals without names
  EXPECT_THAT(written(dir, cloud, "a.txt"), StartsWith("x y z nx ny nz\n"));
  cloud.normals.clear();
  cloud.layout.comments = {"by hand"};
  cloud.attributes = {{"a b", std::vector<float>{0.1F, 3}, {}},
                      {"u", std::vector<std::uint8_t>{7, 255}, {}}};
  EXPECT_EQ(written(dir, cloud, "a.csv"),
            "# by hand\nx,y,z,a b,u\n1,2,100000,0.1,7\n0.5,-0,1e+20,3.0,255\n");
  EXPECT_EQ(written(dir, cloud, "a.xyz"),
            "# by hand\nx y z \"a b\" u\n1 2 100000 0.1 7\n0.5 -0 1e+20 3.0 255\n");
  EXPECT_THAT(names(read_cloud(dir / "a.xyz")), ElementsAre("x", "y", "z", "a b", "u"));
}

TEST(Text, SaysWhatItCannotHold) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 3}};
  cloud.attributes = {{"list", std::vector<float>{1, 2}, {0, 2}}};
  cloud.layout.elements = {{"face", 0, {}, false}, {"edge", 3, {}, true}};
  EXPECT_THAT(write_cloud(dir / "a.xyz", cloud),
              ElementsAre("text cannot hold the element 'face' (0 items), which was left out",
                          "text cannot hold the element 'edge' (3 items), which was left out",
                          "text cannot hold the lists 'list', which were left out"));
  EXPECT_EQ(get(dir / "a.xyz"), "1 2 3\n");
}

// Names that differ in characters which become blanks, or in what an empty name is read as.
TEST(Text, KeepsNamesApart) {
  const TempDir dir;
  const PointCloud cloud = parsed("# c\nx,y,z,a\rb,a b,a\vb\n1,2,3,4,5,6\n", "csv");
  EXPECT_THAT(names(cloud), ElementsAre("x", "y", "z", "a\rb", "a b", "a\vb"));
  EXPECT_THAT(write_cloud(dir / "a.csv", cloud),
              ElementsAre("text cannot hold the name 'a\rb', it became 'a b_'"));
  EXPECT_EQ(get(dir / "a.csv"), "# c\nx,y,z,a b_,a b,a\vb\n1,2,3,4,5,6\n");

  PointCloud unnamed;
  unnamed.points = {{1, 2, 3}};
  unnamed.attributes = {{"column_5", std::vector<std::int32_t>{4}, {}},
                        {"", std::vector<std::int32_t>{5}, {}}};
  EXPECT_THAT(write_cloud(dir / "a.csv", unnamed),
              ElementsAre("text cannot hold the name '', it became 'column_5_'"));
  EXPECT_THAT(names(read_cloud(dir / "a.csv")),
              ElementsAre("x", "y", "z", "column_5", "column_5_"));
}

TEST(Text, WritesNewColumnsOnlyUnderNames) {
  const TempDir dir;
  for (const std::string header : {"", "x y z i\n"}) {
    PointCloud cloud = read(dir, header + "1 2 3 4\n");
    cloud.normals = {{0, 0, 1}};
    cloud.attributes.push_back({"label", std::vector<std::uint8_t>{2}, {}});
    EXPECT_THAT(write_cloud(dir / "a.txt", cloud), IsEmpty());
    EXPECT_EQ(get(dir / "a.txt"),
              header.empty() ? "1 2 3 4\n" : "x y z i nx ny nz label\n1 2 3 4 0 0 1 2\n");
  }
}

TEST(Text, BecomesPlyAndBack) {
  const TempDir dir;
  const PointCloud cloud = read(dir, "# c\nEasting;Y;z;GPS time;i\n1.5;2;3;0.1;300\n");
  EXPECT_THAT(written(dir, cloud, "a.ply"),
              StartsWith("ply\nformat binary_little_endian 1.0\ncomment c\nelement vertex 1\n"
                         "property double x\nproperty double y\nproperty double z\n"
                         "property double GPS_time\nproperty ushort i\nend_header\n"));
  EXPECT_EQ(written(dir, read_cloud(dir / "a.ply"), "b.csv"),
            "# c\nx,y,z,GPS_time,i\n1.5,2,3,0.1,300\n");
}

TEST(Text, WritesNoPointsSoThatTheyCanBeRead) {
  const TempDir dir;
  for (const char* name : {"a.xyz", "a.csv", "a.pts"}) {
    (void)write_cloud(dir / name, {});
    EXPECT_EQ(read_cloud(dir / name).size(), 0U) << name;
  }
}

TEST(Text, IsTheSameInEveryLocale) {
  const TempDir dir;
  if (!set_comma_locale(dir.path())) {
    GTEST_SKIP() << "NOT TESTED: no locale with a decimal comma is installed or can be made";
  }
  const PointCloud cloud = read(dir, "1.5 2.5 3.5 4.25\n");
  const std::string again = written(dir, cloud, "a.txt");
  ASSERT_NE(std::setlocale(LC_ALL, "C"), nullptr);
  EXPECT_EQ(cloud.points[0], (Vec3{1.5, 2.5, 3.5}));
  EXPECT_EQ(again, "1.5 2.5 3.5 4.25\n");
}

const char* const small_files[] = {
    "# c\nx,y,z,name,nx,ny,nz,id\n1,2,3,\"a \"\"b\"\"\",0,0,1,7\n-4.5,nan,6e3,b,1,0,0,8\n",
    "3\n1 2 3 0 0 1\n4 5 6 0 1 0\n7 8 9 1 0 0\n", "//X;Y;Z;I\n1.25;2;3;4\n5;6;7;8\n"};

TEST(Text, EveryTruncationIsReadOrRefused) {
  for (const std::string file : small_files) {
    int read = 0;
    for (std::size_t length = 0; length < file.size(); ++length) {
      read += error_of(file.substr(0, length)).empty() ? 1 : 0;
    }
    EXPECT_GT(read, 0);
    EXPECT_LT(read, static_cast<int>(file.size()));
  }
}

TEST(Text, SurvivesRandomDamage) {
  for (const char* file : small_files) fuzz(file, 2, 3000);
}

// The law behind all of the above: what is read can be written, and is then read as the same.
TEST(Text, WritesWhateverItAccepts) {
  const TempDir dir;
  std::mt19937 random(3);
  constexpr std::string_view marks = "01-+.,;: \t\"aXyz";
  int accepted = 0;
  for (int run = 0; run < 1000; ++run) {
    std::string data = small_files[run % 3];
    for (int n = 0; n < 2; ++n) data[random() % data.size()] = marks[random() % marks.size()];
    PointCloud cloud;
    try {
      cloud = parse_cloud({"broken", data, {}});
    } catch (const IoError&) {
      continue;
    }
    ++accepted;
    SCOPED_TRACE(data);
    const PointCloud again = parse_cloud({"again", written(dir, cloud, "a.pts"), {}});
    EXPECT_TRUE(same_values(again.points, cloud.points));
    EXPECT_TRUE(same_values(again.normals, cloud.normals));
    expect_same(again.attributes, cloud.attributes);
  }
  EXPECT_GT(accepted, 100);
}

TEST(Text, StopsReadingWhenCancelled) {
  const TempDir dir;
  put(dir / "a", "1 2 3\n");
  for (int stop = 1; stop <= 3; ++stop) {
    int left = stop;
    EXPECT_THROW((void)read_cloud(dir / "a", [&] { return --left == 0; }), Cancelled);
  }
}

TEST(OutputFormat, GoesByExtensionOrName) {
  for (const char* name : {"a.ply", "a.PLY", "a.xyz", "a.txt", "a.csv", "a.asc", "b/a.b.pts",
                           "a.las", "a.pcd", "a.stl", "a.obj", "a.off"}) {
    EXPECT_TRUE(output_format(name)) << name;
  }
  for (const char* name : {"a", "ply", ".ply", "a.laz", "a.ply.gz", ""}) {
    EXPECT_FALSE(output_format(name)) << name;
  }
  EXPECT_EQ(output_format("a.PLY")->name, "ply");
  EXPECT_EQ(output_format("-")->name, "ply");
  EXPECT_EQ(output_format("a.ply", "las")->name, "las");
  EXPECT_FALSE(output_format("a.ply", "docx"));
  EXPECT_TRUE(output_format("a.las")->takes_any_field);
  EXPECT_FALSE(output_format("a.csv")->takes_any_field);
}

}  // namespace
}  // namespace deburr
