// Phong shading of the world: its kernels against each other and against the definition, lamps and normals of
// levels, and pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "lab/lit_pictures.h"
#include "lab/world_light/kernels/phong_kernels.h"
#include "lab/world_light/lamps/lamp_stages.h"
#include "render/kernel_cases.h"
#include "render/simd_targets.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

constexpr auto kPhong = {"phong", "phong:smooth=60", "phong:lights=1"};

// A white wall across the view, as one texel.
template <typename Texel>
struct LampCase {
  std::vector<render::Span> spans;
  std::vector<Texel> texels;
  std::vector<std::uint8_t> colormap;
  std::vector<lab::PointLamp> lamps;
  std::vector<lab::PhongPart> parts;
  lab::LitSpans job{};
  lab::PhongLights lights{};

  explicit LampCase(Random& random) : spans(random_spans(random)) {
    texels = make_texels<Texel>(1 + lab::kMarginColumns, 1 + lab::kMarginRows,
                                [](int, int) { return static_cast<Texel>(0xffffffffu); });
    // The row of the colormap itself.
    for (int i = 0; i < 64 * 256; ++i) colormap.push_back(static_cast<std::uint8_t>(i / 256));
    job.perspective = true;
    job.depth = plane_through(random_depth(random, false));
    job.texture = {texels.data(), 1, 1};
    job.colormap = colormap.data();
    job.spans = spans.data();
    job.span_count = spans.size();
    const std::size_t count = random.below(20);
    for (std::size_t i = 0; i < count; ++i) {
      const math::Vec3 at = random.in_cube(500);
      const double brightness = random.uniform(0, 300) * 256;
      const double falloff = random.uniform(0.1, 2) * 256;
      lab::PointLamp lamp{{at.x, at.y, at.z}, 0, 0, 0, 0};
      if (random.chance(0.5)) {
        lamp.brightness = static_cast<float>(brightness);
        lamp.falloff = static_cast<float>(falloff);
      } else {
        lamp.inverse = static_cast<float>(falloff * 100);
        lamp.inverse_square = static_cast<float>(brightness * 1000);
      }
      if (random.chance(0.3)) {
        const math::Vec3 direction = glm::normalize(random.in_cube(1));
        for (int axis = 0; axis < 3; ++axis) lamp.spot[axis] = direction[axis];
        lamp.spot_cosine = static_cast<float>(random.uniform(-1, 1));
      }
      lamps.push_back(lamp);
    }
    const math::Vec3 step = random.in_cube(0.01);
    for (int axis = 0; axis < 3; ++axis) lights.ray_step[axis] = step[axis];
    for (const render::Span& span : spans) {
      lab::PhongPart part{};
      const math::Vec3 ray = random.in_cube(1), normal = random.in_cube(1), turn = random.in_cube(0.01);
      for (int axis = 0; axis < 3; ++axis) {
        part.ray[axis] = ray[axis];
        part.normal[axis] = normal[axis];
        part.normal_step[axis] = turn[axis];
      }
      part.pixels_before = static_cast<std::int32_t>(random.below(std::size_t{span.x} + 1));
      parts.push_back(part);
    }
    lights.parts = parts.data();
    lights.lamps = lamps.data();
    lights.lamp_count = static_cast<std::int32_t>(lamps.size());
  }
  LampCase(const LampCase&) = delete;
  LampCase& operator=(const LampCase&) = delete;

  // The sum of light at pixel i of a span, by the definition. Nothing on the edge of a spotlight's cone.
  std::optional<double> sum_light(std::size_t span, int i) const {
    const lab::PhongPart& part = parts[span];
    const double lane = part.pixels_before + i;
    const double z = 1 / (value_at(job.depth, spans[span].x + i, spans[span].y));
    math::Vec3d at, normal;
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = (part.ray[axis] + lane * lights.ray_step[axis]) * z;
      normal[axis] = part.normal[axis] + lane * part.normal_step[axis];
    }
    double sum = 0;
    for (const lab::PointLamp& lamp : lamps) {
      const math::Vec3d to_lamp = math::Vec3d(lamp.from_eye[0], lamp.from_eye[1], lamp.from_eye[2]) - at;
      const double cosine = glm::dot(glm::normalize(to_lamp), glm::normalize(normal));
      const double d = std::max(glm::length(to_lamp), 1.0);
      const double light = std::max(0.0, lamp.brightness - lamp.falloff * d) + lamp.inverse / d +
                           lamp.inverse_square / (d * d);
      const math::Vec3d spot(lamp.spot[0], lamp.spot[1], lamp.spot[2]);
      const double in_cone = glm::dot(spot, -to_lamp) / d - double{lamp.spot_cosine};
      if (std::abs(in_cone) < 1e-3) return std::nullopt;
      if (in_cone > 0) sum += light * (0.5 + 0.5 * cosine);
    }
    return std::min(sum, 65280.0);
  }
};

