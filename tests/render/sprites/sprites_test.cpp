// Sprites against rays: for each pixel, the point where the ray through its center meets the picture's plane,
// in double precision. The plane follows from the meaning of each orientation type.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "render/color/blend_tables.h"
#include "render/renderer.h"
#include "render/sprites/draw_sprites.h"
#include "render/translucent/blend_sprite.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/some_colors.h"
#include "support/pictures/view_by_hand.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using formats::SprOrientation;
constexpr double kDegree = M_PI / 180;

struct TestSprite {
  formats::Spr spr;
  render::SpriteInstance instance() const { return {.sprite = &spr, .picture = &spr.frames[0].pictures[0]}; }
};

// One texel in five is transparent.
TestSprite make_sprite(SprOrientation orientation, std::uint32_t width, std::uint32_t height,
                       Random& random) {
  formats::SprPicture picture{-static_cast<int>(random.below(width + 1)),
                              static_cast<int>(random.below(height + 1)),
                              width,
                              height,
                              {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    picture.texels.push_back(random.chance(0.2) ? std::uint8_t{255}
                                                : static_cast<std::uint8_t>(random.below(255)));
  TestSprite sprite;
  sprite.spr.orientation = orientation;
  sprite.spr.frames.push_back({{picture}, {}});
  return sprite;
}

struct Axes {
  math::Vec3d right, up;
};

// To the right for a viewer who stands upright and looks along `direction`.
Axes standing(const math::Vec3d& direction) {
  const math::Vec3d up(0, 0, 1);
  return {glm::normalize(glm::cross(direction, up)), up};
}

Axes compute_axes(const render::ViewFrame& view, const render::SpriteInstance& sprite) {
  switch (sprite.sprite->orientation) {
    case SprOrientation::kParallelUpright:
      return standing(view.axes.forward);
    case SprOrientation::kFacingUpright:
      // In parallel projection, the eye is infinitely far back.
      return standing(view.perspective ? math::Vec3d(sprite.origin_world) - view.eye_world
                                       : view.axes.forward);
    case SprOrientation::kParallel:
      return {view.axes.right, view.axes.up};
    case SprOrientation::kOriented: {
      const math::Basis own = math::basis_from_angles(sprite.angles_deg);
      return {own.right, own.up};
    }
    case SprOrientation::kParallelOriented: {
      const double roll = sprite.angles_deg.z * kDegree;
      return {std::cos(roll) * view.axes.right + std::sin(roll) * view.axes.up,
              std::cos(roll) * view.axes.up - std::sin(roll) * view.axes.right};
    }
  }
  return {};
}

// The texel that the ray through a pixel's center meets, and whether it is clear of every border, where
// rounding could decide.
struct Hit {
  double depth = 0;
  int texel = 255;
  bool is_clear = true;
};
Hit meet(const render::ViewFrame& view, const render::SpriteInstance& sprite, int x, int y) {
  const Axes axes = compute_axes(view, sprite);
  const math::Vec3d normal = glm::cross(axes.right, axes.up), origin(sprite.origin_world);
  const math::Vec3d aside = view.axes.right * ((x - view.center_x) / view.pixels_per_unit) -
                            view.axes.up * ((y - view.center_y) / view.pixels_per_unit);
  const math::Vec3d start = view.perspective ? view.eye_world : view.eye_world + aside;
  const math::Vec3d ray = view.perspective ? view.axes.forward + aside : view.axes.forward;
  const double z = glm::dot(normal, origin - start) / glm::dot(normal, ray);
  const math::Vec3d at = start + ray * z - origin;
  const formats::SprPicture& picture = *sprite.picture;
  const double scale = static_cast<double>(sprite.scale);
  const double s = glm::dot(at, axes.right) / scale - picture.left;
  const double t = picture.up - glm::dot(at, axes.up) / scale;
  const double slack = 2e-3 + 1e-6 * std::abs(z);
  Hit hit;
  if (!std::isfinite(z) || z < view.near_z * 0.999 || s < -slack || t < -slack || s > picture.width + slack ||
      t > picture.height + slack)
    return hit;
  hit.depth = view.depth(z);
  hit.is_clear =
      std::abs(s - std::round(s)) > slack && std::abs(t - std::round(t)) > slack && z > view.near_z * 1.001;
  if (hit.is_clear && s > 0 && t > 0 && s < picture.width && t < picture.height)
    hit.texel = picture.texels[static_cast<std::size_t>(t) * picture.width + static_cast<std::size_t>(s)];
  return hit;
}

struct Before {
  std::vector<float> depth;
  std::vector<std::uint32_t> pixels;
};

// Depths in front of and behind the sprite, by far more than rounding.
Before fill(render::FrameBuffer& io_frame, double depth, Random& random) {
  Before before;
  for (std::size_t i = 0; i < io_frame.pixel_count(); ++i) {
    before.depth.push_back(static_cast<float>(random.chance(0.7) ? std::numeric_limits<float>::lowest()
                                                                 : depth + std::abs(depth) * 3));
    before.pixels.push_back(static_cast<std::uint32_t>(random.bits()) | 0xff000000u);
    io_frame.depth()[i] = before.depth[i];
    if (io_frame.format() == render::PixelFormat::kIndexed)
      before.pixels[i] = io_frame.indexed()[i] = static_cast<std::uint8_t>(before.pixels[i]);
    else
      io_frame.rgb()[i] = before.pixels[i];
  }
  return before;
}

std::uint32_t pixel_at(const render::FrameBuffer& frame, std::size_t i) {
  return frame.format() == render::PixelFormat::kIndexed ? frame.indexed()[i] : frame.rgb()[i];
}

void draw(const std::vector<render::SpriteInstance>& sprites, const render::ViewFrame& view, int threads,
          bool simd_kernels, render::FrameBuffer& io_frame) {
  render::Scene scene;
  scene.sprites = sprites;
  base::Jobs jobs(threads, base::JobBackend::kStdThread);
  base::Arena arena;
  const std::span<const render::SpriteQuad> quads = render::place_sprites(scene, view, arena);
  constexpr int kBandRows = 32;
  jobs.parallel_for(static_cast<std::size_t>((view.height + kBandRows - 1) / kBandRows),
                    [&](std::size_t band) {
                      const int first = static_cast<int>(band) * kBandRows;
                      render::draw_sprites(quads, some_tables(), simd_kernels,
                                           {first, std::min(first + kBandRows, view.height)}, io_frame);
                    });
}

struct Tally {
  std::size_t shown = 0, wrong = 0;
};

// Compares every pixel for which rounding cannot make a difference.
Tally compare(const render::FrameBuffer& frame, const Before& before, const render::ViewFrame& view,
              const render::SpriteInstance& sprite) {
  Tally tally;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const Hit hit = meet(view, sprite, x, y);
      if (!hit.is_clear) continue;
      const std::size_t i = static_cast<std::size_t>(y * view.width + x);
      const bool shows = hit.texel != 255 && static_cast<float>(hit.depth) >= before.depth[i];
      const std::uint32_t over = frame.format() == render::PixelFormat::kIndexed
                                     ? static_cast<std::uint32_t>(hit.texel)
                                     : some_tables().rgb[static_cast<std::size_t>(hit.texel)];
      const double depth = shows ? hit.depth : static_cast<double>(before.depth[i]);
      tally.shown += shows;
      tally.wrong += pixel_at(frame, i) != (shows ? over : before.pixels[i]) ||
                     std::abs(static_cast<double>(frame.depth()[i]) - depth) > 1e-4 * std::abs(depth);
    }
  return tally;
}

// In front of the eye, far away, or so near that the near plane cuts it.
render::SpriteInstance place(const TestSprite& sprite, const render::ViewFrame& view, Random& random) {
  render::SpriteInstance instance = sprite.instance();
  const double distance = random.chance(0.2) ? random.uniform(-10, 20) : random.log_uniform(10, 600);
  const math::Vec3d aside = view.axes.right * (random.uniform(-0.7, 0.7) * distance) +
                            view.axes.up * (random.uniform(-0.5, 0.5) * distance);
  instance.origin_world = math::Vec3(view.eye_world + view.axes.forward * distance + aside);
  instance.angles_deg = random.in_cube(180);
  instance.scale = static_cast<float>(random.log_uniform(0.3, 4));
  return instance;
}

TEST(Sprites, AreWhereRaysMeetThem) {
  std::size_t shown_in_all = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(effort(400, 40)); ++seed) {
    Random random(seed);
    const auto orientation = static_cast<SprOrientation>(seed % 5);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int width = 2 + static_cast<int>(random.below(200)),
              height = 2 + static_cast<int>(random.below(150));
    const math::Vec3 angles(
        math::Vec3d(random.uniform(-85, 85), random.uniform(0, 360), random.uniform(-20, 20)));
    render::ViewFrame view = make_test_view(width, height, random.uniform(20, 140), angles,
                                            math::Vec3d(math::Vec3(random.in_cube(500))));
    if (random.chance(0.15)) {
      view.perspective = false;
      view.pixels_per_unit = random.uniform(0.3, 3);
    }
    const TestSprite sprite = make_sprite(orientation, 1 + static_cast<std::uint32_t>(random.below(70)),
                                          1 + static_cast<std::uint32_t>(random.below(70)), random);
    const render::SpriteInstance instance = place(sprite, view, random);
    const auto format = random.chance(0.5) ? render::PixelFormat::kIndexed : render::PixelFormat::kRgb;
    render::FrameBuffer frame(width, height, format);
    const double middle = view.depth(std::max(
        view.near_z, glm::dot(math::Vec3d(instance.origin_world) - view.eye_world, view.axes.forward)));
    const Before before = fill(frame, middle, random);
    draw({instance}, view, 1 + static_cast<int>(seed % 3), seed % 4 != 0, frame);
    const Tally tally = compare(frame, before, view, instance);
    EXPECT_EQ(tally.wrong, 0u) << "of " << tally.shown;
    shown_in_all += tally.shown;
  }
  EXPECT_GT(shown_in_all, 1000u);
}

