// Fog against its formula in double, pixel by pixel; and over a whole picture.
#include "render/color/fog.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "render/renderer.h"
#include "render/simd_targets.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::FogRow;

struct FogCase {
  std::vector<std::uint32_t> rgb;
  std::vector<std::uint8_t> indexed, rows;
  std::vector<float> depth;
  std::vector<float> step_end_depths;
  render::FogCurve curve = render::make_fog_curve();
  render::FogCells cells{};
  double rate = 0;
  FogRow row{};

  explicit FogCase(Random& random) : rows(65 * 256 + 3) {
    row.perspective = random.chance(0.7);
    rate = random.log_uniform(1e-4, 0.1);
    row.inverse_rate = static_cast<float>(1 / rate);
    row.has_sky = random.chance(0.5);
    row.color = static_cast<std::uint32_t>(random.bits()) | 0xff000000u;
    row.sky = static_cast<float>(random.uniform(1e-3, 2e-3));
    row.sky_step = 1.0f / 65536;
    row.sky_share = 128;
    const std::size_t count = random.below(200);
    for (std::size_t i = 0; i < count; ++i) {
      const double z = random.log_uniform(0.1, 1e5);
      depth.push_back(static_cast<float>(row.perspective ? 1 / z : -z));
      if (random.chance(0.2)) depth.back() = row.sky + static_cast<float>(i) * row.sky_step;
      if (random.chance(0.05)) depth.back() = std::numeric_limits<float>::lowest();
      rgb.push_back(static_cast<std::uint32_t>(random.bits()));
      indexed.push_back(static_cast<std::uint8_t>(random.bits()));
    }
    // The resulting index reveals the row.
    for (std::size_t i = 0; i < 65 * 256; ++i) rows[i] = static_cast<std::uint8_t>(i / 256);
    row.count = static_cast<std::int32_t>(count);
    for (const float end : curve.step_ends) {
      const double nearness = static_cast<double>(end);
      step_end_depths.push_back(static_cast<float>(
          row.perspective || std::isinf(nearness) ? nearness * rate : -1 / (nearness * rate)));
    }
    if (row.perspective) cells = render::make_fog_cells(step_end_depths.data());
  }
  FogRow ready(void* pixels) {
    row.pixels = pixels;
    row.depth = depth.data();
    row.rows = rows.data();
    row.curve = &curve;
    row.step_end_depths = step_end_depths.data();
    row.cells = row.perspective ? &cells : nullptr;
    return row;
  }
  double share(std::size_t i) const {
    if (row.has_sky && depth[i] == row.sky + static_cast<float>(i) * row.sky_step) return 0.5;
    double z = -static_cast<double>(depth[i]);
    if (row.perspective)
      z = depth[i] > 0 ? 1 / static_cast<double>(depth[i]) : std::numeric_limits<double>::infinity();
    return 1 - std::exp(-std::pow(rate * z, 2));
  }
};

void expect_the_formula(void (*fog_u8)(const FogRow&), void (*fog_u32)(const FogRow&)) {
  for (int seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    FogCase drawn(random);
    const FogCase before = drawn;
    fog_u8(drawn.ready(drawn.indexed.data()));
    fog_u32(drawn.ready(drawn.rgb.data()));
    for (std::size_t i = 0; i < before.depth.size(); ++i) {
      const double share = before.share(i);
      ASSERT_NEAR(drawn.indexed[i], share * 64, 0.501) << i;
      ASSERT_EQ(drawn.rgb[i] >> 24, before.rgb[i] >> 24);
      for (int shift = 0; shift < 24; shift += 8) {
        const double own = before.rgb[i] >> shift & 255, fog = before.row.color >> shift & 255;
        ASSERT_NEAR(drawn.rgb[i] >> shift & 255, own + (fog - own) * share, 1.1) << i;
      }
    }
  }
}

void plain_u8(const FogRow& row) {
  render::fog_row_u8_scalar(row);
}
void plain_u32(const FogRow& row) {
  render::fog_row_u32_scalar(row);
}

TEST(FogCurve, IsTheFormulaInSteps) {
  const render::FogCurve curve = render::make_fog_curve();
  for (int step = 1; step <= render::kFogSteps; ++step) {
    const double end = static_cast<double>(curve.step_ends[step]);
    EXPECT_NEAR(1 - std::exp(-1 / (end * end)), (step - 0.5) / render::kFogSteps, 1e-6);
  }
  for (float x = render::kMinNearness; x < render::kMaxNearness; x *= 1.001f) {
    const auto piece = std::bit_cast<std::uint32_t>(x) >> 22 & 15;
    float share = 0;
    for (int power = 3; power >= 0; --power) share = share * x + curve.cubic[power][piece];
    const double nearness = static_cast<double>(x);
    ASSERT_NEAR(static_cast<double>(share), 256 * (1 - std::exp(-1 / (nearness * nearness))) + 0.5, 0.1) << x;
  }
}