TEST(PhongKernels, SimdEqualsScalar) {
  for (int seed = 0; seed < effort(2000, 60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const LampCase<std::uint8_t> indexed(random);
    const LampCase<std::uint32_t> rgb(random);
    Canvas<std::uint8_t> plain_indexed;
    Canvas<std::uint32_t> plain_rgb;
    lab::draw_phong_lit_u8_scalar(indexed.job, indexed.lights, plain_indexed.target());
    lab::draw_phong_lit_u32_scalar(rgb.job, rgb.lights, plain_rgb.target());
    for_each_simd_target([&] {
      Canvas<std::uint8_t> vector_indexed;
      Canvas<std::uint32_t> vector_rgb;
      lab::draw_phong_lit_u8_simd(indexed.job, indexed.lights, vector_indexed.target());
      lab::draw_phong_lit_u32_simd(rgb.job, rgb.lights, vector_rgb.target());
      ASSERT_TRUE(plain_indexed == vector_indexed);
      ASSERT_TRUE(plain_rgb == vector_rgb);
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(PhongKernels, FollowTheDefinition) {
  int lit = 0;
  for (int seed = 0; seed < effort(500, 30); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const LampCase<std::uint8_t> lamps(random);
    Canvas<std::uint8_t> canvas;
    lab::draw_phong_lit_u8_scalar(lamps.job, lamps.lights, canvas.target());
    for (std::size_t span = 0; span < lamps.spans.size(); ++span)
      for (int i = 0; i < lamps.spans[span].count; ++i) {
        const std::optional<double> defined = lamps.sum_light(span, i);
        if (!defined) continue;
        const double sum = *defined;
        const double row = std::max((65280 - sum) / 4, 64.0) / 256;
        const int drawn = canvas.pixels[canvas.position(lamps.spans[span], i)];
        ASSERT_LE(std::abs(drawn - std::floor(row)), 1) << sum;
        lit += sum > 1000;
      }
  }
  EXPECT_GT(lit, 1000);
}

// The lights of a level, and one that is no light.
TEST(LevelLamps, AreTheLevelsLightEntities) {
  world::Level level = *small_level().level;
  level.entities = {{{{"classname", "light"}, {"origin", "1 2 3"}}},
                    {{{"classname", "light_torch_small_walltorch"},
                      {"origin", "4 5 6"},
                      {"light", "200"},
                      {"wait", "2"},
                      {"style", "5"}}},
                    {{{"classname", "light"}, {"light", "200"}}},
                    {{{"classname", "light"}, {"origin", "4 5 6"}, {"light", "-1"}}},
                    {{{"classname", "info_player_start"}, {"origin", "7 8 9"}}}};
  const std::vector<lab::Lamp> lamps = lab::find_lamps(level);
  ASSERT_EQ(lamps.size(), 2u);
  EXPECT_EQ(lamps[0].origin_world, math::Vec3d(1, 2, 3));
  EXPECT_EQ(lamps[0].light, 300);
  EXPECT_EQ(lamps[1].light, 200);
  EXPECT_EQ(lamps[1].falloff, 2);
  EXPECT_EQ(lamps[1].style, 5);
  EXPECT_EQ(lamps[1].light_at(60), 80);
  EXPECT_EQ(lamps[1].light_at(200), 0);
  level.entities = {
      {{{"classname", "light"}, {"origin", "1 2 3"}, {"light", "40"}, {"delay", "1"}}},
      {{{"classname", "light"}, {"origin", "1 2 3"}, {"light", "40"}, {"delay", "2"}, {"wait", "2"}}}};
  EXPECT_EQ(lab::find_lamps(level)[0].light_at(256), 20);
  EXPECT_EQ(lab::find_lamps(level)[1].light_at(128), 10);
  level.entities = {
      {{{"classname", "light_spot"}, {"origin", "1 2 3"}, {"target", "floor"}, {"angle", "90"}}},
      {{{"classname", "info_null"}, {"targetname", "floor"}, {"origin", "1 2 -97"}}},
      {{{"classname", "light"}, {"origin", "1 2 3"}, {"mangle", "90 0 0"}}}};
  const std::vector<lab::Lamp> spots = lab::find_lamps(level);
  ASSERT_EQ(spots.size(), 2u);
  EXPECT_EQ(spots[0].spot, math::Vec3d(0, 0, -1));
  EXPECT_NEAR(spots[0].spot_cosine, std::sqrt(0.5), 1e-9);
  EXPECT_LT(glm::distance(spots[1].spot, math::Vec3d(0, 1, 0)), 1e-9);
  EXPECT_NEAR(spots[1].spot_cosine, std::cos(20 * std::numbers::pi / 180), 1e-9);
  level.entities.clear();
  const base::Status status = lab::check_lamps({}, level);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, base::ErrorCode::kUnsupported);  // exit status 1
  EXPECT_TRUE(lab::check_lamps({}, *small_level().level).ok());
}

// A square wall of 256 units has four lamps, each in the middle of a quarter, as far in front as asked.
TEST(LevelLamps, LieOnASurfaceInSquares) {
  world::Level level;
  level.planes = {{{1, 0, 0}, 64, 0}};
  // Clockwise, seen from the front.
  level.vertices = {{64, 0, 0}, {64, 0, 256}, {64, 256, 256}, {64, 256, 0}};
  level.edges = {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
  level.surfedges = {0, 1, 2, 3};
  level.texture_axes.resize(1);
  level.textures.resize(1);
  level.textures[0].name = "lamp";
  world::Face face{};
  face.surfedge_count = 4;
  level.faces = {face};
  world::Model world{};
  world.face_count = 1;
  level.models = {world};
  level.entities = {{{{"classname", "light"}, {"_surface", "LAMP"}, {"_surface_offset", "5"}}}};
  std::vector<lab::Lamp> lamps = lab::find_shadowed_lamps(level);
  ASSERT_EQ(lamps.size(), 4u);
  std::ranges::sort(lamps, {},
                    [](const lab::Lamp& lamp) { return lamp.origin_world.y + 2 * lamp.origin_world.z; });
  const math::Vec3d middles[] = {{69, 64, 64}, {69, 192, 64}, {69, 64, 192}, {69, 192, 192}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(glm::distance(lamps[i].origin_world, middles[i]), 1e-6) << i;
}

// A sun shines down to the south; a dome has 17 parts; a surface light has a lamp on each square of 128
// units.
TEST(LevelLamps, AreSunsAndGlowingSurfaces) {
  world::Level level = *small_level().level;
  level.entities = {{{{"classname", "worldspawn"},
                      {"_sunlight", "200"},
                      {"_sun_mangle", "270 -45 0"},
                      {"_sunlight2", "34"},
                      {"_minlight", "12"}}}};
  const std::vector<lab::Lamp> sky = lab::find_shadowed_lamps(level);
  ASSERT_EQ(sky.size(), 18u);
  EXPECT_TRUE(sky[0].is_sky);
  EXPECT_EQ(sky[0].light_at(1e6), 200);
  EXPECT_LT(glm::distance(glm::normalize(sky[0].origin_world), glm::normalize(math::Vec3d(0, 1, 1))), 1e-9);
  for (std::size_t i = 1; i < sky.size(); ++i) {
    EXPECT_EQ(sky[i].light, 2);
    EXPECT_GT(sky[i].origin_world.z, 0);
  }
  EXPECT_EQ(lab::find_min_light(level), 12);

  const world::Face* widest = &level.faces[0];
  for (const world::Face& face : level.faces)
    if (face.texture_extents[0] * face.texture_extents[1] >
        widest->texture_extents[0] * widest->texture_extents[1])
      widest = &face;
  const std::string& texture = level.texture(widest->texture).name;
  level.entities = {{{{"classname", "light"}, {"origin", "1 2 3"}, {"_surface", texture}, {"light", "50"}}}};
  EXPECT_TRUE(lab::find_lamps(level).empty());
  const std::vector<lab::Lamp> glowing = lab::find_shadowed_lamps(level);
  EXPECT_GT(glowing.size(), 4u);
  std::size_t on_widest = 0;
  const render::FacePlane plane = render::place_plane(level, *widest, {});
  for (const lab::Lamp& lamp : glowing) {
    EXPECT_EQ(lamp.light, 50);
    EXPECT_FALSE(lamp.is_sky);
    EXPECT_NEAR(lamp.spot_cosine, 0, 1e-9);  // the half space in front of the face
    on_widest += glm::distance(lamp.spot, plane.normal) < 1e-9 &&
                 std::abs(glm::dot(plane.normal, lamp.origin_world) - plane.distance - 2) < 1e-6;
  }
  EXPECT_GT(on_widest, 1u);
}

TEST(LevelLamps, OfHugeSurfacesAreBounded) {
  world::Level level = *small_level().level;
  for (math::Vec3& vertex : level.vertices) vertex *= 1e4f;
  level.entities.clear();
  for (const world::Texture& texture : level.textures)
    level.entities.push_back({{{"classname", "light"}, {"origin", "1 2 3"}, {"_surface", texture.name}}});
  EXPECT_EQ(lab::find_shadowed_lamps(level).size(), lab::kMaxShadowedLamps);
  const base::Status status = lab::parse_choice("ray-light").value().check_level(level);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, base::ErrorCode::kTooLarge);
}

TEST(LevelLamps, ShineOnTheFacesInFrontOfThem) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  const lab::LevelLamps lamps(level, lab::find_lamps(level), 3, 0);
  std::size_t lit = 0;
  for (std::size_t i = 0; i < level.faces.size(); ++i) {
    const render::FacePlane plane = render::place_plane(level, level.faces[i], {});
    const auto numbers = lamps.lamps_on(base::to_index<world::FaceIndex>(i));
    EXPECT_LE(numbers.size(), 3u);
    lit += !numbers.empty();
    for (const std::uint32_t number : numbers)
      EXPECT_GT(glm::dot(plane.normal, lamps.all()[number].origin_world), plane.distance);
    for (const math::Vec3d& normal : lamps.normals(level.faces[i]))
      EXPECT_LT(glm::distance(glm::normalize(normal), plane.normal), 1e-9);
  }
  EXPECT_GT(lit, level.faces.size() / 4);
}

// All planes of the small level are axial: at 60 degrees, only coplanar faces share normals, and at 100, the
// walls of a corner do.
TEST(LevelLamps, AverageNormalsUpToAnAngle) {
  const world::Level& level = *small_level().level;
  const auto count_slanted = [&](double degrees) {
    const lab::LevelLamps lamps(level, lab::find_lamps(level), 1, degrees);
    std::size_t slanted = 0;
    for (const world::Face& face : level.faces)
      for (const math::Vec3d& normal : lamps.normals(face)) {
        const math::Vec3d unit = glm::normalize(normal);
        slanted += std::max({std::abs(unit.x), std::abs(unit.y), std::abs(unit.z)}) < 0.999;
      }
    return slanted;
  };
  EXPECT_EQ(count_slanted(60), 0u);
  EXPECT_GT(count_slanted(100), 100u);
}

TEST(Phong, IsTheSameForAnyThreadsAndBands) {
  for (const char* const technique : kPhong) expect_same_for_any_threads(technique);
}

// A level without lights is drawn by the engine, and lamps follow the level.
TEST(Phong, LeavesLevelsWithoutLightsToTheEngine) {
  DrawableLevel drawable = small_level();
  auto dark = std::make_shared<world::Level>(*drawable.level);
  dark->identity = std::make_shared<const world::LevelIdentity>();
  dark->entities.clear();
  Random random(5);
  const Viewpoint view = make_lit_view(*dark, PixelFormat::kRgb, random);
  LitPictures phong(drawable, "phong", PixelFormat::kRgb), engine(drawable, nullptr, PixelFormat::kRgb);
  const FrameCopy lit = phong.draw(view.scene(*drawable.level), {});
  const FrameCopy right = engine.draw(view.scene(*drawable.level), {});
  EXPECT_GT(differing_pixels(lit, right), 1000u);
  EXPECT_EQ(phong.draw(view.scene(*dark), {}), engine.draw(view.scene(*dark), {}));
  EXPECT_EQ(phong.draw(view.scene(*drawable.level), {}), lit);
}

TEST(Phong, AllocatesNothingInAWarmFrame) {
  for (const char* const technique : kPhong) expect_no_allocations_in_a_warm_frame(technique);
}

}  // namespace
}  // namespace temblor::test
