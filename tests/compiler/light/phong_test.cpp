#include "compiler/light/faces/phong.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/light/lighting.h"

namespace temblor::test {
namespace {

// The normals of the walls at x, y and z 64.
constexpr math::Vec3d kWallX(-1, 0, 0), kWallY(0, -1, 0), kWallZ(0, 0, -1);

// The room's walls, which meet at concave right angles, with these keys of worldspawn.
compiler::LitLevel smooth_room(const std::string& keys) {
  formats::Bsp bsp = room_with({"", keys});
  compiler::FaceKeys face_keys = compiler::find_face_keys(bsp, formats::read_entities(bsp.entities).value());
  return compiler::make_lit_level(std::move(bsp), std::move(face_keys)).value();
}

std::size_t face_with(const compiler::LitLevel& lit, const math::Vec3d& normal) {
  const auto& faces = lit.level->faces;
  const auto found = std::ranges::find_if(faces, [&](const world::Face& face) {
    return world::compute_face_plane(*lit.level, face).normal == normal;
  });
  CHECK(found != faces.end());
  return static_cast<std::size_t>(found - faces.begin());
}

math::Vec3 normal_at(const compiler::LitLevel& lit, const math::Vec3d& wall, const math::Vec3d& point) {
  return compiler::PhongNormals(lit).at(compiler::make_light_grid(lit, face_with(lit, wall)), point);
}

void expect_normal(const math::Vec3& a, const math::Vec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-3f)
      << a.x << ' ' << a.y << ' ' << a.z << " for " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Phong, CornersPointBetweenTheirFaces) {
  const compiler::LitLevel lit = smooth_room("'_phong_angle' '90'");
  const math::Vec3 inward = glm::normalize(math::Vec3(-1, -1, -1));
  for (const math::Vec3d& wall : {kWallX, kWallY, kWallZ})
    expect_normal(normal_at(lit, wall, {64, 64, 64}), inward);
}

TEST(Phong, NeighborsAgreeAlongTheirEdge) {
  const compiler::LitLevel lit = smooth_room("'_phong_angle' '90'");
  for (int z = -64; z <= 64; z += 8) {
    const math::Vec3d point(64, 64, z);
    expect_normal(normal_at(lit, kWallX, point), normal_at(lit, kWallY, point));
  }
  expect_normal(normal_at(lit, kWallX, {64, 64, 0}), glm::normalize(math::Vec3(-1, -1, 0)));
  // By symmetry.
  expect_normal(normal_at(lit, kWallX, {64, 0, 0}), {-1, 0, 0});
}

TEST(Phong, SharpAnglesStayEdges) {
  for (const compiler::LitLevel& lit : {smooth_room("'_phong_angle' '89'"),
                                        smooth_room("'_phong_angle' '120' '_phong_angle_concave' '60'")}) {
    EXPECT_TRUE(compiler::PhongNormals(lit).is_curved(face_with(lit, kWallX)));
    expect_normal(normal_at(lit, kWallX, {64, 64, 64}), {-1, 0, 0});
  }
  const compiler::LitLevel flat = smooth_room("");
  EXPECT_FALSE(compiler::PhongNormals(flat).is_curved(face_with(flat, kWallX)));
}

}  // namespace
}  // namespace temblor::test
