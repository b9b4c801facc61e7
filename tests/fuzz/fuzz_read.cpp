// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "io/format.hpp"
#include "support/find_attribute.hpp"
#include "support/memory_file.hpp"
#include "support/same_values.hpp"
#include "support/say_the_same.hpp"

// A target of libFuzzer: any bytes are read or refused, and what was read is written and read back
// as the same. DEBURR_FUZZ_FORMAT is the name of the format.

namespace deburr {
namespace {

constexpr std::string_view read_format = DEBURR_FUZZ_FORMAT;
/// Of the formats of text, the one that keeps a count line.
constexpr std::string_view written_format = read_format == "csv" ? "pts" : read_format;

[[noreturn]] void fail(const char* what) {
  (void)std::fprintf(stderr, "%s\n", what);
  std::abort();
}

/// Whether every attribute is there with its type and values, or is named in a warning.
bool same_attributes(const PointCloud& before, const PointCloud& after,
                     const std::vector<std::string>& warnings) {
  if (after.attributes.size() != before.attributes.size()) return false;
  return std::ranges::all_of(before.attributes, [&](const Attribute& a) {
    const Attribute* const found = find_attribute(after, a.name);
    const bool is_same = found != nullptr && found->type() == a.type() && say_the_same(a, *found);
    return is_same || are_named(warnings, "'" + a.name + "'");
  });
}

void try_one(std::string data) {
  PointCloud cloud;
  try {
    cloud = parse_cloud({"fuzz", std::move(data), {}}, read_format);
  } catch (const IoError&) {
    return;
  }
  std::string again;
  std::vector<std::string> warnings;
  try {
    (void)write_cloud("/dev/null", cloud, {}, "ply");
    again = written_in_memory(cloud, written_format, &warnings);
  } catch (const DataError&) {
    return;  // infinite coordinates in LAS
  }
  const PointCloud twice = parse_cloud({"again", again, {}}, read_format);
  if (!same_values(twice.points, cloud.points)) fail("other points");
  if (!same_values(twice.normals, cloud.normals)) fail("other normals");
  if (!same_attributes(cloud, twice, warnings)) fail("other attributes");
  const bool are_same = twice.layout.comments == cloud.layout.comments;
  if (!are_same && !are_named(warnings, "comment")) fail("other comments");
}

}  // namespace
}  // namespace deburr

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  deburr::try_one({data, data + size});
  return 0;
}
