// Vertices of models: every instruction set against the scalar reference, and that against double arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "render/alias/vertex_kernels.h"
#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

constexpr std::size_t kCount = 64;

// Positions have all bits of an element; normals are below 256.
template <typename Element>
struct RandomVertices {
  explicit RandomVertices(std::uint64_t seed) : elements(8 * kCount), lights(256) {
    Random random(seed);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const bool is_normal = i / kCount % 4 == 3;
      elements[i] =
          static_cast<Element>(random.below(is_normal ? 256 : std::numeric_limits<Element>::max() + 1));
    }
    constexpr double kSteps = (std::numeric_limits<Element>::max() + 1) / 256;
    for (float& light : lights) light = static_cast<float>(random.uniform(0, 16320));
    for (int row = 0; row < 4; ++row) {
      job.from[row] = &elements[static_cast<std::size_t>(row) * kCount];
      job.to[row] = &elements[static_cast<std::size_t>(row + 4) * kCount];
    }
    job.blend = random.chance(0.3) ? 0.0f : static_cast<float>(random.uniform(0, 1));
    job.count = kCount;
    for (auto& row : job.to_view)
      for (int column = 0; column < 3; ++column)
        row[column] = static_cast<float>(random.uniform(-1, 1) / kSteps);
    job.to_view[0][3] = static_cast<float>(random.uniform(-300, 300));
    job.to_view[1][3] = static_cast<float>(random.uniform(-300, 300));
    // Some behind the eye.
    job.to_view[2][3] = static_cast<float>(random.uniform(-100, 1000));
    job.center_x = 319.5f;
    job.center_y = 199.5f;
    job.pixels_per_unit = static_cast<float>(random.log_uniform(1, 5000));
    job.perspective = random.chance(0.8);
    job.near_z = 1.0f / 16;
    job.depth_scale = random.chance(0.5) ? 1.0f : 4096.0f;
    job.steps_per_pixel = random.chance(0.3) ? 1 : render::kSubpixels;
    job.lights = lights.data();
  }

  std::vector<Element> elements;
  std::vector<float> lights;
  render::PoseJob<Element> job{};
};

struct Projected {
  std::vector<render::ScreenVertex> vertices = std::vector<render::ScreenVertex>(kCount);
  std::vector<float> view[3] = {std::vector<float>(kCount), std::vector<float>(kCount),
                                std::vector<float>(kCount)};
};

template <typename Element>
Projected project(render::PoseJob<Element> job, bool simd) {
  Projected projected;
  job.out = projected.vertices.data();
  for (std::size_t axis = 0; axis < 3; ++axis) job.view[axis] = projected.view[axis].data();
  simd ? render::project_vertices_simd(job) : render::project_vertices_scalar(job);
  return projected;
}

template <typename Element>
void expect_simd_matches() {
  for_each_simd_target([] {
    for (int seed = 0; seed < effort(300, 30); ++seed) {
      const RandomVertices<Element> random(static_cast<std::uint64_t>(seed));
      const Projected expected = project(random.job, false);
      const Projected drawn = project(random.job, true);
      ASSERT_EQ(
          std::memcmp(expected.vertices.data(), drawn.vertices.data(), kCount * sizeof(render::ScreenVertex)),
          0)
          << "seed " << seed;
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_EQ(expected.view[axis], drawn.view[axis]) << "seed " << seed;
    }
  });
}

TEST(AliasVertices, SimdMatchesTheScalarReference) {
  expect_simd_matches<std::uint8_t>();
  expect_simd_matches<std::uint16_t>();
}

template <typename Element>
void expect_double_arithmetic() {
  for (int seed = 0; seed < effort(300, 30); ++seed) {
    const RandomVertices<Element> random(static_cast<std::uint64_t>(seed));
    const render::PoseJob<Element>& job = random.job;
    const Projected projected = project(job, false);
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto blended = [&](int row) {
        return job.from[row][i] + (double{1} * job.to[row][i] - job.from[row][i]) * double{job.blend};
      };
      double view[3];
      for (int axis = 0; axis < 3; ++axis) {
        const float* row = job.to_view[axis];
        view[axis] = double{row[0]} * blended(0) + double{row[1]} * blended(1) + double{row[2]} * blended(2) +
                     double{row[3]};
        ASSERT_NEAR(projected.view[axis][i], view[axis], 3e-4) << "seed " << seed;
      }
      if (job.perspective && view[2] < 1) continue;
      const double scale = job.perspective ? job.pixels_per_unit / view[2] : double{job.pixels_per_unit};
      const double x = job.center_x + view[0] * scale, y = job.center_y - view[1] * scale;
      if (std::max(std::abs(x), std::abs(y)) > 20000) continue;
      // Half a step, plus the rounding of floats for coordinates so far out or so near.
      const double error = 0.5 / job.steps_per_pixel + 1e-6 * (std::abs(x) + std::abs(y)) +
                           3e-4 * scale * (1 + (std::abs(view[0]) + std::abs(view[1])) / std::abs(view[2]));
      const render::ScreenVertex& vertex = projected.vertices[i];
      ASSERT_NEAR(vertex.x / 256.0, x, error) << "seed " << seed;
      ASSERT_NEAR(vertex.y / 256.0, y, error) << "seed " << seed;
      const double depth = job.perspective ? job.depth_scale / view[2] : -view[2];
      ASSERT_NEAR(vertex.depth, depth, 4e-4 * std::abs(depth) + 3e-4) << "seed " << seed;
    }
  }
}

TEST(AliasVertices, LieWhereDoubleArithmeticPutsThem) {
  expect_double_arithmetic<std::uint8_t>();
  expect_double_arithmetic<std::uint16_t>();
}

}  // namespace
}  // namespace temblor::test
