// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_set.hpp"

#include <utility>

namespace deburr {
namespace {

std::vector<Vec3> places_of(std::span<const PackedSheet> sheets) {
  std::vector<Vec3> places;
  places.reserve(sheets.size());
  for (const PackedSheet& sheet : sheets) places.push_back(sheet.place);
  return places;
}

}  // namespace

SheetSet::SheetSet(NodeSheets fitted, std::size_t nodes, const Execution& execution)
    : sheets_(std::move(fitted.sheets)),
      of_(nodes, none),
      places_(places_of(sheets_)),
      even_(std::span(places_).first(fitted.even), execution),
      // Without further sheets that would be the same tree again.
      all_(fitted.even == sheets_.size() ? Points{} : Points(places_), execution) {
  for (std::uint32_t k = 0; k < fitted.nodes.size(); ++k) of_[fitted.nodes[k]] = k;
}

}  // namespace deburr