TEST(Sprites, UprightOnesVanishSeenFromStraightAbove) {
  Random random(3);
  for (const auto orientation :
       {SprOrientation::kParallelUpright, SprOrientation::kFacingUpright, SprOrientation::kParallel})
    for (const double pitch_deg : {89.5, 88.0, -89.5, -88.0}) {
      const render::ViewFrame view =
          make_test_view(100, 100, 90, math::Vec3(math::Vec3d(pitch_deg, 30, 0)), math::Vec3d(0.0));
      const TestSprite sprite = make_sprite(orientation, 40, 40, random);
      render::SpriteInstance instance = sprite.instance();
      instance.origin_world = math::Vec3(view.axes.forward * 60.0);
      const bool upright = orientation != SprOrientation::kParallel;
      EXPECT_EQ(render::make_sprite_quad(view, instance).has_value(), !upright || std::abs(pitch_deg) < 89)
          << pitch_deg;
    }
}

TEST(Sprites, OfNoSizeOrPlaceAreLeftOut) {
  Random random(4);
  const render::ViewFrame view = make_test_view(100, 100, 90, math::Vec3(0.0f), math::Vec3d(0.0));
  const TestSprite sprite = make_sprite(SprOrientation::kFacingUpright, 40, 40, random);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const auto is_drawn = [&](float x, float scale) {
    render::SpriteInstance instance = sprite.instance();
    instance.origin_world = {x, 0, 0};
    instance.scale = scale;
    return render::make_sprite_quad(view, instance).has_value();
  };
  EXPECT_TRUE(is_drawn(50, 1));
  EXPECT_FALSE(is_drawn(0, 1)) << "where the eye is";
  EXPECT_FALSE(is_drawn(-50, 1)) << "behind it";
  EXPECT_FALSE(is_drawn(50, 0));
  EXPECT_FALSE(is_drawn(50, kNan));
  EXPECT_FALSE(is_drawn(kNan, 1));
}

