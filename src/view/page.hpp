// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "view/scene.hpp"

namespace deburr::view {

/// The page without its data, as it was built from viewer/; empty in a build without it.
[[nodiscard]] std::string_view viewer_template();

/// What to tell a user of a build without the template: what is missing and how to get it.
[[nodiscard]] std::string missing_viewer();

/// A picture for browsers that cannot draw the points.
struct Still {
  std::string name;
  std::string png;  ///< the bytes of the file
};

/// What stands on a page besides its points.
struct PageText {
  std::string report;  ///< JSON object as `deburr denoise --json` prints it; may be empty
  std::vector<Still> stills{};
};

/// Bytes of a page of options.max_bytes that are left for points.
/// @param report_size  of the report that will be written, about
[[nodiscard]] std::size_t room_for_points(const SceneOptions& options, std::string_view page,
                                          std::size_t report_size,
                                          const std::vector<Still>& stills);

/// The page: one file that needs no other. Nothing in names, comments or the report can become
/// markup or script.
/// @param page  viewer_template(), or another text with its marks
/// @throws std::invalid_argument  for a template without its marks
[[nodiscard]] std::string page_html(std::string_view page, const Scene& scene,
                                    const PageText& text);

/// The whole page of a request in one call, without still pictures.
/// @param report  as PageText::report
/// @throws std::runtime_error  missing_viewer(), in a build without the template
/// @throws std::invalid_argument  as make_scene
/// @throws Cancelled  when execution.cancelled says so
[[nodiscard]] std::string make_page(const Request& request, const std::string& report = {},
                                    const SceneOptions& options = {},
                                    const Execution& execution = {});

}  // namespace deburr::view
