// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "deburr/error.hpp"
#include "deburr/synth.hpp"
#include "support/compare.hpp"

// Scans that have to be the same bits on every machine, and calls that are refused.

namespace deburr {
namespace {

/// First and last point of a scan.
struct Ends {
  Vec3 first, last;
};

void expect_ends(const char* name, const SyntheticScan& scan, const Ends& expected) {
  EXPECT_EQ(scan.cloud.points.front(), expected.first) << name;
  EXPECT_EQ(scan.cloud.points.back(), expected.last) << name;
}

TEST(Synthesize, HasTheSameBitsEverywhere) {
  const SynthOptions options{.points = 1000, .noise = 0.01, .seed = 42};
  expect_ends("cylinder", synthesize(Shape::Cylinder, options),
              {{0x1.167f5134d765bp-3, 0x1.1118e9049895ap-2, 0x1.2f6e34728c608p+0},
               {0x1.0907edd6d3887p-3, 0x1.ddd42bca6efbdp-2, 0x1.65be639b46aeap-1}});
  expect_ends("bumpy sheet", synthesize(Shape::BumpySheet, options),
              {{0x1.7bdfd424a99c9p-1, 0x1.e2f70027e9ea1p-2, -0x1.a87a5c50dbe4bp-6},
               {0x1.141059db0a20ap-3, 0x1.e26b948fe13a7p-1, 0x1.3fc2ba1898df2p-8}});
  expect_ends("thin plate", synthesize(Shape::ThinPlate, options),
              {{0x1.3179fbd1d05acp-1, 0x1.73ecc2cbb0adap-2, -0x1.70110d616ecc5p-7},
               {0x1.1abd8db9697b4p-1, 0x1.5b8c6e6801a22p-5, 0x1.f41f62b518ceap-5}});
}

TEST(Synthesize, HasTheSameBitsEverywhereForEverySampling) {
  SynthOptions options{.points = 1000, .noise = 0.01, .seed = 42};
  options.noise_kind = NoiseKind::Normal;
  options.sampling = Sampling::Poisson;
  expect_ends("sphere", synthesize(Shape::Sphere, options),
              {{-0x1.0275e8c89f188p-1, -0x1.c24fad58c282ap-2, 0x1.948d83e75de5cp-1},
               {-0x1.3906e5c84fcf7p-2, -0x1.0e6357f046bd2p-1, -0x1.d8eebca9e512ep-1}});
  options.noise_kind = NoiseKind::Ray;
  options.sampling = Sampling::Scanner;
  expect_ends("torus", synthesize(Shape::Torus, options),
              {{0x1.4196641f47b6bp+0, 0x1.44a084e8739bdp-1, -0x1.06377f43ec322p-3},
               {-0x1.34095d4f35ac1p+0, 0x1.048fc0e9e57fcp-1, 0x1.0746e09b7f3c1p-2}});
  options.noise_kind = NoiseKind::Impulsive;
  options.sampling = Sampling::Uniform;
  options.outliers = 0.05;
  options.cluster_outliers = 0.02;
  expect_ends("stepped wall", synthesize(Shape::SteppedWall, options),
              {{0x1.b080b5baa7bcdp-7, 0x1.8486cbb358ca2p-2, 0x1.272289e6560ebp-5},
               {0x1.5adb8796b9e5ap-6, 0x1.7e76911b30bd9p-1, 0x1.3ab714570c093p-4}});
}

TEST(Synthesize, TakesAMeshAsItTakesAShape) {
  for (const Sampling sampling : {Sampling::Uniform, Sampling::Poisson, Sampling::Scanner}) {
    const SynthOptions options{.points = 300, .sampling = sampling, .outliers = 0.1, .seed = 3};
    const SyntheticScan shape = synthesize(Shape::Part, options);
    const SyntheticScan mesh = synthesize(shape_mesh(Shape::Part), options);
    EXPECT_EQ(mesh.cloud.points, shape.cloud.points);
    EXPECT_EQ(mesh.truth.triangles, shape.truth.triangles);
    EXPECT_EQ(synthesize_part(options).cloud.points, shape.cloud.points);
  }
}

TEST(Synthesize, GrowsWithTheSurfaceWhateverItsSize) {
  for (const Sampling sampling : {Sampling::Uniform, Sampling::Poisson, Sampling::Scanner}) {
    const SynthOptions options{.points = 500, .sampling = sampling, .outliers = 0.02, .seed = 2};
    const std::vector<Vec3> expected = synthesize(Shape::Part, options).cloud.points;
    // A power of two, so that not even rounding differs.
    for (const double scale : {0x1p-20, 0x1p20}) {
      TriangleMesh mesh = shape_mesh(Shape::Part);
      for (Vec3& p : mesh.vertices) p = scale * p;
      const SyntheticScan scan = synthesize(mesh, options);
      std::vector<Vec3> back;
      for (const Vec3& p : scan.cloud.points) back.push_back((1 / scale) * p);
      EXPECT_EQ(back, expected) << scale;
    }
  }
}

TEST(Synthesize, RefusesWhatIsNoSurface) {
  const auto message = [](const TriangleMesh& mesh) {
    return invalid_argument_of([&] { (void)synthesize(mesh, {.points = 10}); });
  };
  EXPECT_EQ(message({}), "surface has no triangles");
  EXPECT_EQ(message({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}),
            "surface.triangles[0] has corner 3 of 3 vertices");
  EXPECT_EQ(message({{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}}}),
            "surface.vertices[2] is not finite");
  EXPECT_THROW((void)synthesize({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, {.points = 10}),
               DataError);
}

TEST(Synthesize, NamesTheWrongOption) {
  const auto message = [](const SynthOptions& options) {
    return invalid_argument_of([&] { (void)synthesize(Shape::Cube, options); });
  };
  EXPECT_EQ(message({.points = 0}), "synth.points must be >= 1, got 0");
  EXPECT_EQ(message({.points = std::size_t{1} << 29}),
            "synth.points must be <= 2^28, got 536870912");
  EXPECT_EQ(message({.points = 1, .noise = -1, .noise_unit = NoiseUnit::Spacing}),
            "synth.noise must be finite and >= 0, got -1");
  EXPECT_EQ(message({.points = 1, .shape = {.thickness = 2}}),
            "shape.thickness must be in (0, 1), got 2");
  EXPECT_EQ(message({.points = 1, .noise_kind = static_cast<NoiseKind>(9)}),
            "synth.noise_kind must be a NoiseKind, got 9");
  EXPECT_EQ(message({.points = 1, .sampling = static_cast<Sampling>(9)}),
            "synth.sampling must be a Sampling, got 9");
  EXPECT_EQ(invalid_argument_of([] { (void)shape_mesh(static_cast<Shape>(9)); }),
            "shape must be a Shape, got 9");
}

}  // namespace
}  // namespace deburr
