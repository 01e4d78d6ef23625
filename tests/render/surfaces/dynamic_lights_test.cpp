// Dynamic lights: their values at light samples against the definition in double precision, and their effect
// on pictures: only where they should have one, and none after they are gone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/edges/face_outlines.h"
#include "render/renderer.h"
#include "render/surfaces/light/light_samples.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/picture_file.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

using render::DynamicLight;
using render::PixelFormat;

// A plane of any slope with a texture, rotated and scaled, and random light samples.
struct AnyFace {
  world::Level level;
  math::Vec3d normal, s_direction, t_direction;  // at right angles
  double s_scale = 1, t_scale = 1;               // texels a unit

  const world::Face& face() const { return level.faces[0]; }
};

AnyFace any_face(Random& random) {
  AnyFace out;
  const math::Basis basis = math::basis_from_angles(random.in_cube(180));
  out.normal = basis.up;
  out.s_direction = basis.forward;
  out.t_direction = basis.right;
  out.s_scale = random.log_uniform(0.25, 4);
  out.t_scale = random.log_uniform(0.25, 4);
  // Texture axes need not be parallel to the plane.
  const auto axis = [&](const math::Vec3d& direction, double scale) {
    return math::Vec3(direction * scale + out.normal * random.uniform(-1, 1));
  };
  out.level.texture_axes.push_back(
      {axis(out.s_direction, out.s_scale), static_cast<float>(random.uniform(-99, 99)),
       axis(out.t_direction, out.t_scale), static_cast<float>(random.uniform(-99, 99))});
  out.level.planes.push_back({math::Vec3(out.normal), static_cast<float>(random.uniform(-500, 500)), 3});
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.style_count = static_cast<std::uint8_t>(random.below(3));
  const auto sixteens = [&](std::size_t below) {
    return static_cast<std::int32_t>(16 * random.below(below));
  };
  face.texture_mins = {sixteens(20) - 160, sixteens(20) - 160};
  face.texture_extents = {sixteens(30) + 16, sixteens(20) + 16};
  out.level.faces.push_back(face);
  const std::size_t samples =
      std::size_t{2} * static_cast<std::size_t>(face.light_width() * face.light_height());
  for (std::size_t i = 0; i < samples; ++i)
    out.level.light.push_back(static_cast<std::uint8_t>(random.bits()));
  return out;
}

// The point of the face's plane, in model space, that shows a texel.
math::Vec3d point_of_texel(const AnyFace& any, double s, double t) {
  const world::Plane& plane = any.level.planes[0];
  const world::TextureAxes& axes = any.level.texture_axes[0];
  const math::Vec3d on_plane = math::Vec3d(plane.normal) * static_cast<double>(plane.distance);
  const double s_there = glm::dot(on_plane, math::Vec3d(axes.s_axis)) + static_cast<double>(axes.s_offset);
  const double t_there = glm::dot(on_plane, math::Vec3d(axes.t_axis)) + static_cast<double>(axes.t_offset);
  return on_plane + any.s_direction * ((s - s_there) / any.s_scale) +
         any.t_direction * ((t - t_there) / any.t_scale);
}

struct LightThere {
  double amount;      // of light; not positive: none
  double to_the_end;  // units to where the light ends; negative beyond
};
LightThere sample_light(const AnyFace& any, const DynamicLight& light, const math::Vec3d& light_model,
                        const math::Vec3d& point_model) {
  const math::Vec3d away = light_model - point_model;
  const double s = std::abs(glm::dot(away, any.s_direction)), t = std::abs(glm::dot(away, any.t_direction));
  const double distance = std::abs(glm::dot(away, any.normal)) + std::max(s, t) + std::min(s, t) / 2;
  return {static_cast<double>(light.radius) - distance,
          static_cast<double>(light.radius - std::max(0.0f, light.least)) - distance};
}

DynamicLight any_light_near(const math::Vec3d& point, Random& random) {
  DynamicLight light{.origin_world = math::Vec3(point) + random.in_cube(150),
                     .radius = static_cast<float>(random.uniform(1, 400))};
  if (random.chance(0.5)) light.least = static_cast<float>(random.uniform(-10, 60));
  if (random.chance(0.5)) light.color = glm::abs(random.in_cube(3));
  return light;
}

