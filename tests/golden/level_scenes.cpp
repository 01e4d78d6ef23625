// Golden pictures of the level, and of effects on its faces.
#include "artgen/palette.h"
#include "artgen/small_level.h"
#include "client/effects/hit_marks.h"
#include "client/view/view_tint.h"
#include "golden/golden_scenes.h"
#include "golden/golden_stage.h"
#include "math/angles.h"
#include "support/models/drawable_models.h"

namespace temblor::test {
namespace {

constexpr render::Camera kPlayerStart = {.origin_world = {48, 256, 46}};
constexpr render::Camera kAboveTheCourt = {.origin_world = {800, 32, 200}, .angles_deg = {20, 45, 0}};

// A checkerboard with 8 squares per side in one color, brighter toward the lower edge and rotated within the
// picture: neighboring pictures match at their edges only if they are joined correctly.
formats::Image checkered(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  constexpr std::uint32_t kSide = 64;
  formats::Image image{kSide, kSide, {}};
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const std::uint32_t tone = 120 + y + ((x / 8 + y / 8) % 2 == 0 ? 64u : 0u);
      image.pixels.push_back(0xff000000u | (red * tone / 255) << 16 | (green * tone / 255) << 8 |
                             blue * tone / 255);
    }
  return image;
}

// A letter without symmetry in red, on yellow that is half clear.
formats::Image letter_f_image() {
  constexpr std::array<std::string_view, 7> kRows = {".....", ".###.", ".#...", ".##..",
                                                     ".#...", ".#...", "....."};
  constexpr std::uint32_t kDot = 8;
  formats::Image image{kRows[0].size() * kDot, kRows.size() * kDot, {}};
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x)
      image.pixels.push_back(kRows[y / kDot][x / kDot] == '#' ? 0xffd02010u : 0x80f0e040u);
  return image;
}

// A copy whose door, pillars, and stages are gratings.
DrawableLevel with_gratings(const DrawableLevel& drawable) {
  auto level = std::make_shared<world::Level>(*drawable.level);
  level->identity = std::make_shared<const world::LevelIdentity>();
  for (world::Texture& texture : level->textures) {
    if (texture.name != "door" && texture.name != "trim") continue;
    texture.name = "{" + texture.name;
    texture.kind = world::TextureKind::kCutout;
    for (std::uint32_t y = 0; y < texture.height; ++y)
      for (std::uint32_t x = 0; x < texture.width; ++x)
        if (x % 16 >= 5 && y % 16 >= 5)
          texture.mips[0][std::size_t{y} * texture.width + x] = artgen::kTransparent;
  }
  DrawableLevel grated = drawable;
  grated.level = level;
  return grated;
}

}  // namespace

void draw_hall(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  stage.draw(stage.scene(kPlayerStart), io_frame);
}

void draw_court(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  stage.draw(stage.scene(kAboveTheCourt), io_frame);
}

void draw_dynamic_lights(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  const render::DynamicLight lights[] = {
      {.origin_world = {120, 330, 20}, .radius = 140, .color = {1.0f, 0.35f, 0.1f}},
      {.origin_world = {370, 496, 100}, .radius = 160, .color = {0.3f, 0.5f, 1.0f}}};
  render::Scene scene = stage.scene({.origin_world = {40, 180, 90}, .angles_deg = {12, 42, 0}});
  scene.lights = lights;
  stage.draw(scene, io_frame);
}

void draw_marks(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  client::HitMarks hits;
  render::MarkSet marks;
  const auto hit = [&](render::MarkKind kind, const math::Vec3& at, float radius) {
    hits.add(stage.level(), {}, {kind, at, 8, radius, static_cast<std::uint32_t>(marks.size() + 1)}, marks);
  };
  hit(render::MarkKind::kScorch, {1404, 636, -50}, 32);
  for (int i = 0; i < 6; ++i) hit(render::MarkKind::kBulletHole, {1346 + 7 * i, 638, -80 + 23 * (i % 3)}, 4);
  hit(render::MarkKind::kSplatter, {1406, 598, -80}, 16);
  hit(render::MarkKind::kSplatter, {1406, 583, -40}, 9);
  render::Scene scene = stage.scene({.origin_world = {1332, 564, -56}, .angles_deg = {4, 45, 0}});
  scene.marks = &marks;
  stage.draw(scene, io_frame);
}

