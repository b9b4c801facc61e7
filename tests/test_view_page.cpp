// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "deburr/error.hpp"
#include "deburr/synth.hpp"
#include "deburr/version.hpp"
#include "view/page.hpp"
#include "view/scene.hpp"

// The file of a page: it holds what was given, and none of it as markup or script.

namespace deburr::view {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* page =
    "<head></head><p><!--deburr:stills--></p><!--deburr:data--><script>1</script>";

std::string block(const std::string& html, const std::string& name) {
  const std::string start = "<script id=\"deburr-" + name + "\"";
  const std::size_t tag = html.find(start);
  if (tag == std::string::npos) return "";
  const std::size_t begin = html.find('>', tag) + 1;
  return html.substr(begin, html.find('<', begin) - begin);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

const std::string hostile =
    "</script><script>alert(1)</script><!--<script>&lt;img src=x "
    "onerror=alert(1)>\"'\xff\xe2\x80\xa8";

TEST(ViewPage, HoldsItsBlocks) {
  const PointCloud cloud = synthesize_part({.points = 50}).cloud;
  const Scene scene = make_scene({.before = {.name = "a.ply", .cloud = &cloud}}, 1'000'000);
  const std::string html =
      page_html(page, scene, {.report = R"({"noise":0.5})", .stills = {{"a.ply", "abc"}}});
  EXPECT_EQ(block(html, "version"), version);
  EXPECT_EQ(nlohmann::json::parse(block(html, "scene"))["clouds"][0]["name"], "a.ply");
  EXPECT_EQ(block(html, "report"), R"({"noise":0.5})");
  EXPECT_EQ(block(html, "points").size() % 4, 0U);
  EXPECT_THAT(html, HasSubstr("<p><figure><img alt=\"\" src=\"data:image/png;base64,YWJj\">"));
  EXPECT_THAT(html, HasSubstr("</script>\n<script>1</script>"));
  EXPECT_THAT(page_html(page, scene, {}), Not(HasSubstr("deburr-report")));
}

TEST(ViewPage, NothingOfAFileBecomesMarkup) {
  PointCloud cloud = synthesize_part({.points = 20}).cloud;
  cloud.layout.comments = {hostile, std::string(100'000, '<')};
  const Scene scene = make_scene({.before = {.name = hostile, .cloud = &cloud}}, 1'000'000);
  const std::string report = nlohmann::json({{"input", "</script><b>"}}).dump();
  const std::string html = page_html(page, scene, {.report = report, .stills = {{hostile, "abc"}}});
  EXPECT_EQ(count(html, "<script"), 5U);  // version, scene, report, points, and that of the page
  EXPECT_EQ(count(html, "</script"), 5U);
  EXPECT_EQ(count(html, "<!--"), 0U);
  EXPECT_EQ(count(html, "<img"), 1U);
  EXPECT_EQ(count(html, "<b>"), 0U);
  const auto about = nlohmann::json::parse(block(html, "scene"))["clouds"][0];
  EXPECT_THAT(about["name"].get<std::string>(), HasSubstr("</script><script>alert(1)"));
  EXPECT_THAT(about["comments"][0].get<std::string>(), HasSubstr("onerror=alert(1)"));
  EXPECT_LT(html.size(), 100'000U);
  EXPECT_EQ(nlohmann::json::parse(block(html, "report"))["input"], "</script><b>");
}

TEST(ViewPage, TheWholeIsNoLargerThanAllowed) {
  const PointCloud cloud = synthesize_part({.points = 30'000}).cloud;
  const std::vector<Still> stills{{"a", std::string(20'000, 'x')}};
  const SceneOptions options{.max_bytes = 400'000};
  const std::size_t room = room_for_points(options, page, 1000, stills);
  const Scene scene = make_scene({.before = {.name = "a", .cloud = &cloud}}, room, options);
  EXPECT_LT(scene.shown[0], 30'000U);
  const std::string html =
      page_html(page, scene, {.report = std::string(1000, ' '), .stills = stills});
  EXPECT_LE(html.size(), 400'000U);
  EXPECT_GT(html.size(), 290'000U);
  EXPECT_EQ(room_for_points({.max_bytes = 10}, page, 0, {}), 0U);
}

TEST(ViewPage, IsMadeInOneCall) {
  const PointCloud cloud = synthesize_part({.points = 50}).cloud;
  const Request request{.before = {.name = "a.ply", .cloud = &cloud}};
  if (viewer_template().empty()) {
    EXPECT_THROW((void)make_page(request), std::runtime_error);
    return;
  }
  const std::string html = make_page(request, R"({"noise":0.5})");
  EXPECT_EQ(nlohmann::json::parse(block(html, "scene"))["clouds"][0]["shown"], 50);
  EXPECT_EQ(block(html, "report"), R"({"noise":0.5})");
}

TEST(ViewPage, RefusesATemplateWithoutItsMarks) {
  EXPECT_THROW((void)page_html("", {}, {}), std::invalid_argument);
  EXPECT_THROW((void)page_html("<!--deburr:data--><!--deburr:stills-->", {}, {}),
               std::invalid_argument);
}

TEST(ViewPage, TheTemplateRunsOnlyItsOwnScript) {
  const std::string built(viewer_template());
  if (built.empty()) GTEST_SKIP() << "built without the viewer";
  EXPECT_EQ(count(built, "<!--deburr:stills-->"), 1U);
  EXPECT_EQ(count(built, "<!--deburr:data-->"), 1U);
  EXPECT_EQ(count(built, "<script"), 1U);
  const std::regex policy(
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "script-src 'sha256-[A-Za-z0-9+/=]+'; style-src 'sha256-[A-Za-z0-9+/=]+'; "
      "img-src data: blob:; base-uri 'none'; form-action 'none'\"");
  EXPECT_THAT(built, HasSubstr("Permission is hereby granted"));  // what three.js asks for
  const std::string head = built.substr(0, 4000);
  EXPECT_TRUE(std::regex_search(head, policy)) << head.substr(0, 800);
  EXPECT_EQ(built.find("http://"), built.find("http://www.w3.org"));
}

}  // namespace
}  // namespace deburr::view