// Texture positions are floats of up to 1000 texels, so a light's position is exact to 1/1000 unit.
constexpr double kUnitsOff = 1e-3;

TEST(DynamicLights, AddUpAtSamplesAsDefined) {
  std::size_t lit = 0, dark = 0;
  for (int seed = 0; seed < effort(400, 60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const AnyFace any = any_face(random);
    const world::Face& face = any.face();
    const render::BrushModelInstance instance{.origin_world = random.in_cube(300),
                                              .angles_deg = random.in_cube(180)};
    const render::ModelView model_view = render::make_model_view(instance);
    const render::FacePlacement placed = render::place_face(any.level, face, model_view);
    const render::TileGrid tiles = render::tile_grid(face);
    const int tile_s = static_cast<int>(random.below(tiles.s)),
              tile_t = static_cast<int>(random.below(tiles.t));
    const render::SampleGrid grid = render::sample_grid(face, tile_s, tile_t);

    const math::Vec3d middle = point_of_texel(any, face.texture_mins[0] + face.texture_extents[0] / 2,
                                              face.texture_mins[1] + face.texture_extents[1] / 2);
    std::vector<DynamicLight> lights;
    std::vector<render::FaceLight> on_face;
    const bool colored = random.chance(0.5);
    for (std::size_t i = random.below(4); i > 0; --i) {
      lights.push_back(any_light_near(model_view.to_world(middle), random));
      if (!colored) lights.back().color = math::Vec3(1.0f);
      const auto there = render::light_on_face(lights.back(), placed, colored);
      if (there && render::reaches(*there, grid)) on_face.push_back(*there);
    }
    render::TileLight light{.lights = on_face};
    for (std::uint16_t& value : light.style_values) value = static_cast<std::uint16_t>(random.below(600));
    base::Arena arena;
    const render::LightSums sums = render::sum_light(any.level, face, grid, light, arena);
    ASSERT_EQ(sums.values.size(), static_cast<std::size_t>(grid.columns * grid.rows) * sums.channels);

    for (std::int32_t row = 0; row < grid.rows; ++row)
      for (std::int32_t column = 0; column < grid.columns; ++column)
        for (std::size_t channel = 0; channel < sums.channels; ++channel) {
          const std::int32_t s = grid.first_column + column, t = grid.first_row + row;
          double expected = 0, max_error = 1;
          for (std::int32_t style = 0; style < face.style_count; ++style) {
            const std::int32_t sample = (style * face.light_height() + t) * face.light_width() + s;
            expected += any.level.light[static_cast<std::size_t>(sample)] *
                        light.style_values[static_cast<std::size_t>(style)];
          }
          const math::Vec3d point =
              point_of_texel(any, face.texture_mins[0] + s * 16, face.texture_mins[1] + t * 16);
          for (const DynamicLight& one : lights) {
            const math::Vec3d away = math::Vec3d(one.origin_world) - model_view.origin_world;
            const math::Vec3d light_model(glm::dot(away, model_view.x_axis),
                                          glm::dot(away, model_view.y_axis),
                                          glm::dot(away, model_view.z_axis));
            const LightThere there = sample_light(any, one, light_model, point);
            const double factor = 256.0 * static_cast<double>(one.color[static_cast<int>(channel)]);
            if (there.to_the_end > 0) expected += there.amount * factor;
            max_error += 1 + kUnitsOff * factor;
            if (std::abs(there.to_the_end) < kUnitsOff) max_error += std::abs(there.amount) * factor;
            ++(there.to_the_end > 0 ? lit : dark);
          }
          const std::size_t at =
              static_cast<std::size_t>(row * grid.columns + column) * sums.channels + channel;
          ASSERT_NEAR(sums.values[at], expected, max_error) << s << ", " << t << ", channel " << channel;
        }
  }
  EXPECT_GT(lit, 1000u);
  EXPECT_GT(dark, 1000u);
}

// Whatever the numbers are: no light, or light within bounds.
TEST(DynamicLights, OfNonsenseAreNone) {
  const float infinity = std::numeric_limits<float>::infinity(),
              none = std::numeric_limits<float>::quiet_NaN();
  const float huge = std::numeric_limits<float>::max();
  const std::vector<float> numbers = {none, infinity, -infinity, huge, -huge, -1, 0, 100};
  Random random(1);
  for (int seed = 0; seed < effort(20000, 2000); ++seed) {
    const AnyFace any = any_face(random);
    const auto number = [&] { return numbers[random.below(numbers.size())]; };
    const DynamicLight light{.origin_world = {number(), number(), number()},
                             .radius = number(),
                             .least = number(),
                             .color = {number(), number(), number()}};
    const auto there = render::light_on_face(light, render::place_face(any.level, any.face(), {}), true);
    if (!(light.radius > 0)) {
      EXPECT_FALSE(there);
    }
    if (!there) continue;
    const render::SampleGrid grid = render::sample_grid(any.face(), 0, 0);
    base::Arena arena;
    const std::vector<render::FaceLight> lights(20, *there);
    const render::LightSums sums = render::sum_light(any.level, any.face(), grid, {.lights = lights}, arena);
    for (const std::uint32_t sum : sums.values) ASSERT_LE(sum, 1u << 30);
  }
}

FrameCopy drawn(render::Renderer& io_renderer, const render::Scene& scene, PixelFormat format,
                render::FrameStats* out_stats = nullptr) {
  render::FrameBuffer frame(320, 200, format);
  const render::FrameStats stats = io_renderer.render(scene, {}, frame);
  if (out_stats != nullptr) *out_stats = stats;
  return copy_picture(frame);
}

// A little in front of the eye.
std::vector<DynamicLight> light_before(const render::Camera& camera, math::Vec3 color = math::Vec3(1.0f)) {
  const math::Vec3 forward(math::basis_from_angles(camera.angles_deg).forward);
  return {{.origin_world = camera.origin_world + forward * 40.0f, .radius = 250, .least = 8, .color = color}};
}

void expect_put_back(const DrawableLevel& drawable, int views) {
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    std::size_t changed = 0;
    render::Renderer renderer(drawable.palette, drawable.colormap);
    for (int number = 0; number < views; ++number) {
      SCOPED_TRACE(fmt::format("{}, view {}", drawable.name, number));
      Random random(static_cast<std::uint64_t>(number));
      const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random),
                                .brush_models = shown_brush_models(*drawable.level)};
      const render::Scene without = viewpoint.scene(*drawable.level);
      render::Scene with = without;
      const std::vector<DynamicLight> lights = light_before(viewpoint.camera);
      with.lights = lights;
      render::FrameStats stats;
      const FrameCopy before = drawn(renderer, without, format);
      const FrameCopy lit = drawn(renderer, with, format, &stats);
      changed += differing_pixels(before, lit);
      EXPECT_TRUE(drawn(renderer, with, format, &stats) == lit);
      EXPECT_EQ(stats.surfaces_built, 0u) << "light that stays is not built again";
      EXPECT_TRUE(drawn(renderer, without, format, &stats) == before);
      EXPECT_EQ(stats.surfaces_built, 0u) << "what was there before the light is there after it";
    }
    EXPECT_GT(changed, 320u * 200u * static_cast<unsigned>(views) / 10);
  }
}

