// Rays against single squares, where the result is obvious.
#include "compiler/light/rays/ray_scene.h"

#include <gtest/gtest.h>

#include <array>

#include "support/random.h"

namespace temblor::test {
namespace {

using compiler::Occluders;
using compiler::RayHit;
using compiler::RayScene;
using math::Vec3;

// A square across z, 64 units to each side of the axis.
void add_square(float z, std::uint32_t surface, Occluders& io_occluders,
                std::vector<compiler::OccluderTriangle>& io_triangles) {
  const auto first = static_cast<std::uint32_t>(io_occluders.vertices.size());
  for (const Vec3& corner : {Vec3(-64, -64, z), Vec3(64, -64, z), Vec3(64, 64, z), Vec3(-64, 64, z)})
    io_occluders.vertices.push_back(corner);
  io_triangles.push_back({{first, first + 1, first + 2}, surface});
  io_triangles.push_back({{first, first + 2, first + 3}, surface});
}

Vec3 share_towards(const RayScene& scene, const Vec3& from, const Vec3& to) {
  Vec3 share;
  scene.trace_to_point({&from, 1}, to, {&share, 1});
  return share;
}

TEST(RayScene, OpaqueSurfacesStopOnlyWhatIsBehindThem) {
  Occluders occluders;
  add_square(0, 5, occluders, occluders.opaque);
  const RayScene scene = RayScene::make(occluders).value();
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 from(random.uniform(-90, 90), random.uniform(-90, 90), 20);
    const Vec3 to(random.uniform(-90, 90), random.uniform(-90, 90), -30);
    const Vec3 at = from + (to - from) * 0.4f;
    const float outside = std::max(std::abs(at.x), std::abs(at.y)) - 64;
    if (std::abs(outside) < 0.01f) continue;
    ASSERT_EQ(share_towards(scene, from, to), Vec3(outside > 0 ? 1 : 0)) << i;
  }
}

TEST(RayScene, TextureHolesLetLightThrough) {
  // Texels are 8 units wide, and every second one is a hole.
  const std::array<std::uint8_t, 4> texels{255, 7, 7, 255};
  Occluders occluders;
  add_square(0, 0, occluders, occluders.masked);
  compiler::AlphaMask fence;
  fence.normal = Vec3(0, 0, 1);
  fence.s_axis = Vec3(0.125f, 0, 0);
  fence.t_axis = Vec3(0, 0.125f, 0);
  fence.width = fence.height = 2;
  fence.texels = texels;
  fence.transmission_by_texel.assign(256, Vec3(0));
  fence.transmission_by_texel[255] = Vec3(1);
  occluders.alpha_masks = {fence};
  const RayScene scene = RayScene::make(occluders).value();
  for (int x = -60; x < 60; x += 8)
    for (int y = -60; y < 60; y += 8) {
      const Vec3 from(static_cast<float>(x), static_cast<float>(y), 9);
      const bool hole = ((x + 64) / 8 + (y + 64) / 8) % 2 == 0;
      ASSERT_EQ(share_towards(scene, from, from - Vec3(0, 0, 20)), Vec3(hole ? 1 : 0)) << x << ' ' << y;
      ASSERT_EQ(share_towards(scene, from - Vec3(0, 0, 20), from), Vec3(hole ? 1 : 0)) << x << ' ' << y;
    }
}

TEST(RayScene, PanesDimLightOnceEach) {
  Occluders occluders;
  for (int i = 0; i < 3; ++i) {
    compiler::AlphaMask pane;
    pane.normal = Vec3(0, 0, i < 2 ? 1 : -1);
    pane.transmission = Vec3(0.5f, 0.25f, 1);
    occluders.alpha_masks.push_back(pane);
    add_square(static_cast<float>(i), static_cast<std::uint32_t>(i), occluders, occluders.masked);
  }
  const RayScene scene = RayScene::make(occluders).value();
  const Vec3 above(3, 4, 20), below(3, 4, -20);
  const Vec3 down = share_towards(scene, above, below), up = share_towards(scene, below, above);
  for (int channel = 0; channel < 3; ++channel) {
    const float one = occluders.alpha_masks[0].transmission[channel];
    EXPECT_NEAR(down[channel], one * one, 1e-3f);
    EXPECT_NEAR(up[channel], one, 1e-3f);
  }
}

TEST(RayScene, SkyIsVisibleOnlyFromItsFront) {
  Occluders occluders;
  // The situation at the end of a sky brush: two faces in one plane, back to back, with something behind
  // them.
  add_square(50, 0, occluders, occluders.skies);
  add_square(50, 1, occluders, occluders.skies);
  occluders.sky_normals = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  add_square(90, 0, occluders, occluders.opaque);
  const RayScene scene = RayScene::make(occluders).value();
  const std::array<Vec3, 3> points{Vec3(1, 2, 0), Vec3(1, 2, 60), Vec3(70, 2, 0)};
  std::array<Vec3, 3> shares;
  scene.trace_to_sky(points, Vec3(0, 0, 1), shares);
  EXPECT_EQ(shares[0], Vec3(1));
  EXPECT_EQ(shares[1], Vec3(0));
  EXPECT_EQ(shares[2], Vec3(0));
  scene.trace_to_void(points, Vec3(0, 0, 1), shares);
  EXPECT_EQ(shares[0], Vec3(0));
  EXPECT_EQ(shares[2], Vec3(1));
}

TEST(RayScene, HitsTheLowestSurfaceInOnePlane) {
  for (const bool lowest_first : {true, false}) {
    Occluders occluders;
    for (std::uint32_t i = 0; i < 9; ++i)
      add_square(0, lowest_first ? 3 + i : 11 - i, occluders, occluders.opaque);
    const RayScene scene = RayScene::make(occluders).value();
    std::vector<Vec3> points, directions;
    for (int i = 0; i < 40; ++i) {
      points.emplace_back(static_cast<float>(i), 3, 25);
      directions.emplace_back(0, 0, -1);
    }
    std::vector<RayHit> hits(points.size());
    scene.find_nearest(points, directions, 100, hits);
    for (const RayHit& hit : hits) {
      EXPECT_EQ(hit.surface, 3u);
      EXPECT_NEAR(hit.distance, 25, 1e-4f);
    }
    scene.find_nearest(points, directions, 24, hits);
    for (const RayHit& hit : hits) {
      EXPECT_EQ(hit.surface, RayHit::kNone);
      EXPECT_EQ(hit.distance, 24);
    }
  }
}

}  // namespace
}  // namespace temblor::test
