#include "compiler/light/phong.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formats/cube_room.h"

namespace temblor::test {
namespace {

// The cube room's walls all smoothed up to that angle; they meet at 90 degrees, concave.
compiler::LitLevel smooth_room(float angle_deg, float concave_deg = 0) {
  formats::Bsp bsp = make_cube_room();
  for (formats::BspFace& face : bsp.faces) face.light_offset = -1;
  compiler::FaceKeys keys;
  keys.keys.resize(1);
  keys.keys[0].phong_angle_deg = angle_deg;
  keys.keys[0].phong_angle_concave_deg = concave_deg;
  keys.of_face.assign(bsp.faces.size(), 0);
  return compiler::make_lit_level(std::move(bsp), std::move(keys)).value();
}

math::Vec3 normal_at(const compiler::LitLevel& lit, std::size_t face, const math::Vec3d& point) {
  return compiler::PhongNormals(lit).at(compiler::make_light_grid(lit, face), point);
}

void expect_near(const math::Vec3& a, const math::Vec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-3f)
      << a.x << ' ' << a.y << ' ' << a.z << " for " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Phong, CornersPointBetweenTheirFaces) {
  const compiler::LitLevel lit = smooth_room(90);
  const math::Vec3 inwards = glm::normalize(math::Vec3(-1, -1, -1));
  for (const std::size_t face : {0u, 2u, 4u}) expect_near(normal_at(lit, face, {64, 64, 64}), inwards);
}

TEST(Phong, NeighboursAgreeAlongTheirEdge) {
  const compiler::LitLevel lit = smooth_room(90);
  for (int z = -64; z <= 64; z += 8) {
    const math::Vec3d point(64, 64, z);
    expect_near(normal_at(lit, 0, point), normal_at(lit, 2, point));
  }
  expect_near(normal_at(lit, 0, {64, 64, 0}), glm::normalize(math::Vec3(-1, -1, 0)));
  // By symmetry.
  expect_near(normal_at(lit, 0, {64, 0, 0}), {-1, 0, 0});
}

TEST(Phong, SharperAnglesStayEdges) {
  for (const compiler::LitLevel& lit : {smooth_room(89), smooth_room(120, 60)}) {
    EXPECT_TRUE(compiler::PhongNormals(lit).is_curved(0));
    expect_near(normal_at(lit, 0, {64, 64, 64}), {-1, 0, 0});
  }
  EXPECT_FALSE(compiler::PhongNormals(smooth_room(0)).is_curved(0));
}

}  // namespace
}  // namespace temblor::test