TEST(DynamicLights, LeaveTheSmallLevelAsItWas) {
  expect_put_back(small_level(), 12);
  expect_put_back(small_level({.wide_faces = true, .colored_light = true}), 12);
}
TEST(DynamicLights, LeaveAStockLevelAsItWas) {
  DATA_FOLDER_OR_SKIP(data);
  expect_put_back(stock_level(data, "lq_e0m1"), effort(20, 4));
}

// The kind of face of each pixel.
std::vector<const world::Face*> faces_of_pixels(const render::Renderer& renderer, const world::Level& level,
                                                std::size_t pixels) {
  std::vector<render::PixelFace> shown(pixels);
  std::vector<std::uint8_t> writes(pixels);
  renderer.pixel_faces(shown, writes);
  std::vector<const world::Face*> faces;
  for (const render::PixelFace& pixel : shown)
    faces.push_back(pixel.instance == render::PixelFace::kNothing ? nullptr : &level.faces[pixel.face]);
  return faces;
}

TEST(DynamicLights, FallOnLitFacesOnly) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  std::size_t others = 0;
  for (int number = 0; number < 60; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random)};
    const render::Scene without = viewpoint.scene(*drawable.level);
    render::Scene with = without;
    const std::vector<DynamicLight> lights = light_before(viewpoint.camera);
    with.lights = lights;
    const FrameCopy before = drawn(renderer, without, PixelFormat::kRgb);
    const FrameCopy lit = drawn(renderer, with, PixelFormat::kRgb);
    const auto faces = faces_of_pixels(renderer, *drawable.level, lit.rgb.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (faces[i] == nullptr || faces[i]->kind == world::FaceKind::kLit) continue;
      ASSERT_EQ(lit.rgb[i], before.rgb[i]) << "view " << number;
      ++others;
    }
  }
  EXPECT_GT(others, 10000u);
}