TEST(Sprites, OpaqueOnesOfOneDepthHideWhatCameBefore) {
  Random random(7);
  const render::ViewFrame view = make_test_view(64, 64, 90, math::Vec3(0.0f), math::Vec3d(0.0));
  TestSprite first = make_sprite(SprOrientation::kParallel, 30, 30, random);
  TestSprite second = first;
  first.spr.frames[0].pictures[0] = {-15, 15, 30, 30, std::vector<std::uint8_t>(900, 1)};
  second.spr.frames[0].pictures[0] = {-15, 15, 30, 30, std::vector<std::uint8_t>(900, 2)};
  render::SpriteInstance a = first.instance(), b = second.instance();
  a.origin_world = b.origin_world = {30, 0, 0};
  render::FrameBuffer frame(64, 64, render::PixelFormat::kIndexed);
  fill_frame(frame, 0);
  draw({a, b}, view, 1, true, frame);
  EXPECT_EQ(std::count(frame.indexed().begin(), frame.indexed().end(), 1), 0);
  EXPECT_GT(std::count(frame.indexed().begin(), frame.indexed().end(), 2), 500);
}

// One square with the picture, 30 units in front of the eye.
struct FacingSprite {
  explicit FacingSprite(Random& io_random)
      : sprite(make_sprite(SprOrientation::kParallel, 50, 40, io_random)), instance(sprite.instance()) {
    instance.origin_world = {30, 0, 0};
    quad = render::make_sprite_quad(view, instance);
  }

