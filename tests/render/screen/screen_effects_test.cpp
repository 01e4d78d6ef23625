// The underwater warp and tints, pixel by pixel against their definitions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "render/present.h"
#include "render/renderer.h"
#include "render/screen/tint_kernels.h"
#include "render/screen/tint_picture.h"
#include "render/screen/warp.h"
#include "render/simd_targets.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::FrameBuffer;
using render::PixelFormat;

// Each pixel has its own number.
FrameBuffer numbered_frame(int width, int height) {
  FrameBuffer frame(width, height, PixelFormat::kRgb);
  for (std::size_t i = 0; i < frame.pixel_count(); ++i) {
    frame.rgb()[i] = static_cast<std::uint32_t>(i);
    frame.depth()[i] = static_cast<float>(i);
  }
  return frame;
}

TEST(Warp, TakesEveryPixelFromWhereTheSinesSay) {
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  for (const auto& [width, height] : {std::pair{320, 200}, {333, 217}, {1280, 720}, {90, 160}})
    for (const double time_s : {0.0, 1.7, 1e6}) {
      FrameBuffer frame = numbered_frame(width, height);
      render::Warp().apply(time_s, {}, jobs, frame);
      const double scale = std::min(width, height) / 200.0;
      const auto sway = [&](int along) {
        return 3 * scale * std::sin(2 * std::numbers::pi * (along / (128 * scale) + time_s * 20 / 128));
      };
      const double margin = std::ceil(3 * scale);
      const auto place = [&](int i, int size) { return margin + i * (size - 1 - 2 * margin) / (size - 1); };
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const auto i =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
          ASSERT_EQ(frame.depth()[i], static_cast<float>(i));
          const int from_x = static_cast<int>(frame.rgb()[i]) % width;
          const int from_y = static_cast<int>(frame.rgb()[i]) / width;
          // Two numbers are rounded for each pixel.
          ASSERT_NEAR(from_x, place(x, width) + sway(y), 1.001) << x << "," << y;
          ASSERT_NEAR(from_y, place(y, height) + sway(x), 1.001) << x << "," << y;
        }
    }
}

// The displacement is the same fraction of the picture, whatever its size.
TEST(Warp, LooksAlikeAtEverySize) {
  base::Jobs jobs(1);
  FrameBuffer small = numbered_frame(320, 200), large = numbered_frame(3200, 2000);
  render::Warp warp;
  warp.apply(0.3, {}, jobs, small);
  warp.apply(0.3, {}, jobs, large);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) {
      const std::uint32_t a = small.rgb()[static_cast<std::size_t>(y * 320 + x)];
      const std::uint32_t b = large.rgb()[static_cast<std::size_t>((y * 10 + 5) * 3200 + x * 10 + 5)];
      ASSERT_NEAR(a % 320, b % 3200 / 10.0, 1.7) << x << "," << y;
      ASSERT_NEAR(a / 320, b / 3200 / 10.0, 1.7) << x << "," << y;
    }
}

TEST(Warp, StaysInsideTheSmallestPictures) {
  base::Jobs jobs(1);
  render::Warp warp;
  for (int width = 1; width < 9; ++width)
    for (int height = 1; height < 9; ++height) {
      FrameBuffer frame = numbered_frame(width, height);
      warp.apply(0.4, {}, jobs, frame);
      for (const std::uint32_t pixel : frame.rgb()) ASSERT_LT(pixel, frame.pixel_count());
    }
}

TEST(Warp, IsTheSameInBothFormatsAndForAnyThreads) {
  base::Jobs one(1), four(4, base::JobBackend::kStdThread);
  FrameBuffer rgb(217, 133, PixelFormat::kRgb), indexed(217, 133, PixelFormat::kIndexed);
  Random random(1);
  for (std::size_t i = 0; i < rgb.pixel_count(); ++i)
    rgb.rgb()[i] = indexed.indexed()[i] = static_cast<std::uint8_t>(random.bits());
  render::Warp().apply(2.5, {}, one, rgb);
  render::Warp().apply(2.5, {}, four, indexed);
  for (std::size_t i = 0; i < rgb.pixel_count(); ++i) ASSERT_EQ(rgb.rgb()[i], indexed.indexed()[i]);
}