void draw_marks_on_mover(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  client::HitMarks hits;
  render::MarkSet marks;
  // All hits are on the closed door, where it was compiled.
  const math::Bounds box = artgen::small_level_door();
  const math::Vec3 middle = (box.mins + box.maxs) * 0.5f, front(box.mins.x - 1, middle.y, middle.z);
  const auto hit = [&](render::MarkKind kind, const math::Vec3& from_middle, float radius) {
    client::Hit on_door{kind, front + from_middle, 8, radius, static_cast<std::uint32_t>(marks.size() + 1)};
    if (kind == render::MarkKind::kPicture)
      on_door.picture = std::make_shared<const render::MarkPicture>(letter_f_image());
    hits.add_to_model(stage.level(), stage.door().model, on_door, marks);
  };
  hit(render::MarkKind::kPicture, {0, 26, 8}, 24);
  hit(render::MarkKind::kPicture, {0, -60, 40}, 20);
  for (int i = 0; i < 3; ++i) hit(render::MarkKind::kBulletHole, {0, -26 - 18 * (i % 2), -40 + 20 * i}, 9);
  render::BrushModelInstance door = stage.door();
  door.angles_deg = {20, 35, 15};
  const math::Basis basis = math::basis_from_angles(door.angles_deg);
  const math::Vec3d turned(basis.forward * double{middle.x} - basis.right * double{middle.y} +
                           basis.up * double{middle.z});
  door.origin_world = math::Vec3(math::Vec3d(300, 256, 80) - turned);
  render::Scene scene = stage.scene({.origin_world = {160, 256, 110}, .angles_deg = {10, 0, 0}});
  scene.brush_models = {&door, 1};
  scene.marks = &marks;
  stage.draw(scene, io_frame);
}

void draw_see_through(render::FrameBuffer& io_frame) {
  GoldenStage stage(with_gratings(small_level()));
  render::BrushModelInstance doors[] = {stage.door(), stage.door()};
  doors[0].origin_world = {400, 130, -128};
  doors[1].origin_world = {560, -120, -128};
  doors[1].alpha = 0.5f;
  const auto ball = small_model(sphere_mdl(), 64);
  const render::AliasInstance half_in_water = {.model = ball.get(), .origin_world = {1170, 230, -144}};
  render::Scene scene = stage.scene({.origin_world = {960, 180, -20}, .angles_deg = {18, 22, 0}});
  scene.brush_models = doors;
  scene.alias_models = {&half_in_water, 1};
  scene.liquid_alpha.water = 0.5f;
  stage.draw(scene, io_frame);
}

void draw_fog(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  render::Scene scene = stage.scene(kAboveTheCourt);
  scene.fog = {0.11f, {0.5f, 0.4f, 0.7f}};
  stage.draw(scene, io_frame);
}

void draw_skybox(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  render::Skybox box;
  box.sides = {checkered(255, 80, 80), checkered(80, 255, 80),   checkered(80, 80, 255),
               checkered(255, 255, 0), checkered(255, 255, 255), checkered(0, 255, 255)};
  render::Scene scene =
      stage.scene({.origin_world = {790, 20, 376}, .angles_deg = {-32, 45, 0}, .fov_deg = 110});
  scene.skybox = &box;
  stage.draw(scene, io_frame);
}

void draw_under_water(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  render::Scene scene = stage.scene({.origin_world = {1120, 100, -220}, .angles_deg = {-8, 50, 0}});
  scene.underwater = true;
  scene.tint = client::contents_tint(world::Contents::kWater);
  stage.draw(scene, io_frame);
}

}  // namespace temblor::test
