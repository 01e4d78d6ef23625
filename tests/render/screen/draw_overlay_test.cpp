// 2-D drawing against the definition: for each pixel of the frame, which pixel of which picture is over it.
#include "render/screen/draw_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/color/color_tables.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/pictures/some_colors.h"
#include "support/random.h"

namespace temblor::test {
namespace {

// A third of it transparent.
formats::Picture random_picture(Random& random) {
  formats::Picture picture{
      static_cast<std::uint32_t>(1 + random.below(40)), static_cast<std::uint32_t>(1 + random.below(40)), {}};
  for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
    picture.pixels.push_back(random.chance(0.3) ? std::uint8_t{255}
                                                : static_cast<std::uint8_t>(random.bits()));
  return picture;
}

// Around the frame's edges, or far away.
int random_corner(Random& random) {
  if (random.chance(0.05)) return static_cast<int>(random.bits());
  return static_cast<int>(random.below(200)) - 80;
}

int random_scale(Random& random) {
  if (random.chance(0.1)) return 1 + static_cast<int>(random.below(40'000'000));
  return 1 + static_cast<int>(random.below(9));
}

render::DrawCommand random_command(const formats::Picture& picture,
                                   const render::ColorTranslation& translation, Random& random) {
  render::DrawCommand command;
  command.area.x = random_corner(random);
  command.area.y = random_corner(random);
  command.opacity = random.chance(0.5) ? 1.0f : static_cast<float>(random.uniform(-0.2, 1.2));
  if (random.chance(0.2)) {
    command.area.width = static_cast<int>(random.below(150));
    command.area.height =
        random.chance(0.1) ? std::numeric_limits<int>::max() : static_cast<int>(random.below(90));
    command.fill = static_cast<std::uint8_t>(random.bits());
    return command;
  }
  command.picture = &picture;
  command.scale = random_scale(random);
  const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  command.part_x = static_cast<int>(random.below(picture.width));
  command.part_y = static_cast<int>(random.below(picture.height));
  command.area.width =
      command.scale * static_cast<int>(random.below(static_cast<std::size_t>(width - command.part_x) + 1));
  command.area.height =
      command.scale * static_cast<int>(random.below(static_cast<std::size_t>(height - command.part_y) + 1));
  if (random.chance(0.3)) command.translation = &translation;
  return command;
}

// The palette index that a command draws at a pixel; 256: none.
int index_at(const render::DrawCommand& command, int x, int y) {
  const std::int64_t across = std::int64_t{x} - command.area.x, down = std::int64_t{y} - command.area.y;
  if (across < 0 || down < 0 || across >= command.area.width || down >= command.area.height) return 256;
  if (command.picture == nullptr) return command.fill;
  const std::int64_t column = command.part_x + across / command.scale,
                     row = command.part_y + down / command.scale;
  const std::uint8_t texel =
      command.picture->pixels[static_cast<std::size_t>(row * std::int64_t{command.picture->width} + column)];
  if (texel == 255) return 256;
  return command.translation != nullptr ? (*command.translation)[texel] : texel;
}

// A channel of two blended colors, up to rounding.
bool is_mixed(int got, int over, int under, double opacity) {
  return std::abs(got - (over * opacity + under * (1 - opacity))) <= 1.0;
}

void expect_pixel(const render::DrawCommand& command, int index, std::uint32_t before, std::uint32_t after) {
  if (index == 256 || !(command.opacity > 0)) {
    ASSERT_EQ(after, before);
  } else if (command.opacity >= 1) {
    ASSERT_EQ(after, some_tables().rgb[static_cast<std::size_t>(index)]);
  } else {
    const std::uint32_t over = some_tables().rgb[static_cast<std::size_t>(index)];
    for (int shift = 0; shift < 24; shift += 8)
      ASSERT_TRUE(is_mixed(after >> shift & 255, over >> shift & 255, before >> shift & 255,
                           static_cast<double>(command.opacity)));
    ASSERT_EQ(after >> 24, 255u);
  }
}

// Uses the table for the nearest sixteenth; another test checks its colors.
void expect_indexed_pixel(const render::DrawCommand& command, int index, std::uint8_t before,
                          std::uint8_t after) {
  if (index == 256 || !(command.opacity > 0))
    ASSERT_EQ(after, before);
  else if (command.opacity >= 1)
    ASSERT_EQ(after, index);
  else
    ASSERT_EQ(after, some_tables().blends.table_for(command.opacity)[index * 256 + before]);
}

TEST(DrawOverlay, PutsEveryPixelWhereItBelongs) {
  base::Jobs three(3, base::JobBackend::kStdThread);
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(effort(2000, 150)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const formats::Picture picture = random_picture(random);
    render::ColorTranslation translation;
    for (std::uint8_t& index : translation) index = static_cast<std::uint8_t>(random.bits());
    const render::DrawCommand command = random_command(picture, translation, random);
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
  EXPECT_DEATH(draw({.area = {0, 0, -1, 4}}), "-1");
}

}  // namespace
}  // namespace temblor::test
