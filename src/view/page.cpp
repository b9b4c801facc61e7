// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/page.hpp"

#include <array>
#include <stdexcept>

#include "deburr/version.hpp"
#include "view/encode.hpp"

namespace deburr::view {
namespace {

constexpr std::string_view stills_mark = "<!--deburr:stills-->";
constexpr std::string_view data_mark = "<!--deburr:data-->";

// For names, comments and everything else that the description holds.
constexpr std::size_t room_for_text = 100'000;

/// JSON in which no tag can begin or end.
std::string script_safe(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

/// A block that no browser runs.
void append_block(std::string& html, std::string_view id, std::string_view type,
                  std::string_view text) {
  html.append("<script id=\"").append(id).append("\" type=\"").append(type).append("\">");
  html.append(text).append("</script>\n");
}

std::string stills_html(const std::vector<Still>& stills) {
  std::string html;
  for (const Still& still : stills) {
    html.append("<figure><img alt=\"\" src=\"data:image/png;base64,").append(base64(still.png));
    html.append("\"><figcaption>").append(escaped(still.name)).append("</figcaption></figure>\n");
  }
  return html;
}

}  // namespace

std::string missing_viewer() {
  return "this build has no viewer page, which is made with Node.js 18 or newer: install nodejs "
         "and "
         "npm and configure with -DDEBURR_VIEWER=ON (docs/view.md)";
}

std::size_t room_for_points(const SceneOptions& options, std::string_view page,
                            std::size_t report_size, const std::vector<Still>& stills) {
  std::size_t taken = page.size() + report_size + room_for_text;
  for (const Still& still : stills) taken += base64_size(still.png.size()) + still.name.size();
  return options.max_bytes > taken ? options.max_bytes - taken : 0;
}

std::string page_html(std::string_view page, const Scene& scene, const PageText& text) {
  const std::size_t stills_at = page.find(stills_mark);
  const std::size_t data_at = page.find(data_mark);
  if (stills_at == std::string_view::npos || data_at == std::string_view::npos ||
      data_at < stills_at) {
    throw std::invalid_argument("the template of the page lacks a mark");
  }
  std::string html;
  html.reserve(page.size() + base64_size(scene.data.size()) + room_for_text);
  html.append(page.substr(0, stills_at)).append(stills_html(text.stills));
  const std::size_t after_stills = stills_at + stills_mark.size();
  html.append(page.substr(after_stills, data_at - after_stills));
  append_block(html, "deburr-version", "text/plain", version);
  append_block(html, "deburr-scene", "application/json", script_safe(scene.description));
  if (!text.report.empty()) {
    append_block(html, "deburr-report", "application/json", script_safe(text.report));
  }
  append_block(html, "deburr-points", "application/octet-stream", base64(scene.data));
  html.append(page.substr(data_at + data_mark.size()));
  return html;
}

std::string make_page(const Request& request, const std::string& report,
                      const SceneOptions& options, const Execution& execution) {
  const std::string_view page = viewer_template();
  if (page.empty()) throw std::runtime_error(missing_viewer());
  const std::size_t room = room_for_points(options, page, report.size(), {});
  return page_html(page, make_scene(request, room, options, execution), {.report = report});
}

}  // namespace deburr::view
