// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/pair.h>

#include <cstdint>
#include <utility>

#include "arrays.hpp"
#include "bind.hpp"
#include "deburr/neighborhoods.hpp"
#include "run.hpp"
#include "sizes.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

std::vector<std::uint64_t> offsets_of(const Neighborhoods& neighborhoods) {
  std::vector<std::uint64_t> offsets{0};
  offsets.reserve(neighborhoods.size() + 1);
  for (std::size_t i = 0; i < neighborhoods.size(); ++i) {
    offsets.push_back(offsets.back() + neighborhoods[i].size());
  }
  return offsets;
}

std::vector<std::uint32_t> indices_of(const Neighborhoods& neighborhoods) {
  std::vector<std::uint32_t> indices;
  indices.reserve(neighborhoods.pair_count());
  for (std::size_t i = 0; i < neighborhoods.size(); ++i) {
    const auto some = neighborhoods[i];
    indices.insert(indices.end(), some.begin(), some.end());
  }
  return indices;
}

Neighborhoods from_arrays(const ValueArray<std::uint64_t>& offsets,
                          const ValueArray<std::uint32_t>& indices) {
  const auto ends = as_span(offsets);
  const auto all = as_span(indices);
  return {{ends.begin(), ends.end()}, {all.begin(), all.end()}};
}

NewValues<std::uint32_t> neighbors_of(const Neighborhoods& neighborhoods, std::int64_t i) {
  const auto size = static_cast<std::int64_t>(neighborhoods.size());
  const std::int64_t at = i < 0 ? i + size : i;
  if (at < 0 || at >= size) throw nb::index_error("no such point");
  const auto some = neighborhoods[static_cast<std::size_t>(at)];
  return to_array(std::vector<std::uint32_t>(some.begin(), some.end()));
}

}  // namespace

void bind_neighborhoods(nb::module_& m) {
  nb::class_<Neighborhoods>(
      m, "Neighborhoods",
      "The neighbours of every point: those of a point do not include it and are sorted by\n"
      "(distance, index). Made by find_neighbors(), or of two arrays, as of a sparse matrix.\n\n"
      "len() is the number of points; n[i] are the neighbours of point i, uint32, nearest first.\n")
      .def(
          "__init__",
          [](Neighborhoods* self, const ValueArray<std::uint64_t>& offsets,
             const ValueArray<std::uint32_t>& indices) {
            new (self) Neighborhoods(from_arrays(offsets, indices));
          },
          "offsets"_a, "indices"_a)
      .def("__len__", &Neighborhoods::size)
      .def("__getitem__", neighbors_of, "i"_a)
      .def_prop_ro("pair_count", &Neighborhoods::pair_count,
                   "Number of neighbours of all points together.")
      .def_prop_ro(
          "offsets", [](const Neighborhoods& n) { return to_array(offsets_of(n)); },
          nb::rv_policy::move,
          "(N + 1,) uint64, a copy: the neighbours of point i are\n"
          "indices[offsets[i]:offsets[i + 1]].")
      .def_prop_ro(
          "indices", [](const Neighborhoods& n) { return to_array(indices_of(n)); },
          nb::rv_policy::move, "(pair_count,) uint32, a copy.")
      .def("__getstate__",
           [](const Neighborhoods& n) {
             return nb::make_tuple(to_array(offsets_of(n)), to_array(indices_of(n)));
           })
      .def("__setstate__",
           [](Neighborhoods& self,
              const std::pair<ValueArray<std::uint64_t>, ValueArray<std::uint32_t>>& state) {
             new (&self) Neighborhoods(from_arrays(state.first, state.second));
           })
      .def("__repr__", [](const Neighborhoods& n) {
        return nb::str("Neighborhoods({} points, {} pairs)").format(n.size(), n.pair_count());
      });

  m.def(
      "find_neighbors",
      [](const VectorArray& points, std::int64_t max_count, double radius, int threads,
         const nb::object& on_progress) {
        const NeighborOptions options{to_size("max_count", max_count), radius};
        return run(threads, on_progress, [&](const Execution& execution) {
          return find_neighbors(as_span(points), options, execution);
        });
      },
      "points"_a, "max_count"_a, "radius"_a, "threads"_a, "on_progress"_a.none());
  m.def(
      "mean_neighbor_distance",
      [](const VectorArray& points, const Neighborhoods& neighborhoods, int threads) {
        return run(threads, nb::none(), [&](const Execution& execution) {
          return mean_neighbor_distance(as_span(points), neighborhoods, execution);
        });
      },
      "points"_a, "neighborhoods"_a, "threads"_a);
}

}  // namespace deburr::python
