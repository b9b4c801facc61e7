// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <exception>

#include "bind.hpp"
#include "deburr/error.hpp"
#include "deburr/version.hpp"

namespace {

namespace nb = nanobind;

/// The exceptions of the package, which are written in Python; never freed, as modules are not.
struct Errors {
  PyObject* io;
  PyObject* data;
  PyObject* cancelled;
};

Errors import_errors() {
  const nb::module_ errors = nb::module_::import_("deburr._errors");
  const auto keep = [&](const char* name) { return nb::object(errors.attr(name)).release().ptr(); };
  return {keep("DeburrIOError"), keep("DataError"), keep("Cancelled")};
}

void translate(const std::exception_ptr& error, void* types) {
  const auto& [io, data, cancelled] = *static_cast<const Errors*>(types);
  try {
    std::rethrow_exception(error);
  } catch (const deburr::IoError& e) {
    PyErr_SetString(io, e.what());
  } catch (const deburr::DataError& e) {
    PyErr_SetString(data, e.what());
  } catch (const deburr::Cancelled& e) {
    PyErr_SetString(cancelled, e.what());
  }
}

}  // namespace

NB_MODULE(_core, m) {
  using namespace deburr::python;
  m.doc() = "The C++ library; the package deburr is what to use.";
  m.attr("version") = deburr::version;
  static Errors errors = import_errors();
  nb::register_exception_translator(translate, &errors);
  bind_neighborhoods(m);
  bind_stages(m);
  bind_noise(m);
  bind_denoise(m);
  bind_metrics(m);
  bind_synth(m);
  bind_files(m);
  bind_view(m);
}
