// 2-D drawing against the definition: for each pixel of the frame, which pixel of which picture is over it.
#include "render/screen/draw_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/color/color_tables.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/pictures/random_overlay.h"
#include "support/pictures/some_colors.h"
#include "support/random.h"

namespace temblor::test {
namespace {

// 0: the mode does not multiply.
double product_factor(render::DrawMode mode) {
  return mode == render::DrawMode::kMultiply ? 1 : mode == render::DrawMode::kMultiplyTwice ? 2 : 0;
}

bool is_inside(const render::ScreenRect& area, int x, int y) {
  const std::int64_t across = std::int64_t{x} - area.x, down = std::int64_t{y} - area.y;
  return across >= 0 && down >= 0 && across < area.width && down < area.height;
}

// The pixel of a part that is under the center of pixel `offset` of an area.
std::int64_t stretched(std::int64_t offset, int part, int size) {
  return static_cast<std::int64_t>(
      std::floor((static_cast<double>(offset) + 0.5) * part / static_cast<double>(size)));
}

// The palette index that a command draws at a pixel, before a tint or a translation; 256: none.
int index_at(const render::DrawCommand& command, int x, int y) {
  if (!is_inside(command.area, x, y) || (command.clip && !is_inside(*command.clip, x, y))) return 256;
  if (command.picture == nullptr) return command.fill;
  const std::int64_t across = std::int64_t{x} - command.area.x, down = std::int64_t{y} - command.area.y;
  const bool is_stretched = command.part_width > 0;
  const std::int64_t column =
      command.part_x +
      (is_stretched ? stretched(across, command.part_width, command.area.width) : across / command.scale);
  const std::int64_t row =
      command.part_y +
      (is_stretched ? stretched(down, command.part_height, command.area.height) : down / command.scale);
  const std::uint8_t texel =
      command.picture->pixels[static_cast<std::size_t>(row * std::int64_t{command.picture->width} + column)];
  return texel == 255 ? 256 : texel;
}

std::uint8_t indexed_color(const render::DrawCommand& command, int index) {
  const auto i = static_cast<std::size_t>(index);
  if (command.tint != nullptr) return command.tint->indices[i];
  return command.translation != nullptr ? (*command.translation)[i] : static_cast<std::uint8_t>(index);
}

std::uint32_t rgb_color(const render::DrawCommand& command, int index) {
  if (command.tint != nullptr) return command.tint->rgb[static_cast<std::size_t>(index)];
  return some_tables().rgb[indexed_color(command, index)];
}

// A channel of two blended colors, up to rounding.
bool is_mixed(int got, int over, int under, double opacity) {
  return std::abs(got - (over * opacity + under * (1 - opacity))) <= 1.0;
}

void expect_pixel(const render::DrawCommand& command, int index, std::uint32_t before, std::uint32_t after) {
  if (index == 256 || !(command.opacity > 0)) {
    ASSERT_EQ(after, before);
  } else if (command.mode == render::DrawMode::kAdd) {
    const std::uint32_t over = rgb_color(command, index);
    for (int shift = 0; shift < 24; shift += 8)
      ASSERT_EQ(after >> shift & 255, std::min((over >> shift & 255) + (before >> shift & 255), 255u));
    ASSERT_EQ(after >> 24, 255u);
  } else if (const double factor = product_factor(command.mode); factor > 0) {
    const std::uint32_t over = rgb_color(command, index);
    for (int shift = 0; shift < 24; shift += 8) {
      const double below = before >> shift & 255;
      const double product = std::min((over >> shift & 255) * below / 255 * factor, 255.0);
      const double opacity = std::min(static_cast<double>(command.opacity), 1.0);
      ASSERT_NEAR(after >> shift & 255, product * opacity + below * (1 - opacity), 1.5);
    }
    ASSERT_EQ(after >> 24, 255u);
  } else if (command.opacity >= 1) {
    ASSERT_EQ(after, rgb_color(command, index));
  } else {
    const std::uint32_t over = rgb_color(command, index);
    for (int shift = 0; shift < 24; shift += 8)
      ASSERT_TRUE(is_mixed(after >> shift & 255, over >> shift & 255, before >> shift & 255,
                           static_cast<double>(command.opacity)));
    ASSERT_EQ(after >> 24, 255u);
  }
}

// No palette entry is much nearer to the exact product than the result.
void expect_product(const render::DrawCommand& command, int index, std::uint8_t before, std::uint8_t after) {
  const formats::Palette& palette = some_tables().palette;
  const formats::Rgb &over = palette[indexed_color(command, index)], &under = palette[before];
  const double opacity = std::min(static_cast<double>(command.opacity), 1.0);
  const double factor = product_factor(command.mode);
  const auto distance_from = [&](const formats::Rgb& entry) {
    const auto difference = [&](int got, int a, int b) {
      return got - (std::min(a * b / 255.0 * factor, 255.0) * opacity + b * (1 - opacity));
    };
    return std::hypot(difference(entry.r, over.r, under.r), difference(entry.g, over.g, under.g),
                      difference(entry.b, over.b, under.b));
  };
  double nearest = 1e9;
  for (std::size_t i = 0; i < 255; ++i) nearest = std::min(nearest, distance_from(palette[i]));
  ASSERT_LE(distance_from(palette[after]), nearest + 3);
}

// Uses the table for the nearest sixteenth; another test checks its colors.
void expect_indexed_pixel(const render::DrawCommand& command, int index, std::uint8_t before,
                          std::uint8_t after) {
  if (index == 256 || !(command.opacity > 0)) {
    ASSERT_EQ(after, before);
  } else if (command.mode == render::DrawMode::kAdd) {
    ASSERT_EQ(after, some_tables().blends.sums()[indexed_color(command, index) * 256 + before]);
  } else if (product_factor(command.mode) > 0)
    expect_product(command, index, before, after);
  else if (command.opacity >= 1) {
    ASSERT_EQ(after, indexed_color(command, index));
  } else {
    ASSERT_EQ(after,
              some_tables().blends.table_for(command.opacity)[indexed_color(command, index) * 256 + before]);
  }
}

TEST(DrawOverlay, PutsEveryPixelWhereItBelongs) {
  base::Jobs three(3, base::JobBackend::kStdThread);
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(effort(2000, 150)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const formats::Picture picture = random_picture(random);
    const render::ColorTranslation translation = random_translation(random);
    const render::ColorTint tint = random_color_tint(random);
    render::DrawCommand command = random_command(picture, translation, random);
    decorate_command(command, tint, random);
    const int width = 1 + static_cast<int>(random.below(120)),
              height = 1 + static_cast<int>(random.below(90));
    render::FrameBuffer indexed(width, height, render::PixelFormat::kIndexed);
    render::FrameBuffer rgb(width, height, render::PixelFormat::kRgb);
    for (std::uint8_t& pixel : indexed.indexed()) pixel = static_cast<std::uint8_t>(random.bits());
    for (std::uint32_t& pixel : rgb.rgb()) pixel = static_cast<std::uint32_t>(random.bits()) | 0xff000000u;
    const std::vector<std::uint8_t> indexed_before(indexed.indexed().begin(), indexed.indexed().end());
    const std::vector<std::uint32_t> rgb_before(rgb.rgb().begin(), rgb.rgb().end());
    base::Jobs* const jobs = seed % 2 == 0 ? &three : nullptr;
    render::draw_overlay({{command}}, some_tables(), jobs, indexed);
    render::draw_overlay({{command}}, some_tables(), jobs, rgb);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::size_t i = static_cast<std::size_t>(y * width + x);
        const int index = index_at(command, x, y);
        ASSERT_NO_FATAL_FAILURE(expect_pixel(command, index, rgb_before[i], rgb.rgb()[i])) << x << "," << y;
        ASSERT_NO_FATAL_FAILURE(expect_indexed_pixel(command, index, indexed_before[i], indexed.indexed()[i]))
            << x << "," << y;
      }
  }
}

// A picture of 2 x 1 pixels, and a detail of 4 x 2 texels with the colors 1 to 8.
formats::Picture make_detailed_picture(std::uint32_t alpha) {
  auto detail = std::make_shared<formats::PictureDetail>();
  detail->width = 4;
  detail->height = 2;
  for (std::uint32_t i = 1; i <= 8; ++i) {
    detail->colors.push_back(alpha << 24 | i * 0x101010);
    detail->indices.push_back(i == 8 ? std::uint8_t{255} : static_cast<std::uint8_t>(i));
  }
  return {2, 1, {100, 101}, detail};
}

TEST(DrawOverlay, ShowsDetailsAtThePicturesSize) {
  const formats::Picture picture = make_detailed_picture(255);
  render::FrameBuffer rgb(8, 4, render::PixelFormat::kRgb), indexed(8, 4, render::PixelFormat::kIndexed);
  const auto draw = [&](const render::DrawCommand& command) {
    std::ranges::fill(rgb.rgb(), 0xff000000u);
    std::ranges::fill(indexed.indexed(), std::uint8_t{50});
    render::draw_overlay({{command}}, some_tables(), nullptr, rgb);
    render::draw_overlay({{command}}, some_tables(), nullptr, indexed);
  };
  const auto expect_texels = [&](std::uint32_t first_column, std::uint32_t columns, std::uint32_t width) {
    for (std::uint32_t y = 0; y < 4; ++y)
      for (std::uint32_t x = 0; x < width; ++x) {
        const std::uint32_t texel = y / 2 * 4 + first_column + x * columns / width + 1;
        EXPECT_EQ(rgb.rgb()[y * 8 + x], 0xff000000u | texel * 0x101010) << x << "," << y;
        EXPECT_EQ(indexed.indexed()[y * 8 + x], texel == 8 ? 50 : texel) << x << "," << y;
      }
  };
  draw({.picture = &picture, .area = {0, 0, 8, 4}, .scale = 4});
  expect_texels(0, 4, 8);
  draw({.picture = &picture, .area = {0, 0, 8, 4}, .part_width = 2, .part_height = 1});
  expect_texels(0, 4, 8);
  draw({.picture = &picture, .area = {0, 0, 4, 4}, .part_x = 1, .scale = 4});
  expect_texels(2, 2, 4);
  EXPECT_EQ(rgb.rgb()[4], 0xff000000u) << "only the area";
  const render::ColorTranslation translation{};
  draw({.picture = &picture, .area = {0, 0, 8, 4}, .scale = 4, .translation = &translation});
  EXPECT_EQ(indexed.indexed()[0], 0) << "a translation is for the picture's own pixels";
}

TEST(DrawOverlay, BlendsDetailsByTheirOpacity) {
  const formats::Picture half = make_detailed_picture(128), clear = make_detailed_picture(0);
  render::FrameBuffer frame(2, 1, render::PixelFormat::kRgb);
  const auto draw = [&](const formats::Picture& picture, float opacity) {
    std::ranges::fill(frame.rgb(), 0xff808080u);
    render::draw_overlay({{{.picture = &picture, .area = {0, 0, 2, 1}, .opacity = opacity}}}, some_tables(),
                         nullptr, frame);
    return static_cast<int>(frame.rgb()[0] & 255);
  };
  // The texel under the pixel's center is number 6: 0x60.
  EXPECT_NEAR(draw(half, 1), (0x60 + 0x80) / 2, 1);
  EXPECT_NEAR(draw(half, 0.5f), 0x60 / 4 + 0x80 * 3 / 4, 1);
  EXPECT_EQ(draw(clear, 1), 0x80);
}

TEST(DrawOverlay, BlendsPaletteIndicesOfDetailsByTheirOpacity) {
  const auto draw = [](std::uint32_t alpha, float opacity, render::DrawMode mode) {
    const formats::Picture picture = make_detailed_picture(alpha);
    render::FrameBuffer frame(2, 1, render::PixelFormat::kIndexed);
    std::ranges::fill(frame.indexed(), std::uint8_t{50});
    render::draw_overlay({{{.picture = &picture, .area = {0, 0, 2, 1}, .opacity = opacity, .mode = mode}}},
                         some_tables(), nullptr, frame);
    return frame.indexed()[0];
  };
  // The texel under the pixel's center is number 6.
  const render::ColorTables& tables = some_tables();
  const auto blend = [&](float opacity, std::uint8_t under) {
    return tables.blends.table_for(opacity)[6 * 256 + under];
  };
  EXPECT_EQ(draw(128, 1, render::DrawMode::kBlend), blend(0.5f, 50));
  EXPECT_EQ(draw(128, 0.5f, render::DrawMode::kBlend), blend(0.25f, 50));
  EXPECT_EQ(draw(32, 1, render::DrawMode::kBlend), blend(0.125f, 50));
  EXPECT_EQ(draw(4, 1, render::DrawMode::kBlend), 50);
  EXPECT_EQ(draw(252, 1, render::DrawMode::kBlend), 6);
  EXPECT_EQ(draw(128, 1, render::DrawMode::kAdd), tables.blends.sums()[blend(0.5f, tables.black) * 256 + 50]);
  const formats::Rgb &over = tables.palette[6], &under = tables.palette[50];
  const auto half_product = [](int a, int b) {
    return static_cast<std::uint8_t>(((a * b + 127) / 255 * 129 + b * 127 + 128) / 256);
  };
  EXPECT_EQ(draw(128, 1, render::DrawMode::kMultiply),
            tables.match(
                {half_product(over.r, under.r), half_product(over.g, under.g), half_product(over.b, under.b)},
                true));
}

// In `rgb`, the tint's factor multiplies the detail's own colors before they are combined.
TEST(DrawOverlay, TintsAndCombinesDetails) {
  const formats::Picture picture = make_detailed_picture(128);
  render::ColorTint tint;
  tint.factor = {255, 128, 0};
  const auto draw = [&](render::DrawMode mode) {
    render::FrameBuffer frame(2, 1, render::PixelFormat::kRgb);
    std::ranges::fill(frame.rgb(), 0xff808080u);
    render::draw_overlay({{{.picture = &picture, .area = {0, 0, 2, 1}, .mode = mode, .tint = &tint}}},
                         some_tables(), nullptr, frame);
    return frame.rgb()[0];
  };
  const auto expect_channels = [](std::uint32_t color, double r, double g, double b) {
    EXPECT_NEAR(color >> 16 & 255, r, 1.5);
    EXPECT_NEAR(color >> 8 & 255, g, 1.5);
    EXPECT_NEAR(color & 255, b, 1.5);
  };
  // The texel under the pixel's center is number 6: 0x60, half transparent, over 0x80.
  constexpr double kUnder = 128, kRed = 96, kGreen = 48;
  expect_channels(draw(render::DrawMode::kBlend), (kRed + kUnder) / 2, (kGreen + kUnder) / 2, kUnder / 2);
  expect_channels(draw(render::DrawMode::kAdd), kUnder + kRed / 2, kUnder + kGreen / 2, kUnder);
  expect_channels(draw(render::DrawMode::kMultiply), kUnder * (1 + kRed / 255) / 2,
                  kUnder * (1 + kGreen / 255) / 2, kUnder / 2);
}

TEST(DrawOverlay, DrawsInOrderThroughTheRenderer) {
  const render::Renderer renderer(random_palette(1), {});
  render::FrameBuffer frame(8, 1, render::PixelFormat::kIndexed);
  std::fill(frame.indexed().begin(), frame.indexed().end(), std::uint8_t{9});
  const formats::Picture picture{2, 1, {3, 255}};
  const render::DrawList list{{{.area = {0, 0, 6, 1}, .fill = 1},
                               {.picture = &picture, .area = {2, 0, 4, 2}, .scale = 2},
                               {.area = {3, 0, 1, 1}, .fill = 5}}};
  render::FrameStats stats;
  renderer.draw_overlay(list, frame, stats);
  EXPECT_GT(stats.stages.ms[static_cast<std::size_t>(render::Stage::kOverlay)], 0.0);
  EXPECT_EQ(std::vector<std::uint8_t>(frame.indexed().begin(), frame.indexed().end()),
            (std::vector<std::uint8_t>{1, 1, 3, 5, 1, 1, 9, 9}));
}

TEST(DrawOverlayDeathTest, RefusesPartsThatThePictureLacks) {
  const formats::Picture picture{4, 4, std::vector<std::uint8_t>(16, 1)};
  render::FrameBuffer frame(8, 8, render::PixelFormat::kIndexed);
  const auto draw = [&](const render::DrawCommand& command) {
    render::draw_overlay({{command}}, some_tables(), nullptr, frame);
  };
  EXPECT_DEATH(draw({.picture = &picture, .area = {0, 0, 5, 4}}), "5x4");
  EXPECT_DEATH(draw({.picture = &picture, .area = {0, 0, 4, 4}, .part_x = 1}), "4x4");
  EXPECT_DEATH(draw({.picture = &picture, .area = {0, 0, 4, 4}, .part_y = -1}), "4x4");
  EXPECT_DEATH(draw({.picture = &picture, .area = {0, 0, 3, 4}, .scale = 2}), "scale");
  EXPECT_DEATH(draw({.picture = &picture, .area = {0, 0, 4, 4}, .scale = 0}), "scale");
  EXPECT_DEATH(
      draw({.picture = &picture, .area = {0, 0, 9, 9}, .part_x = 1, .part_width = 4, .part_height = 1}),
      "4x1");
  EXPECT_DEATH(draw({.picture = &picture, .area = {0, 0, 9, 9}, .part_width = 4}), "4x0");
  EXPECT_DEATH(draw({.area = {0, 0, -1, 4}}), "-1");
}

}  // namespace
}  // namespace temblor::test
