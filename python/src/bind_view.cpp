// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bind.hpp"
#include "cloud.hpp"
#include "io/atomic_file.hpp"
#include "run.hpp"
#include "text.hpp"
#include "view/page.hpp"
#include "words.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

constexpr Choice<view::Up> ups[] = {{"z", view::Up::Z},       {"y", view::Up::Y},
                                    {"x", view::Up::X},       {"-z", view::Up::MinusZ},
                                    {"-y", view::Up::MinusY}, {"-x", view::Up::MinusX}};

using Distances = ValueArray<double>;
using Indices = ValueArray<std::uint32_t>;

/// What a ShownCloud refers to. It must not move, nor be copied, while that is in use.
class Shown {
 public:
  /// @param parts  (name, cloud as a dict, distances from the truth or None)
  explicit Shown(const nb::tuple& parts)
      : name_(from_text(parts[0])), cloud_(cloud_from_python(nb::cast<nb::dict>(parts[1]))) {
    if (!nb::object(parts[2]).is_none()) truth_ = nb::cast<Distances>(parts[2]);
  }

  [[nodiscard]] view::ShownCloud get() const {
    view::ShownCloud shown{.name = name_, .cloud = &cloud_};
    if (truth_) shown.truth_distance = as_span(*truth_);
    return shown;
  }

 private:
  std::string name_;
  PointCloud cloud_;
  std::optional<Distances> truth_;
};

/// (page, points shown of each cloud, whether the movement is known, warnings)
nb::tuple make_page(const nb::tuple& before, const std::optional<nb::tuple>& after,
                    const std::optional<Indices>& origin, const nb::str& report,
                    std::size_t max_bytes, const std::string& up, int threads,
                    const nb::object& on_progress) {
  const std::string_view page = view::viewer_template();
  if (page.empty()) throw std::runtime_error(view::missing_viewer());
  const Shown first(before);
  std::optional<Shown> second;
  if (after) second.emplace(*after);
  view::Request request{.before = first.get()};
  if (second) request.after = second->get();
  if (origin) request.origin = as_span(*origin);
  const view::PageText text{.report = from_text(report)};
  const view::SceneOptions options{.max_bytes = max_bytes, .up = parse_word("up", up, ups)};
  auto [scene, html] = run(threads, on_progress, [&](const Execution& execution) {
    const std::size_t room = view::room_for_points(options, page, text.report.size(), {});
    view::Scene made = view::make_scene(request, room, options, execution);
    std::string whole = view::page_html(page, made, text);
    return std::pair(std::move(made), std::move(whole));
  });
  return nb::make_tuple(nb::bytes(html.data(), html.size()), scene.shown, scene.paired,
                        scene.warnings);
}

}  // namespace

void bind_view(nb::module_& m) {
  m.def("has_viewer", [] { return !view::viewer_template().empty(); });
  m.def("make_page", make_page, "before"_a, "after"_a.none(), "origin"_a.none(), "report"_a,
        "max_bytes"_a, "up"_a, "threads"_a, "on_progress"_a.none());
  m.def(
      "write_whole",
      [](const std::filesystem::path& path, const nb::bytes& bytes) {
        const std::string text(bytes.c_str(), bytes.size());
        run(0, nb::none(), [&](const Execution&) {
          AtomicFile file(path);
          file.write(text);
          file.commit();
          return 0;
        });
      },
      "path"_a, "bytes"_a);
  m.def("page_defaults", [] {
    nb::dict options;
    options["max_bytes"] = view::SceneOptions{}.max_bytes;
    options["up"] = word_for(ups, view::SceneOptions{}.up);
    return options;
  });
}

}  // namespace deburr::python
