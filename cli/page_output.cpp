// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "page_output.hpp"

#include <algorithm>
#include <stdexcept>

#include "output_file.hpp"
#include "view/png.hpp"
#include "view/still.hpp"

namespace deburr::cli {
namespace {

// Of the report of a run, without its file names.
constexpr std::size_t room_for_report = 10'000;
constexpr int still_width = 480;
constexpr int still_height = 360;

void add_still(const view::ShownCloud& shown, view::Up up, std::vector<view::Still>& stills,
               const Execution& execution) {
  if (std::ranges::none_of(shown.cloud->points, is_finite)) return;
  view::StillOptions options{.up = up};
  options.raster.width = still_width;
  options.raster.height = still_height;
  const view::StillPicture still = view::draw_still({.before = shown}, options, execution);
  stills.push_back({shown.name, view::png_bytes(still.picture)});
}

}  // namespace

std::vector<std::string> page_extensions() { return {".html", ".htm"}; }

bool is_page(const std::string& path) {
  const std::vector<std::string> known = page_extensions();
  return std::ranges::find(known, extension(path)) != known.end();
}

void check_page_output(const std::string& path) {
  if (view::viewer_template().empty()) throw std::runtime_error(view::missing_viewer());
  check_output(path);
}

PreparedPage prepare_page(const view::Request& request, const view::SceneOptions& options,
                          const Execution& execution) {
  PreparedPage page;
  add_still(request.before, options.up, page.stills, execution);
  if (request.after) add_still(*request.after, options.up, page.stills, execution);
  const std::size_t room =
      view::room_for_points(options, view::viewer_template(), room_for_report, page.stills);
  page.scene = view::make_scene(request, room, options, execution);
  return page;
}

std::string page_html(const PreparedPage& page, const std::string& report) {
  return view::page_html(view::viewer_template(), page.scene, {report, page.stills});
}

}  // namespace deburr::cli
