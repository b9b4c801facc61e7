// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel.hpp"
#include "require.hpp"

namespace deburr::view {
namespace {

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
/// Discs that are seen more from their edge are drawn as if seen at this cosine: something has to
/// be left of them.
constexpr double least_facing = 0.25;
/// Radius of a disc at most, in the shorter side of the picture.
constexpr double largest_disc = 0.5;
constexpr std::size_t points_between_looks = 64;
constexpr int most_pixels = 16384;
constexpr int most_samples = 8;

Vec3 unit(const Vec3& v) { return (1 / norm(v)) * v; }

/// What every sample of the picture shows.
class DepthBuffer {
 public:
  DepthBuffer(int width, int height)
      : width_(width),
        height_(height),
        depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
               -std::numeric_limits<double>::infinity()),
        index_(depth_.size(), nothing) {}

  /// A disc around a place in samples, at a depth in samples.
  /// @param normal  right, up and towards the viewer; zero for one that faces the viewer
  void disc(const Vec3& at, double radius, const Vec3& normal, std::uint32_t index) {
    // A disc may lie any distance outside: no number beyond the picture is one of a sample.
    const auto begin = [](double v, int most) {
      return static_cast<int>(std::ceil(std::clamp(v, 0.0, static_cast<double>(most))));
    };
    const auto end = [](double v, int most) {
      return static_cast<int>(std::floor(std::clamp(v, -1.0, static_cast<double>(most - 1))));
    };
    // Along the normal the depth changes by these, per sample to the right and up.
    const double facing = std::copysign(std::max(std::abs(normal.z), least_facing), normal.z);
    const double by_right = -normal.x / facing;
    const double by_up = -normal.y / facing;
    // Places of samples are the middles of their squares.
    for (int y = begin(at.y - radius - 0.5, height_); y <= end(at.y + radius - 0.5, height_); ++y) {
      const double up = at.y - (y + 0.5);
      for (int x = begin(at.x - radius - 0.5, width_); x <= end(at.x + radius - 0.5, width_); ++x) {
        const double right = x + 0.5 - at.x;
        const double nearer = by_right * right + by_up * up;
        if (right * right + up * up + nearer * nearer > radius * radius) continue;
        put(x, y, at.z + nearer, index);
      }
    }
  }

  /// The point at a sample; `nothing` where there is none.
  [[nodiscard]] std::uint32_t at(int x, int y) const { return index_[place(x, y)]; }

  /// One sample, for points that are smaller than that.
  void put(int x, int y, double depth, std::uint32_t index) {
    const std::size_t i = place(x, y);
    if (!(depth > depth_[i])) return;
    depth_[i] = depth;
    index_[i] = index;
  }

  [[nodiscard]] bool holds(double x, double y) const {
    return x >= 0 && x < width_ && y >= 0 && y < height_;
  }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<double> depth_;
  std::vector<std::uint32_t> index_;
};

/// The picture from the mean of the samples of each of its pixels.
class Developer {
 public:
  Developer(const Splats& splats, const Camera& camera, const RasterOptions& options)
      : splats_(splats),
        options_(options),
        towards_light_(unit(0.25 * camera.right + 0.35 * camera.up + 0.9 * camera.towards)) {}

  [[nodiscard]] Picture develop(const DepthBuffer& buffer) const {
    Picture picture{options_.width, options_.height, {}};
    for (int y = 0; y < options_.height; ++y) {
      for (int x = 0; x < options_.width; ++x) {
        for (const double value : mean(buffer, x, y)) {
          picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(value)));
        }
      }
    }
    return picture;
  }

 private:
  [[nodiscard]] std::array<double, 3> mean(const DepthBuffer& buffer, int x, int y) const {
    const int n = options_.samples;
    std::array<double, 3> sum{};
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const std::uint32_t index = buffer.at(n * x + i, n * y + j);
        const double light = index == nothing ? 1 : brightness(index);
        const Rgb& colour = index == nothing ? options_.background : splats_.colours[index];
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += light * colour[k];
      }
    }
    for (double& value : sum) value /= n * n;
    return sum;
  }

  [[nodiscard]] double brightness(std::uint32_t index) const {
    if (splats_.normals.empty()) return 1;
    const Vec3& normal = splats_.normals[index];
    const double length = norm(normal);
    if (!(length > 0)) return 1;
    const double facing = std::abs(dot(normal, towards_light_)) / length;
    return 1 - options_.light + options_.light * facing;
  }

  const Splats& splats_;
  const RasterOptions& options_;
  Vec3 towards_light_;
};

/// A normal as the viewer sees it.
Vec3 seen(const Vec3& normal, const Camera& camera) {
  const double length = norm(normal);
  if (!(length > 0)) return {0, 0, 1};
  return (1 / length) *
         Vec3{dot(normal, camera.right), dot(normal, camera.up), dot(normal, camera.towards)};
}

}  // namespace

Picture draw(const Splats& splats, const Camera& camera, const RasterOptions& options,
             const Execution& execution) {
  require(options.width >= 1 && options.width <= most_pixels, "width", "in [1, 16384]",
          options.width);
  require(options.height >= 1 && options.height <= most_pixels, "height", "in [1, 16384]",
          options.height);
  require(options.samples >= 1 && options.samples <= most_samples, "samples", "in [1, 8]",
          options.samples);
  require(options.light >= 0 && options.light <= 1, "light", "in [0, 1]", options.light);
  require(splats.radius > 0, "radius", "> 0", splats.radius);
  require(splats.colours.size() == splats.points.size(), "colours", "one per point",
          splats.colours.size());
  require(splats.normals.empty() || splats.normals.size() == splats.points.size(), "normals",
          "none, or one per point", splats.normals.size());

  const int n = options.samples;
  DepthBuffer buffer(n * options.width, n * options.height);
  const double scale = camera.scale * n;
  const double largest = largest_disc * n * std::min(options.width, options.height);
  const double radius = std::min(scale * splats.radius, largest);
  for (std::size_t i = 0; i < splats.points.size(); ++i) {
    if (i % points_between_looks == 0) check_cancelled(execution);
    if (!is_finite(splats.points[i])) continue;
    const Vec3 from_centre = splats.points[i] - camera.centre;
    const Vec3 at{n * options.width / 2.0 + scale * dot(from_centre, camera.right),
                  n * options.height / 2.0 - scale * dot(from_centre, camera.up),
                  scale * dot(from_centre, camera.towards)};
    if (!is_finite(at)) continue;
    const Vec3 normal = splats.normals.empty() ? Vec3{0, 0, 1} : seen(splats.normals[i], camera);
    const auto index = static_cast<std::uint32_t>(i);
    buffer.disc(at, radius, normal, index);
    // However small, a point is seen.
    if (buffer.holds(at.x, at.y)) {
      buffer.put(static_cast<int>(at.x), static_cast<int>(at.y), at.z, index);
    }
  }
  return Developer(splats, camera, options).develop(buffer);
}

}  // namespace deburr::view
