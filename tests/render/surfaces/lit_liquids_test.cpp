// Liquids with light maps: a level whose ordinary textures are all renamed to liquids, in many views.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "artgen/small_level.h"
#include "render/color/warped_rows.h"
#include "render/renderer.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

constexpr std::uint8_t kAsStored = 128;  // the light that shows colors as they are

constexpr int kWetWidth = 160, kWetHeight = 120;

enum class Flags : std::int32_t { kLit = 0, kNeverLit = 1 };

// Faces have style 0 only, so that `light` is all of their light. Every `without_samples`th face has no
// samples; 0: all have them.
std::shared_ptr<const world::Level> wet_level(Flags flags, std::uint8_t light, std::int32_t offset = 0,
                                              std::size_t without_samples = 0) {
  static const formats::Bsp dry = artgen::make_small_level({});
  formats::Bsp bsp = dry;
  for (formats::BspMiptex& texture : bsp.miptexes)
    if (texture.present && !texture.name.starts_with("sky")) texture.name = "*" + texture.name.substr(0, 14);
  for (formats::BspTexinfo& texinfo : bsp.texinfos) texinfo.flags = static_cast<std::int32_t>(flags);
  for (formats::BspFace& face : bsp.faces) {
    if (face.light_offset >= 0) face.light_offset += offset;
    if (face.styles[0] != 255) face.styles = {0, 255, 255, 255};
  }
  for (std::size_t i = 0; without_samples > 0 && i < bsp.faces.size(); i += without_samples)
    bsp.faces[i].light_offset = -1;
  std::ranges::fill(bsp.lighting, light);
  return world::make_level(std::move(bsp), "wet").value();
}

struct WetView {
  std::shared_ptr<const world::Level> level;
  DrawableLevel look = small_level();
  Viewpoint viewpoint;

  WetView(std::shared_ptr<const world::Level> of, std::uint64_t seed) : level(std::move(of)) {
    Random random(seed);
    viewpoint.camera = random_camera(*level, random);
    viewpoint.time_s = random.uniform(0, 100);
  }
  // `out_faces`: the faces of all pixels, or empty.
  FrameCopy draw(const render::Settings& settings = {}, PixelFormat format = PixelFormat::kIndexed,
                 std::span<render::PixelFace> out_faces = {}) const {
    render::Renderer renderer(look.palette, look.colormap);
    render::FrameBuffer frame(kWetWidth, kWetHeight, format);
    render::Scene scene = viewpoint.scene(*level);
    scene.light_styles.fill(256);
    renderer.render(scene, settings, frame);
    std::vector<std::uint8_t> writes(out_faces.size());
    if (!out_faces.empty()) renderer.pixel_faces(out_faces, writes);
    return copy_picture(frame);
  }
};

double mean_brightness(const FrameCopy& picture) {
  double sum = 0;
  for (const std::uint32_t color : picture.rgb)
    sum += (color >> 16 & 255) + (color >> 8 & 255) + (color & 255);
  return sum / static_cast<double>(picture.rgb.size());
}

constexpr std::uint64_t kWetViews = 4;

// Blocks are warped at whole texels, so pixels beside the border of a texel may differ.
TEST(LitLiquids, LightAsStoredShowsTheWarpedTexture) {
  std::size_t same = 0, all = 0;
  for (std::uint64_t seed = 0; seed < kWetViews; ++seed) {
    const render::Settings settings{.force_mip = 0};
    const FrameCopy unlit = WetView(wet_level(Flags::kNeverLit, kAsStored), seed).draw(settings);
    const WetView view(wet_level(Flags::kLit, kAsStored), seed);
    std::vector<render::PixelFace> faces(kWetWidth * kWetHeight);
    const FrameCopy lit = view.draw(settings, PixelFormat::kIndexed, faces);
    EXPECT_EQ(lit.depth_bits, unlit.depth_bits);
    for (std::size_t i = 0; i < lit.indexed.size(); ++i) {
      if (faces[i].face == render::PixelFace::kNothing) continue;
      same += lit.indexed[i] == unlit.indexed[i];
      ++all;
    }
  }
  EXPECT_GT(all, 1000u);
  EXPECT_GT(static_cast<double>(same), 0.75 * static_cast<double>(all));
}

TEST(LitLiquids, FollowTheLight) {
  for (std::uint64_t seed = 0; seed < kWetViews; ++seed) {
    double before = -1;
    for (const std::uint8_t light : {std::uint8_t{0}, std::uint8_t{60}, kAsStored, std::uint8_t{200}}) {
      const double now =
          mean_brightness(WetView(wet_level(Flags::kLit, light), seed).draw({}, PixelFormat::kRgb));
      EXPECT_GT(now, before) << "seed " << seed << ", light " << int{light};
      before = now;
    }
  }
}

