// Skyboxes: each pixel shows the color in its direction, and sides meet without seams.
#include "render/spans/skybox.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "render/renderer.h"
#include "render/simd_targets.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// A color for each direction, continuous everywhere.
Vec3d color_towards(const Vec3d& ray) {
  return (glm::normalize(ray) + Vec3d(1.0)) * 127.5;
}

std::uint32_t packed(const Vec3d& color) {
  return 0xff000000u | static_cast<std::uint32_t>(std::lround(color.x)) << 16 |
         static_cast<std::uint32_t>(std::lround(color.y)) << 8 |
         static_cast<std::uint32_t>(std::lround(color.z));
}

// By the definition of Skybox: the position on a side's picture, (u, v) from -1 to 1 to its right and upward.
Vec3d direction_on(std::size_t side, double u, double v) {
  const std::array<Vec3d, 6> directions = {Vec3d(1, -u, v),  Vec3d(u, 1, v),   Vec3d(-1, u, v),
                                           Vec3d(-u, -1, v), Vec3d(-v, -u, 1), Vec3d(v, -u, -1)};
  return directions[side];
}

render::Skybox smooth_skybox(std::uint32_t width, std::uint32_t height) {
  render::Skybox skybox;
  for (std::size_t side = 0; side < 6; ++side) {
    formats::Image& image = skybox.sides[side];
    image.width = width;
    image.height = height;
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x)
        image.pixels.push_back(
            packed(color_towards(direction_on(side, 2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height))));
  }
  return skybox;
}

struct SkyView {
  render::ViewFrame view;
  Vec3d ray(int x, int y) const {
    return view.axes.forward * view.pixels_per_unit + view.axes.right * (x - view.center_x) -
           view.axes.up * (y - view.center_y);
  }
};

SkyView any_view(const world::Level& level, Random& random, int width, int height) {
  render::Scene scene;
  scene.level = &level;
  scene.camera.angles_deg = {static_cast<float>(random.uniform(-90, 90)),
                             static_cast<float>(random.uniform(0, 360)), 0};
  scene.camera.fov_deg = static_cast<float>(random.uniform(60, 150));
  return {render::make_view_frame(scene, width, height)};
}

// The whole picture is sky.
template <typename Pixel>
std::vector<Pixel> draw(render::SkyboxSpans spans, int width, int height,
                        void (*draw_spans)(const render::SkyboxSpans&, const render::KernelTarget&)) {
  std::vector<Pixel> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<render::Span> rows;
  for (int y = 0; y < height; ++y)
    rows.push_back({0, static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(width)});
  spans.spans = rows.data();
  spans.span_count = rows.size();
  draw_spans(spans, {pixels.data(), nullptr, static_cast<std::size_t>(width)});
  return pixels;
}

constexpr int kSkyWidth = 133, kSkyHeight = 87;

// Smooth pictures stay smooth: a side that is exchanged or flipped, or a seam, would show.
void expect_smooth(const render::Skybox& skybox, double tolerance) {
  const DrawableLevel drawable = small_level({.tiny = true});
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  render::PreparedSkybox prepared;
  prepared.update(skybox, {}, tables, render::PixelFormat::kRgb);
  for (int seed = 0; seed < 40; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const SkyView sky = any_view(*drawable.level, random, kSkyWidth, kSkyHeight);
    const std::vector<std::uint32_t> pixels = draw<std::uint32_t>(
        prepared.spans(sky.view), kSkyWidth, kSkyHeight, render::draw_skybox_spans_u32_scalar);
    for (int y = 0; y < kSkyHeight; ++y)
      for (int x = 0; x < kSkyWidth; ++x) {
        const std::uint32_t pixel = pixels[static_cast<std::size_t>(y * kSkyWidth + x)];
        const Vec3d expected = color_towards(sky.ray(x, y));
        ASSERT_NEAR(pixel >> 16 & 255, expected.x, tolerance) << "seed " << seed << ": " << x << "," << y;
        ASSERT_NEAR(pixel >> 8 & 255, expected.y, tolerance) << "seed " << seed << ": " << x << "," << y;
        ASSERT_NEAR(pixel & 255, expected.z, tolerance) << "seed " << seed << ": " << x << "," << y;
      }
  }
}

TEST(Skybox, ShowsWhatLiesInEachDirectionWithoutSeams) {
  expect_smooth(smooth_skybox(64, 64), 1.6);
}
TEST(Skybox, TakesSidesOfAnyShapeAndSize) {
  expect_smooth(smooth_skybox(100, 37), 2.2);
  render::Skybox mixed = smooth_skybox(64, 64);
  const render::Skybox other = smooth_skybox(48, 80);
  for (const std::size_t side : {1u, 3u, 4u}) mixed.sides[side] = other.sides[side];
  expect_smooth(mixed, 2.2);
}

