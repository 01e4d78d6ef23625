// Light by rays: lines against every face of a level, and pictures against Phong shading, which has no
// shadows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/lit_pictures.h"
#include "lab/world_light/lamps/lamp_stages.h"
#include "lab/world_light/rays/shadow_rays.h"
#include "render/view/model_view.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

enum class Crossing { kNo, kNearEdge, kYes };

// Whether a line crosses a face, by the definition.
Crossing find_crossing(const world::Level& level, const world::Face& face, const math::Vec3d& from,
                       const math::Vec3d& to) {
  constexpr double kNear_units = 0.01;
  const render::FacePlane plane = render::place_plane(level, face, {});
  const double before = glm::dot(plane.normal, from) - plane.distance;
  const double after = glm::dot(plane.normal, to) - plane.distance;
  const bool is_near = std::min(std::abs(before), std::abs(after)) < kNear_units;
  if (before * after > 0 && !is_near) return Crossing::kNo;
  const math::Vec3d at = from + (to - from) * (before / (before - after));
  double inside = 1e9;  // the distance from the nearest edge
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3d a(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    const math::Vec3d b(
        level.vertices[level.surfedge_start(face.first_surfedge + (i + 1) % face.surfedge_count)]);
    // Clockwise, so the inside is to the right.
    inside = std::min(inside, glm::dot(glm::normalize(glm::cross(plane.normal, a - b)), at - a));
  }
  if (inside < -kNear_units) return Crossing::kNo;
  return is_near || inside < kNear_units ? Crossing::kNearEdge : Crossing::kYes;
}

Crossing find_crossing(const world::Level& level, const math::Vec3d& from, const math::Vec3d& to) {
  Crossing found = Crossing::kNo;
  const world::Model& world = level.models.front();
  for (std::uint32_t i = world.first_face; i < world.first_face + world.face_count; ++i) {
    const world::Face& face = level.faces[i];
    if (face.kind == world::FaceKind::kSky || face.kind == world::FaceKind::kLiquid) continue;
    if (level.textures[base::to_size(face.texture)].name.starts_with('{')) continue;
    found = std::max(found, find_crossing(level, face, from, to));
  }
  return found;
}

TEST(ShadowRays, MeetTheFacesThatLinesCross) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  const lab::ShadowRays rays = lab::ShadowRays::make(level).value();
  int blocked = 0, open = 0;
  for (int seed = 0; seed < effort(200, 20); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const math::Vec3 lamp = random_camera(level, random).origin_world;
    lab::PointPacket points;
    std::array<math::Vec3, lab::kRaysPerPacket> from;
    for (std::size_t i = 0; i < lab::kRaysPerPacket; ++i) {
      const math::Vec3 near = random.in_cube(200);
      from[i] = i % 2 == 0 ? lamp + near : random_camera(level, random).origin_world;
      for (int axis = 0; axis < 3; ++axis) points[static_cast<std::size_t>(axis)][i] = from[i][axis];
    }
    const std::uint32_t wanted = 0xefff;
    const std::uint32_t lit = rays.find_lit(points, wanted, lamp);
    EXPECT_EQ(lit & ~wanted, 0u);
    for (std::size_t i = 0; i < lab::kRaysPerPacket; ++i) {
      const Crossing crossing = find_crossing(level, math::Vec3d(from[i]), math::Vec3d(lamp));
      if ((wanted >> i & 1) == 0 || crossing == Crossing::kNearEdge) continue;
      EXPECT_EQ(lit >> i & 1, crossing == Crossing::kNo ? 1u : 0u) << "seed " << seed << ", ray " << i;
      (crossing == Crossing::kNo ? open : blocked)++;
    }
  }
  EXPECT_GT(blocked, effort(300, 30));
  EXPECT_GT(open, effort(300, 30));
}

// The first face on a line: sky, something else, or nothing. Unknown near an edge of any face before it.
enum class FirstFace { kSky, kOther, kNone, kUnknown };

FirstFace find_first_face(const world::Level& level, const math::Vec3d& from, const math::Vec3d& direction) {
  constexpr double kFar = 1e4;
  double nearest = kFar;
  FirstFace first = FirstFace::kNone;
  const world::Model& world = level.models.front();
  for (std::uint32_t i = world.first_face; i < world.first_face + world.face_count; ++i) {
    const world::Face& face = level.faces[i];
    if (face.kind == world::FaceKind::kLiquid) continue;
    if (level.textures[base::to_size(face.texture)].name.starts_with('{')) continue;
    const Crossing crossing = find_crossing(level, face, from, from + direction * kFar);
    if (crossing == Crossing::kNo) continue;
    const render::FacePlane plane = render::place_plane(level, face, {});
    const double distance =
        (plane.distance - glm::dot(plane.normal, from)) / glm::dot(plane.normal, direction);
    if (distance >= nearest) continue;
    nearest = distance;
    first = crossing == Crossing::kNearEdge      ? FirstFace::kUnknown
            : face.kind == world::FaceKind::kSky ? FirstFace::kSky
                                                 : FirstFace::kOther;
  }
  return first;
}

