// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "page_output.hpp"

#include <stdexcept>

#include "output_file.hpp"

namespace deburr::cli {
namespace {

// Of the report of a run, without its file names.
constexpr std::size_t room_for_report = 10'000;

}  // namespace

bool is_page(const std::string& path) {
  const std::string end = extension(path);
  return end == ".html" || end == ".htm";
}

void check_page_output(const std::string& path) {
  if (view::viewer_template().empty()) throw std::runtime_error(view::missing_viewer());
  check_output(path);
}

view::Scene page_scene(const view::Request& request, const view::SceneOptions& options,
                       const Execution& execution) {
  const std::size_t room =
      view::room_for_points(options, view::viewer_template(), room_for_report, {});
  return view::make_scene(request, room, options, execution);
}

std::size_t write_page(const std::string& path, const view::Scene& scene,
                       const std::string& report) {
  const std::string html = view::page_html(view::viewer_template(), scene, {.report = report});
  view::write_page(path, html);
  return html.size();
}

}  // namespace deburr::cli