// With sides of few texels and strong colors, along each edge of the cube: a step across the edge changes the
// color no more than a step beside it.
TEST(Skybox, FadesAcrossTheEdgesOfTheCube) {
  Random random(3);
  render::Skybox skybox;
  for (formats::Image& image : skybox.sides) {
    image.width = image.height = 8;
    for (int i = 0; i < 64; ++i)
      image.pixels.push_back(static_cast<std::uint32_t>(random.bits()) | 0xff000000u);
  }
  const DrawableLevel drawable = small_level({.tiny = true});
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  render::PreparedSkybox prepared;
  prepared.update(skybox, {}, tables, render::PixelFormat::kRgb);
  for (int seed = 0; seed < 20; ++seed) {
    Random view_random(static_cast<std::uint64_t>(seed));
    SkyView sky = any_view(*drawable.level, view_random, 320, 200);
    const std::vector<std::uint32_t> pixels =
        draw<std::uint32_t>(prepared.spans(sky.view), 320, 200, render::draw_skybox_spans_u32_scalar);
    for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
      if (i % 320 == 319) continue;
      const Vec3d a = sky.ray(static_cast<int>(i % 320), static_cast<int>(i / 320));
      const Vec3d b = sky.ray(static_cast<int>(i % 320) + 1, static_cast<int>(i / 320));
      const double turn = std::acos(std::min(1.0, glm::dot(glm::normalize(a), glm::normalize(b))));
      for (int shift = 0; shift < 24; shift += 8) {
        const double step = std::abs(static_cast<double>(pixels[i] >> shift & 255) -
                                     static_cast<double>(pixels[i + 1] >> shift & 255));
        // A texel is a quarter of half the side wide, which near the corners appears under a third of its
        // angle; it may differ from both neighbors by 255.
        ASSERT_LE(step, 4 + turn * 4 * 3 * 255 * std::sqrt(2.0)) << "seed " << seed << ", pixel " << i;
      }
    }
  }
}

TEST(Skybox, IsTheSameInSimd) {
  const DrawableLevel drawable = small_level({.tiny = true});
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  const render::Skybox skybox = smooth_skybox(32, 32);
  render::PreparedSkybox rgb, indexed;
  rgb.update(skybox, {}, tables, render::PixelFormat::kRgb);
  indexed.update(skybox, {}, tables, render::PixelFormat::kIndexed);
  for (int seed = 0; seed < 30; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const render::ViewFrame view = any_view(*drawable.level, random, kSkyWidth, kSkyHeight).view;
    const auto rgb_scalar =
        draw<std::uint32_t>(rgb.spans(view), kSkyWidth, kSkyHeight, render::draw_skybox_spans_u32_scalar);
    const auto indexed_scalar =
        draw<std::uint8_t>(indexed.spans(view), kSkyWidth, kSkyHeight, render::draw_skybox_spans_u8_scalar);
    for_each_simd_target([&] {
      ASSERT_EQ(rgb_scalar, draw<std::uint32_t>(rgb.spans(view), kSkyWidth, kSkyHeight,
                                                render::draw_skybox_spans_u32_simd));
      ASSERT_EQ(indexed_scalar, draw<std::uint8_t>(indexed.spans(view), kSkyWidth, kSkyHeight,
                                                   render::draw_skybox_spans_u8_simd));
    });
  }
}

TEST(Skybox, IsMappedToThePalette) {
  const DrawableLevel drawable = small_level({.tiny = true});
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  render::Skybox skybox;
  for (formats::Image& image : skybox.sides) image = {1, 1, {0xff123456}};
  render::PreparedSkybox prepared;
  prepared.update(skybox, {}, tables, render::PixelFormat::kIndexed);
  Random random(1);
  const render::ViewFrame view = any_view(*drawable.level, random, 32, 32).view;
  for (const std::uint8_t pixel :
       draw<std::uint8_t>(prepared.spans(view), 32, 32, render::draw_skybox_spans_u8_scalar))
    ASSERT_EQ(pixel, tables.match({0x12, 0x34, 0x56}, true));
}

// In a frame: only where the level shows sky; another skybox gives another picture.
TEST(Skybox, TakesThePlaceOfTheSky) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  std::array<render::Skybox, 2> boxes;
  for (std::size_t i = 0; i < 2; ++i)
    for (formats::Image& image : boxes[i].sides) image = {1, 1, {i == 0 ? 0xff102030u : 0xff405060u}};
  std::size_t sky_pixels = 0;
  for (int number = 0; number < 10; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    Viewpoint viewpoint{.camera = random_camera(*drawable.level, random),
                        .brush_models = shown_brush_models(*drawable.level)};
    render::Scene scene = viewpoint.scene(*drawable.level);
    render::FrameBuffer without(160, 100, render::PixelFormat::kRgb),
        with(160, 100, render::PixelFormat::kRgb);
    renderer.render(scene, {}, without);
    std::vector<render::PixelFace> faces(without.pixel_count());
    std::vector<std::uint8_t> writes(without.pixel_count());
    renderer.pixel_faces(faces, writes);
    for (std::size_t i = 0; i < 2; ++i) {
      scene.skybox = &boxes[i];
      renderer.render(scene, {}, with);
      for (std::size_t pixel = 0; pixel < with.pixel_count(); ++pixel) {
        ASSERT_EQ(with.depth()[pixel], without.depth()[pixel]);
        const bool sky = faces[pixel].instance != render::PixelFace::kNothing &&
                         drawable.level->faces[faces[pixel].face].kind == world::FaceKind::kSky;
        sky_pixels += sky;
        ASSERT_EQ(with.rgb()[pixel], sky ? boxes[i].sides[0].pixels[0] : without.rgb()[pixel]);
      }
    }
  }
  EXPECT_GT(sky_pixels, 1000u);
}

// A side without a picture has the fog's color, or is black.
TEST(Skybox, ColorsSidesWithoutAPicture) {
  const DrawableLevel drawable = small_level({.tiny = true});
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  const render::Skybox empty;
  render::PreparedSkybox prepared;
  Random random(1);
  const render::ViewFrame view = any_view(*drawable.level, random, 32, 32).view;
  const auto color = [&](const render::Fog& fog) {
    prepared.update(empty, fog, tables, render::PixelFormat::kRgb);
    return draw<std::uint32_t>(prepared.spans(view), 32, 32, render::draw_skybox_spans_u32_scalar)[7];
  };
  EXPECT_EQ(color({}), 0xff000000u);
  EXPECT_EQ(color({0.1f, {1, 0.5f, 0}}), 0xffff8000u);
}

}  // namespace
}  // namespace temblor::test
