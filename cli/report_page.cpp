// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "report_page.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace deburr::cli {

ReportPage::ReportPage(std::string input, std::string output, PointCloud& cloud)
    : input_(std::move(input)), output_(std::move(output)), before_(cloud) {
  numbers_ = "deburr_number";
  while (std::ranges::find(cloud.attributes, numbers_, &Attribute::name) !=
         cloud.attributes.end()) {
    numbers_ += '_';
  }
  std::vector<std::uint32_t> numbers(cloud.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  cloud.attributes.push_back({.name = numbers_, .values = std::move(numbers), .offsets = {}});
}

void ReportPage::take(DenoiseResult& result, const Execution& execution) {
  const auto found = std::ranges::find(result.cloud.attributes, numbers_, &Attribute::name);
  const auto numbers = std::get<std::vector<std::uint32_t>>(std::move(found->values));
  result.cloud.attributes.erase(found);
  const view::Request request{.before = {.name = input_, .cloud = &before_},
                              .after = view::ShownCloud{.name = output_,
                                                        .cloud = &result.cloud,
                                                        .labels = result.labels,
                                                        .outliers = result.outliers},
                              .origin = numbers};
  page_ = prepare_page(request, {}, execution);
  before_ = {};
}

std::string ReportPage::html(const std::string& report) const { return page_html(page_, report); }

}  // namespace deburr::cli