TEST(DynamicLights, OfAColorAddThatColorToGrayLight) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  std::size_t redder = 0;
  double red_shift = 0, lit_pixels = 0;  // of indexed pixels, against white light
  for (int number = 0; number < 12; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random)};
    const render::Scene without = viewpoint.scene(*drawable.level);
    render::Scene with = without, with_white = without;
    const std::vector<DynamicLight> red = light_before(viewpoint.camera, {1, 0, 0});
    const std::vector<DynamicLight> white = light_before(viewpoint.camera);
    with.lights = red;
    with_white.lights = white;
    const FrameCopy before = drawn(renderer, without, PixelFormat::kRgb);
    const FrameCopy lit = drawn(renderer, with, PixelFormat::kRgb);
    for (std::size_t i = 0; i < lit.rgb.size(); ++i) {
      ASSERT_EQ(lit.rgb[i] & 0xff00ffffu, before.rgb[i] & 0xff00ffffu);
      ASSERT_GE(lit.rgb[i] & 0xff0000u, before.rgb[i] & 0xff0000u);
      redder += lit.rgb[i] != before.rgb[i];
    }
    const FrameCopy indexed = drawn(renderer, with, PixelFormat::kIndexed);
    const FrameCopy indexed_white = drawn(renderer, with_white, PixelFormat::kIndexed);
    for (std::size_t i = 0; i < indexed.indexed.size(); ++i) {
      if (indexed.indexed[i] == indexed_white.indexed[i]) continue;
      const formats::Rgb& color = drawable.palette[indexed.indexed[i]];
      const formats::Rgb& in_white = drawable.palette[indexed_white.indexed[i]];
      red_shift += (color.r * 2 - color.g - color.b) - (in_white.r * 2 - in_white.g - in_white.b);
      ++lit_pixels;
    }
  }
  EXPECT_GT(redder, 10000u);
  EXPECT_GT(lit_pixels, 10000);
  EXPECT_GT(red_shift, 20 * lit_pixels);
}

TEST(DynamicLights, LightFacesThatHaveNoSamples) {
  const DrawableLevel drawable = small_level();
  world::Level dark = *drawable.level;
  dark.identity = std::make_shared<const world::LevelIdentity>();
  for (world::Face& face : dark.faces) {
    face.light = world::kNoLight;
    face.style_count = 0;
  }
  render::Renderer renderer(drawable.palette, drawable.colormap);
  Random random(3);
  const Viewpoint viewpoint{.camera = random_camera(dark, random)};
  render::Scene scene = viewpoint.scene(dark);
  const FrameCopy before = drawn(renderer, scene, PixelFormat::kRgb);
  const std::vector<DynamicLight> lights = light_before(viewpoint.camera);
  scene.lights = lights;
  EXPECT_GT(differing_pixels(before, drawn(renderer, scene, PixelFormat::kRgb)), 10000u);
}

// A door that has moved, and a light that has moved with it: the door is lit as at its original place.
TEST(DynamicLights, FollowModelsThatMoved) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  const world::Model& door = level.models[1];
  const math::Vec3 middle = (door.bounds.mins + door.bounds.maxs) * 0.5f;
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const render::ModelView home = render::make_model_view({.model = world::ModelIndex{1}});
    const render::BrushModelInstance moved_instance{.model = world::ModelIndex{1},
                                                    .origin_world = random.in_cube(500),
                                                    .angles_deg = random.in_cube(180)};
    const render::ModelView moved = render::make_model_view(moved_instance);
    const DynamicLight at_home{.origin_world = middle + random.in_cube(100), .radius = 200};
    DynamicLight light_moved = at_home;
    light_moved.origin_world = math::Vec3(moved.to_world(math::Vec3d(at_home.origin_world)));
    for (std::uint32_t i = 0; i < door.face_count; ++i) {
      const world::Face& face = level.faces[door.first_face + i];
      const auto there = render::light_on_face(at_home, render::place_face(level, face, home), false);
      const auto then = render::light_on_face(light_moved, render::place_face(level, face, moved), false);
      ASSERT_EQ(there.has_value(), then.has_value());
      if (!there) continue;
      EXPECT_NEAR(then->s, there->s, 1e-2);
      EXPECT_NEAR(then->t, there->t, 1e-2);
      EXPECT_NEAR(then->at_nearest, there->at_nearest, 1e-2);
    }
  }
}

