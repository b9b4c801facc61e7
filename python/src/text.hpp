// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <string>

namespace deburr::python {

/// Text of a file as str. Bytes that are not UTF-8 survive as lone surrogates, as in file names.
inline nanobind::object to_text(const std::string& bytes) {
  PyObject* const text =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "surrogateescape");
  if (text == nullptr) throw nanobind::python_error();
  return nanobind::steal(text);
}

/// The bytes of a str that to_text() made, or of any other.
inline std::string from_text(nanobind::handle text) {
  PyObject* const encoded = PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogateescape");
  if (encoded == nullptr) throw nanobind::python_error();
  const auto bytes = nanobind::steal<nanobind::bytes>(encoded);
  return {bytes.c_str(), bytes.size()};
}

}  // namespace deburr::python