TEST(ShadowRays, FindTheSky) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  const lab::ShadowRays rays = lab::ShadowRays::make(level).value();
  int under_sky = 0, elsewhere = 0;
  for (int seed = 0; seed < effort(300, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    math::Vec3 toward_sky = glm::normalize(random.in_cube(1));
    if (seed % 2 == 0) toward_sky.z = std::abs(toward_sky.z);
    lab::PointPacket points;
    std::array<math::Vec3, lab::kRaysPerPacket> from;
    for (std::size_t i = 0; i < lab::kRaysPerPacket; ++i) {
      from[i] = random_camera(level, random).origin_world;
      for (int axis = 0; axis < 3; ++axis) points[static_cast<std::size_t>(axis)][i] = from[i][axis];
    }
    const std::uint32_t lit = rays.find_under_sky(points, 0xefff, toward_sky);
    EXPECT_EQ(lit & ~0xefffu, 0u);
    for (std::size_t i = 0; i < lab::kRaysPerPacket; ++i) {
      const FirstFace first = find_first_face(level, math::Vec3d(from[i]), math::Vec3d(toward_sky));
      if ((0xefff >> i & 1) == 0 || first == FirstFace::kUnknown) continue;
      EXPECT_EQ(lit >> i & 1, first == FirstFace::kSky ? 1u : 0u) << "seed " << seed << ", ray " << i;
      (first == FirstFace::kSky ? under_sky : elsewhere)++;
    }
  }
  EXPECT_GT(under_sky, effort(100, 20));
  EXPECT_GT(elsewhere, effort(300, 60));
}

// Shadows only take light away, and much of the level is in some.
TEST(RayLight, IsPhongShadingWithShadows) {
  const DrawableLevel drawable = small_level();
  std::size_t darker = 0, equal = 0;
  for (int seed = 0; seed < effort(20, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Viewpoint view = make_lit_view(*drawable.level, PixelFormat::kRgb, random);
    view.brush_models.clear();  // liquids of models do not show how they are lit
    LitPictures phong(drawable, "phong:lights=64", PixelFormat::kRgb),
        rays(drawable, "ray-light:lights=64", PixelFormat::kRgb);
    const FrameCopy without = phong.draw(view.scene(*drawable.level), {});
    const FrameCopy with = rays.draw(view.scene(*drawable.level), {});
    ASSERT_EQ(without.rgb.size(), with.rgb.size());
    for (std::size_t i = 0; i < with.rgb.size(); ++i)
      for (int shift = 0; shift < 24; shift += 8) {
        const auto bright = static_cast<int>(without.rgb[i] >> shift & 255);
        const auto dark = static_cast<int>(with.rgb[i] >> shift & 255);
        ASSERT_LE(dark, bright + 1) << "seed " << seed << ", pixel " << i;
        darker += dark + 8 < bright;
        equal += std::abs(dark - bright) <= 1;
      }
  }
  EXPECT_GT(darker, static_cast<std::size_t>(effort(20, 3)) * 1000);
  EXPECT_GT(equal, static_cast<std::size_t>(effort(20, 3)) * 1000);
}

TEST(RayLight, IsTheSameForAnyThreadsAndBands) {
  expect_same_for_any_threads("ray-light");
}

TEST(RayLight, AllocatesNothingInAWarmFrame) {
  expect_no_allocations_in_a_warm_frame("ray-light");
}

// The minimum is everywhere, and a sun adds light under the sky.
TEST(RayLight, ShowsSunsAndTheMinimum) {
  const DrawableLevel drawable = small_level();
  Random random(9);
  const auto draw_mean = [&](std::vector<formats::Entity> entities) {
    world::Level level = *drawable.level;
    level.identity = std::make_shared<const world::LevelIdentity>();
    level.entities = std::move(entities);
    EXPECT_TRUE(lab::parse_choice("ray-light").value().check_level(level).ok());
    LitPictures rays(drawable, "ray-light", PixelFormat::kRgb);
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      Random camera(seed);
      Viewpoint view = make_lit_view(level, PixelFormat::kRgb, camera);
      view.lights.clear();
      for (const std::uint32_t pixel : rays.draw(view.scene(level), {}).rgb) sum += pixel >> 8 & 255;
    }
    return sum;
  };
  const formats::Entity lamp{{{"classname", "light"}, {"origin", "0 0 0"}, {"light", "1"}}};
  const auto make_world = [](const char* key, const char* value) {
    return formats::Entity{{{"classname", "worldspawn"}, {key, value}}};
  };
  const double dark = draw_mean({lamp}), even = draw_mean({lamp, make_world("_minlight", "80")}),
               sunny = draw_mean({make_world("_sunlight", "300")});
  EXPECT_GT(even, dark * 1.5);
  EXPECT_GT(sunny, dark * 1.02);
}

TEST(RayLight, LeavesLevelsWithoutLightsToTheEngine) {
  const DrawableLevel drawable = small_level();
  world::Level dark = *drawable.level;
  dark.identity = std::make_shared<const world::LevelIdentity>();
  dark.entities.clear();
  EXPECT_FALSE(lab::parse_choice("ray-light").value().check_level(dark).ok());
  Random random(5);
  const Viewpoint view = make_lit_view(dark, PixelFormat::kRgb, random);
  LitPictures rays(drawable, "ray-light", PixelFormat::kRgb), engine(drawable, nullptr, PixelFormat::kRgb);
  EXPECT_EQ(rays.draw(view.scene(dark), {}), engine.draw(view.scene(dark), {}));
}

}  // namespace
}  // namespace temblor::test