TEST(LitLiquids, CanBeTurnedOff) {
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (std::uint64_t seed = 0; seed < kWetViews; ++seed)
      EXPECT_EQ(WetView(wet_level(Flags::kLit, 10), seed).draw({.lit_liquids = false}, format),
                WetView(wet_level(Flags::kLit, kAsStored), seed).draw({}, format))
          << "seed " << seed;
}

// Compilers of old marked liquids as never lit; some left offsets of light that is not there.
TEST(LitLiquids, WithoutLightOfTheirOwnAreAsBefore) {
  for (std::uint64_t seed = 0; seed < kWetViews; ++seed) {
    const FrameCopy never = WetView(wet_level(Flags::kNeverLit, 10), seed).draw();
    EXPECT_EQ(WetView(wet_level(Flags::kNeverLit, 200), seed).draw(), never);
    EXPECT_EQ(WetView(wet_level(Flags::kLit, 10, 1 << 28), seed).draw(), never);
    EXPECT_EQ(WetView(wet_level(Flags::kNeverLit, 10), seed).draw({.lit_liquids = false}), never);
  }
}

// Every other face has no samples, as if no light reached it: it looks as in a level without any light.
TEST(LitLiquids, AreDarkWithoutSamplesBesideLitOnes) {
  const std::shared_ptr<const world::Level> whole = wet_level(Flags::kLit, 90);
  const std::shared_ptr<const world::Level> half = wet_level(Flags::kLit, 90, 0, 2);
  std::size_t dark = 0, lit = 0;
  for (std::uint64_t seed = 0; seed < kWetViews; ++seed) {
    std::vector<render::PixelFace> faces(kWetWidth * kWetHeight);
    const FrameCopy picture = WetView(half, seed).draw({}, PixelFormat::kRgb, faces);
    const FrameCopy black = WetView(wet_level(Flags::kLit, 0), seed).draw({}, PixelFormat::kRgb);
    const FrameCopy bright = WetView(whole, seed).draw({}, PixelFormat::kRgb);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (faces[i].face == render::PixelFace::kNothing) continue;
      const bool is_dark = faces[i].face % 2 == 0;
      (is_dark ? dark : lit) += 1;
      ASSERT_EQ(picture.rgb[i], (is_dark ? black : bright).rgb[i]) << "face " << faces[i].face;
    }
  }
  EXPECT_GT(dark, 1000u);
  EXPECT_GT(lit, 1000u);
}

TEST(LitLiquids, DoNotDependOnThreadsKernelsOrCache) {
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (std::uint64_t seed = 0; seed < kWetViews; ++seed) {
      const WetView view(wet_level(Flags::kLit, 90), seed);
      const FrameCopy picture = view.draw({.threads = 1}, format);
      EXPECT_EQ(view.draw({.threads = 3}, format), picture);
      EXPECT_EQ(view.draw({.simd_kernels = false}, format), picture);
      EXPECT_EQ(view.draw({.surface_cache = false}, format), picture);
    }
}

TEST(LitLiquids, MoveWithTime) {
  WetView view(wet_level(Flags::kLit, 90), 3);
  const FrameCopy before = view.draw();
  view.viewpoint.time_s += 0.3;
  EXPECT_NE(view.draw(), before);
}

// Each texel by the formula: displaced by 8 * (1 + sin) with a period of 128 texels of mip 0.
TEST(WarpedRows, FollowTheFormula) {
  world::Texture texture;
  texture.width = 64;
  texture.height = 32;
  constexpr double kPhase = 37.25;
  for (int mip = 0; mip < 4; ++mip) {
    base::Arena arena;
    const std::int64_t s0 = -100, t0 = 60;
    constexpr std::size_t kWidth = 50;
    render::WarpedRows rows(texture, mip, s0, t0, kWidth, kPhase, arena);
    for (std::int32_t y = 0; y < 40; ++y) {
      const std::span<const std::int32_t> row = rows.row(y);
      for (std::size_t x = 0; x < kWidth; ++x) {
        const double scale = 1 << mip;
        const double s = (static_cast<double>(s0) + static_cast<double>(x) + 0.5) * scale;
        const double t = (static_cast<double>(t0) + y + 0.5) * scale;
        const auto shift = [](double at) {
          return 8 * (1 + std::sin((at + kPhase) / 128 * 2 * std::numbers::pi));
        };
        const auto texel = [&](double at, std::int64_t size) {
          const auto whole = static_cast<std::int64_t>(std::floor(at / scale + 1e-12));
          return (whole % size + size) % size;
        };
        const std::int64_t column = texel(s + shift(t), 64 >> mip), line = texel(t + shift(s), 32 >> mip);
        ASSERT_EQ(row[x], line * (64 >> mip) + column) << mip << " " << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace temblor::test