TEST(Warp, TintsWhatItMoves) {
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  for (unsigned seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const int width = 1 + static_cast<int>(random.below(300)),
              height = 1 + static_cast<int>(random.below(200));
    FrameBuffer together(width, height, PixelFormat::kRgb), apart(width, height, PixelFormat::kRgb);
    for (std::size_t i = 0; i < together.rgb().size(); ++i)
      together.rgb()[i] = apart.rgb()[i] = 0xff000000u | static_cast<std::uint32_t>(random.bits());
    const render::PictureTint tint({{255, 80, 0}, 0.3f}, PixelFormat::kRgb, true);
    render::Warp warp;
    warp.apply(seed, tint, jobs, together);
    warp.apply(seed, {}, jobs, apart);
    render::tint_picture(tint, jobs, apart);
    ASSERT_TRUE(std::ranges::equal(together.rgb(), apart.rgb())) << seed;
  }
}

TEST(TintKernels, BlendEveryChannel) {
  for (int seed = 0; seed < 100; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<std::uint32_t> before(random.below(100));
    for (std::uint32_t& pixel : before) pixel = static_cast<std::uint32_t>(random.bits());
    const auto color = static_cast<std::uint32_t>(random.bits());
    const auto opacity = static_cast<std::int32_t>(random.below(257));
    std::vector<std::uint32_t> expected = before;
    for (std::uint32_t& pixel : expected) {
      std::uint32_t out = 0xff000000u;
      for (int shift = 0; shift < 24; shift += 8) {
        const double mean =
            ((color >> shift & 255) * opacity + (pixel >> shift & 255) * (256.0 - opacity)) / 256;
        out |= static_cast<std::uint32_t>(std::floor(mean + 0.5)) << shift;
      }
      pixel = out;
    }
    std::vector<std::uint32_t> drawn = before;
    render::tint_rgb_scalar({drawn.data(), drawn.size(), color, opacity});
    ASSERT_EQ(drawn, expected) << seed;
    for_each_simd_target([&] {
      drawn = before;
      render::tint_rgb_simd({drawn.data(), drawn.size(), color, opacity});
      ASSERT_EQ(drawn, expected) << seed;
    });
  }
}

TEST(Tint, ChangesThePaletteOfIndexedFrames) {
  const DrawableLevel drawable = small_level({.tiny = true});
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const Viewpoint viewpoint{.camera = player_cameras(*drawable.level).at(0)};
  render::Scene scene = viewpoint.scene(*drawable.level);
  const auto draw_scene = [&](PixelFormat format) {
    FrameBuffer frame(160, 100, format);
    renderer.render(scene, {}, frame);
    return frame;
  };
  const FrameBuffer plain = draw_scene(PixelFormat::kIndexed);
  for (const bool underwater : {false, true})
    for (const float opacity : {0.1f, 0.5f, 0.9f, 1.0f}) {
      scene.underwater = underwater;
      scene.tint = {{255, 80, 0}, opacity};
      const FrameBuffer frame = draw_scene(PixelFormat::kIndexed);
      EXPECT_TRUE(underwater || copy_picture(frame) == copy_picture(plain));
      const formats::Palette shown = render::shown_palette(frame, drawable.palette);
      const auto blend = [&](int own, int tint) {
        return static_cast<int>(
            std::floor(own + (tint - own) * std::round(double{opacity} * 256) / 256 + 0.5));
      };
      for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_EQ(shown[i].r, blend(drawable.palette[i].r, 255)) << i;
        EXPECT_EQ(shown[i].g, blend(drawable.palette[i].g, 80)) << i;
        EXPECT_EQ(shown[i].b, blend(drawable.palette[i].b, 0)) << i;
      }
    }
  const FrameBuffer rgb = draw_scene(PixelFormat::kRgb);
  EXPECT_EQ(rgb.palette_tint().opacity, 0) << "its pixels are tinted";
}

TEST(Tint, WithoutOpacityChangesNothing) {
  base::Jobs jobs(1);
  FrameBuffer frame(31, 7, PixelFormat::kRgb);
  fill_frame(frame, 0x5a);
  const FrameCopy before = copy_picture(frame);
  for (const float opacity : {0.0f, -1.0f}) {
    const render::Tint none{{255, 80, 0}, opacity};
    render::tint_picture({none, frame.format(), true}, jobs, frame);
    EXPECT_TRUE(copy_picture(frame) == before);
    FrameBuffer indexed(31, 7, PixelFormat::kIndexed);
    indexed.set_palette_tint(none);
    const formats::Palette palette = small_level({.tiny = true}).palette;
    EXPECT_EQ(render::shown_palette(indexed, palette), palette);
  }
}

}  // namespace
}  // namespace temblor::test
