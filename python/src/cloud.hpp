// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include "deburr/point_cloud.hpp"

namespace deburr::python {

/// A cloud as a dict: points, normals (or None), attributes, layout. Arrays take over the memory.
///
/// An attribute is (name, values, offsets or None, type of lengths); values are an array, or a list
/// of str. The layout is a dict with the names of FileLayout.
[[nodiscard]] nanobind::dict cloud_to_python(PointCloud cloud);

/// The cloud of such a dict; copies the arrays.
[[nodiscard]] PointCloud cloud_from_python(const nanobind::dict& cloud);

}  // namespace deburr::python