  render::ViewFrame view = make_test_view(80, 60, 90, math::Vec3(0.0f), math::Vec3d(0.0));
  TestSprite sprite;
  render::SpriteInstance instance;
  std::optional<render::SpriteQuad> quad;
};

TEST(Sprites, BlendThroughTheTableOrByOpacity) {
  Random random(8);
  const FacingSprite facing(random);
  std::vector<std::uint8_t> table(65536);
  for (std::uint8_t& entry : table) entry = static_cast<std::uint8_t>(random.bits());
  ASSERT_TRUE(facing.quad);
  for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    render::FrameBuffer frame(80, 60, format);
    const Before before = fill(frame, 1.0 / 30, random);
    const render::SpriteBlend blend{table.data(), 64};
    for (int row = 0; row < 60; row += 7)
      render::blend_sprite(*facing.quad, blend, some_tables(), row % 2 == 0, {row, std::min(row + 7, 60)},
                           frame);
    std::size_t blended = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x) {
        const Hit hit = meet(facing.view, facing.instance, x, y);
        const std::size_t i = static_cast<std::size_t>(y * 80 + x);
        ASSERT_EQ(frame.depth()[i], before.depth[i]) << "what can be seen through leaves no depth";
        if (!hit.is_clear || hit.texel == 255 || static_cast<float>(hit.depth) < before.depth[i]) continue;
        const auto over = static_cast<std::size_t>(hit.texel);
        const std::uint32_t expected = format == render::PixelFormat::kIndexed
                                           ? table[over * 256 + before.pixels[i]]
                                           : render::blend_rgb(some_tables().rgb[over], before.pixels[i], 64);
        ASSERT_EQ(pixel_at(frame, i), expected);
        ++blended;
      }
    EXPECT_GT(blended, 500u);
  }
}

