// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "arrays.hpp"
#include "bind.hpp"
#include "cloud.hpp"
#include "deburr/io.hpp"
#include "run.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;
using Path = std::filesystem::path;

nb::tuple read(const Path& path, std::string_view format) {
  std::vector<std::string> doubts;
  PointCloud cloud = run(0, nb::none(), [&](const Execution& execution) {
    PointCloud read = read_cloud(path, execution.cancelled, format);
    doubts = doubts_about(read);
    return read;
  });
  return nb::make_tuple(cloud_to_python(std::move(cloud)), doubts);
}

std::vector<std::string> write(const Path& path, const nb::dict& parts, std::string_view format) {
  const PointCloud cloud = cloud_from_python(parts);
  return run(0, nb::none(), [&](const Execution& execution) {
    return write_cloud(path, cloud, execution.cancelled, format);
  });
}

/// (name, whether it takes any field), or None for a format that is not known.
nb::object format_of(const Path& path, std::string_view format) {
  const auto info = output_format(path, format);
  if (!info) return nb::none();
  return nb::make_tuple(info->name, info->takes_any_field);
}

}  // namespace

void bind_files(nb::module_& m) {
  m.def("read", read, "path"_a, "format"_a);
  m.def("write", write, "path"_a, "cloud"_a, "format"_a);
  m.def("output_format", format_of, "path"_a, "format"_a);
  m.def("format_names", format_names);
  m.def(
      "read_mesh",
      [](const Path& path) {
        return mesh_to_python(
            run(0, nb::none(), [&](const Execution&) { return read_mesh(path); }));
      },
      "path"_a);
  m.def(
      "write_mesh",
      [](const Path& path, const VectorArray& vertices, const TriangleArray& triangles) {
        const TriangleMesh mesh = make_mesh(vertices, triangles);
        run(0, nb::none(), [&](const Execution&) {
          write_mesh(path, mesh);
          return 0;
        });
      },
      "path"_a, "vertices"_a, "triangles"_a);
}

}  // namespace deburr::python