// Against the search, around each end of a step and at extreme depths.
TEST(FogCells, FindTheSameSteps) {
  const render::FogCurve curve = render::make_fog_curve();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (float rate = 1e-6f; rate < 10; rate *= 1.37f) {
    std::vector<float> ends;
    for (const float end : curve.step_ends) ends.push_back(end * rate);
    const render::FogCells cells = render::make_fog_cells(ends.data());
    const auto expect_step = [&](float depth) {
      const std::int32_t cell = render::find_fog_cell(cells, depth);
      const int step = cells.steps[cell] + (depth < cells.ends[cell] ? 1 : 0);
      ASSERT_EQ(step, render::fog_step_at(ends.data(), depth)) << depth << ", rate " << rate;
    };
    for (const float end : ends)
      for (const float depth : {std::nextafter(end, -kInfinity), end, std::nextafter(end, kInfinity)})
        if (std::isfinite(depth)) expect_step(depth);
    for (const float depth :
         {-kInfinity, std::numeric_limits<float>::lowest(), -1.0f, -0.0f, 0.0f, 1e-38f, 1e38f, kInfinity})
      expect_step(depth);
    for (float depth = rate / 8; depth < 64 * rate; depth *= 1.0007f) expect_step(depth);
  }
}

TEST(FogRow, FollowsTheFormula) {
  expect_the_formula(plain_u8, plain_u32);
  for_each_simd_target([] { expect_the_formula(render::fog_row_u8_simd, render::fog_row_u32_simd); });
}

TEST(FogRow, IsTheSameInSimd) {
  for_each_simd_target([] {
    for (int seed = 0; seed < 300; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      FogCase plain(random);
      FogCase vector = plain;
      plain_u8(plain.ready(plain.indexed.data()));
      plain_u32(plain.ready(plain.rgb.data()));
      render::fog_row_u8_simd(vector.ready(vector.indexed.data()));
      render::fog_row_u32_simd(vector.ready(vector.rgb.data()));
      ASSERT_EQ(plain.indexed, vector.indexed) << seed;
      ASSERT_EQ(plain.rgb, vector.rgb) << seed;
    }
  });
}

// A level's fog may have any density.
TEST(Fog, IsTheSameInSimdAtExtremeDensities) {
  const DrawableLevel drawable = small_level();
  const render::ColorTables colors = render::make_color_tables(drawable.palette, drawable.colormap);
  for (const float density :
       {1e-45f, 1e-38f, 1e-29f, 1.0f, 1e31f, 1e38f, std::numeric_limits<float>::infinity()}) {
    std::vector<std::uint8_t> pixels[2];
    for (const bool simd : {false, true}) {
      render::FogTables tables;
      const render::FrameFog fog({density, {0.3f, 0.5f, 0.7f}}, true, render::PixelFormat::kIndexed, colors,
                                 tables, simd);
      std::vector<float> depths;
      for (int i = 0; i < 200; ++i) {
        depths.push_back(std::ldexp(1.0f, i - 100));
        pixels[simd].push_back(static_cast<std::uint8_t>(i));
      }
      fog.apply(pixels[simd].data(), depths);
    }
    EXPECT_EQ(pixels[0], pixels[1]) << density;
  }
}

// Every pixel of a foggy picture is that of the clear picture, fogged by its depth; sky by half.
TEST(Fog, CoversThePictureByItsDepth) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  std::size_t sky_pixels = 0, others = 0;
  for (int number = 0; number < 12; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    Viewpoint viewpoint{.camera = random_camera(level, random), .brush_models = shown_brush_models(level)};
    render::Scene scene = viewpoint.scene(level);
    render::Renderer renderer(drawable.palette, drawable.colormap);
    render::FrameBuffer clear(160, 100, render::PixelFormat::kRgb),
        foggy(160, 100, render::PixelFormat::kRgb);
    renderer.render(scene, {}, clear);
    std::vector<render::PixelFace> faces(clear.pixel_count());
    std::vector<std::uint8_t> writes(clear.pixel_count());
    renderer.pixel_faces(faces, writes);
    scene.fog = {0.4f, {0.3f, 0.5f, 0.7f}};
    renderer.render(scene, {}, foggy);
    for (std::size_t i = 0; i < clear.pixel_count(); ++i) {
      ASSERT_EQ(clear.depth()[i], foggy.depth()[i]);
      const bool sky = faces[i].instance != render::PixelFace::kNothing &&
                       level.faces[faces[i].face].kind == world::FaceKind::kSky;
      ++(sky ? sky_pixels : others);
      const double thickness = 0.4 / 64 / static_cast<double>(clear.depth()[i]);
      const double share = sky ? 0.5 : 1 - std::exp(-thickness * thickness);
      const std::uint32_t colors[3] = {179, 128, 77};  // blue, green, red
      for (int channel = 0; channel < 3; ++channel) {
        const double own = clear.rgb()[i] >> (8 * channel) & 255;
        ASSERT_NEAR(foggy.rgb()[i] >> (8 * channel) & 255, own + (colors[channel] - own) * share, 1.1)
            << "view " << number << ", pixel " << i;
      }
    }
  }
  EXPECT_GT(sky_pixels, 500u);
  EXPECT_GT(others, 1000u);
}

}  // namespace
}  // namespace temblor::test