TEST(Sprites, AreFoggedBeforeTheyAreBlended) {
  Random random(8);
  const FacingSprite facing(random);
  ASSERT_TRUE(facing.quad);
  const render::Fog thick{1.5f, {0.2f, 0.6f, 0.4f}};
  const double share = 1 - std::exp(-std::pow(1.5 * 30 / 64, 2));
  const formats::Rgb fog_color = render::to_bytes(thick.color);
  for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    render::FogTables fog_tables;
    const render::FrameFog fog(thick, true, format, some_tables(), fog_tables, true);
    const std::uint8_t* const fogged =
        fog_tables.rows_for(thick.color, some_tables().palette, some_tables().match) +
        std::lround(share * render::kFogSteps) * 256;
    render::FrameBuffer frame(80, 60, format);
    const Before before = fill(frame, 1.0 / 60, random);
    const std::uint8_t* const table = some_tables().blends.table_for(0.25f);
    render::blend_sprite(*facing.quad, {table, 64, &fog}, some_tables(), true, {0, 60}, frame);
    std::size_t blended = 0;
    for (std::size_t i = 0; i < frame.pixel_count(); ++i) {
      const Hit hit = meet(facing.view, facing.instance, static_cast<int>(i % 80), static_cast<int>(i / 80));
      if (!hit.is_clear || hit.texel == 255 || static_cast<float>(hit.depth) < before.depth[i]) continue;
      ++blended;
      const auto texel = static_cast<std::size_t>(hit.texel);
      if (format == render::PixelFormat::kIndexed) {
        ASSERT_EQ(pixel_at(frame, i), table[fogged[texel] * 256u + before.pixels[i]]);
        continue;
      }
      const int fog_channels[3] = {fog_color.b, fog_color.g, fog_color.r};
      for (int channel = 0; channel < 3; ++channel) {
        const auto of = [&](std::uint32_t color) {
          return static_cast<double>(color >> (8 * channel) & 255);
        };
        const double own = of(some_tables().rgb[texel]);
        const double over = own + (fog_channels[channel] - own) * share;
        ASSERT_NEAR(of(pixel_at(frame, i)), over * 0.25 + of(before.pixels[i]) * 0.75, 1.1);
      }
    }
    EXPECT_GT(blended, 500u);
  }
}

TEST(Sprites, AndParticlesAreTheSameForAnyNumberOfThreads) {
  Random random(9);
  const DrawableLevel drawable = small_level();
  const math::Bounds& bounds = drawable.level->world().bounds;
  const math::Vec3 center = (bounds.mins + bounds.maxs) * 0.5f;
  std::vector<TestSprite> sprites;
  for (int i = 0; i < 10; ++i)
    sprites.push_back(make_sprite(static_cast<SprOrientation>(i % 5), 60, 60, random));
  std::vector<render::SpriteInstance> instances;
  for (const TestSprite& sprite : sprites) {
    instances.push_back(sprite.instance());
    instances.back().origin_world = center + random.in_cube(100);
    instances.back().angles_deg = random.in_cube(180);
  }
  std::vector<float> x, y, z;
  const std::vector<std::uint8_t> color(1000, 99);
  for (int i = 0; i < 1000; ++i) {
    const math::Vec3 at = center + random.in_cube(100);
    x.push_back(at.x);
    y.push_back(at.y);
    z.push_back(at.z);
  }
  render::Scene scene{.level = drawable.level.get(), .camera = {.origin_world = center}};
  const auto hash_with = [&](const render::Settings& settings, render::PixelFormat format) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    render::FrameBuffer frame(333, 222, format);
    renderer.render(scene, settings, frame);
    return compute_hash(frame);
  };
  for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    scene.sprites = {};
    scene.particles = {};
    const std::uint64_t empty = hash_with({}, format);
    scene.sprites = instances;
    const std::uint64_t with_sprites = hash_with({}, format);
    EXPECT_NE(with_sprites, empty);
    scene.particles = {x, y, z, color};
    const std::uint64_t expected = hash_with({}, format);
    EXPECT_NE(expected, with_sprites);
    for (const int threads : {2, 8})
      EXPECT_EQ(hash_with({.threads = threads, .job_backend = base::JobBackend::kStdThread}, format),
                expected);
    EXPECT_EQ(hash_with({.simd_kernels = false}, format), expected);
  }
}

}  // namespace
}  // namespace temblor::test