// Two instances of one brush model, one of them beside a light: each has its own block.
TEST(DynamicLights, TellInstancesOfAModelApart) {
  const DrawableLevel drawable = small_level();
  const world::Model& door = drawable.level->models[1];
  const math::Vec3 middle = (door.bounds.mins + door.bounds.maxs) * 0.5f;
  const std::vector<render::BrushModelInstance> doors = {
      {.model = world::ModelIndex{1}, .origin_world = {0, 0, 0}},
      {.model = world::ModelIndex{1}, .origin_world = {-60, 0, 30}}};
  const std::vector<DynamicLight> lights = {{.origin_world = middle + math::Vec3(-80, 0, 60), .radius = 150},
                                            {.origin_world = middle + math::Vec3(80, 0, 0), .radius = 100}};
  render::Renderer warm(drawable.palette, drawable.colormap);
  for (int number = 0; number < 20; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    render::Camera camera = random_camera(*drawable.level, random);
    render::Scene scene{
        .level = drawable.level.get(), .camera = camera, .brush_models = doors, .lights = lights};
    for (const bool lit : {true, false, true}) {
      scene.lights = lit ? std::span<const DynamicLight>(lights) : std::span<const DynamicLight>();
      render::FrameBuffer kept(320, 200, PixelFormat::kRgb), fresh(320, 200, PixelFormat::kRgb);
      warm.render(scene, {}, kept);
      render::Renderer cold(drawable.palette, drawable.colormap);
      cold.render(scene, {.surface_cache = false}, fresh);
      EXPECT_TRUE(copy_picture(kept) == copy_picture(fresh)) << "view " << number;
    }
  }
}

// The start of a level, with and without lights. View it with TEMBLOR_PICTURES.
class LightsOnStockLevel : public testing::TestWithParam<const char*> {};
TEST_P(LightsOnStockLevel, AreSeen) {
  DATA_FOLDER_OR_SKIP(data);
  const DrawableLevel drawable = stock_level(data, GetParam());
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const std::vector<render::Camera> cameras = player_cameras(*drawable.level);
  std::size_t changed = 0;
  for (std::size_t number = 0; number < std::min<std::size_t>(cameras.size(), 3); ++number) {
    Viewpoint viewpoint{.camera = cameras[number], .brush_models = shown_brush_models(*drawable.level)};
    const render::Scene without = viewpoint.scene(*drawable.level);
    const math::Basis basis = math::basis_from_angles(viewpoint.camera.angles_deg);
    const auto ahead = [&](double forward, double right, double up) {
      return viewpoint.camera.origin_world +
             math::Vec3(basis.forward * forward + basis.right * right + basis.up * up);
    };
    viewpoint.lights = {{.origin_world = ahead(150, 100, 0), .radius = 200, .color = {1, 0.6f, 0.3f}},
                        {.origin_world = ahead(120, -100, 20), .radius = 250, .color = {0.3f, 0.4f, 1}},
                        {.origin_world = ahead(18, 0, -6), .radius = 220, .least = 32}};
    const render::Scene with = viewpoint.scene(*drawable.level);
    for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
      render::FrameBuffer before(800, 600, format), lit(800, 600, format);
      renderer.render(without, {}, before);
      renderer.render(with, {}, lit);
      changed += differing_pixels(copy_picture(before), copy_picture(lit));
      const std::string name = fmt::format("lights-{}-{}-{}", GetParam(), number,
                                           format == PixelFormat::kIndexed ? "indexed" : "rgb");
      show_picture(name + "-before", before, drawable.palette);
      show_picture(name, lit, drawable.palette);
    }
  }
  EXPECT_GT(changed, 100000u);
}
INSTANTIATE_TEST_SUITE_P(Levels, LightsOnStockLevel, testing::Values("start", "lq_e0m1", "lq_e1m2"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace temblor::test
