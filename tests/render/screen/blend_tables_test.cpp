#include "render/color/blend_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <span>
#include <thread>
#include <vector>

#include "support/game_data.h"
#include "support/pictures/some_colors.h"

namespace temblor::render {
namespace {

using test::random_palette;

constexpr int kFirstFullbright = 224;

int distance(formats::Rgb a, formats::Rgb b) {
  const int r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

// The definition: tries every entry.
int find_nearest(const formats::Palette& palette, formats::Rgb color, bool fullbright) {
  int found = 0;
  for (int i = 1; i < (fullbright ? 255 : kFirstFullbright); ++i)
    if (distance(palette[static_cast<std::size_t>(i)], color) <
        distance(palette[static_cast<std::size_t>(found)], color))
      found = i;
  return found;
}

TEST(PaletteMatch, IsTheNearestOfAllThatMayBe) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    formats::Palette palette = random_palette(seed);
    if (seed == 4) palette.fill({7, 7, 7});  // all as near: the lowest
    const PaletteMatch match(palette, kFirstFullbright);
    std::mt19937 random(seed);
    for (int i = 0; i < 20000; ++i) {
      const formats::Rgb color{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                               static_cast<std::uint8_t>(random())};
      const bool fullbright = random() % 2 == 0;
      ASSERT_EQ(match(color, fullbright), find_nearest(palette, color, fullbright))
          << "seed " << seed << ": " << int{color.r} << " " << int{color.g} << " " << int{color.b};
      if (i % 100 == 0) {
        ASSERT_EQ(match.find_by_trying(color, fullbright), match(color, fullbright));
      }
    }
  }
}

TEST(BlendTables, HoldTheNearestToTheMean) {
  const formats::Palette palette = random_palette(9);
  const PaletteMatch match(palette, kFirstFullbright);
  const BlendTables tables(palette, match);
  for (int step = 1; step < 16; ++step) {
    const std::uint8_t* table = tables.table_for(static_cast<float>(step) / 16);
    for (int i = 0; i < 2000; ++i) {
      const std::size_t over = static_cast<std::size_t>(i * 7 % 256),
                        under = static_cast<std::size_t>(i * 89 % 256);
      const auto mean = [&](int a, int b) {
        return static_cast<std::uint8_t>((a * step + b * (16 - step) + 8) / 16);
      };
      const formats::Rgb a = palette[over], b = palette[under];
      const bool fullbright = over >= kFirstFullbright || under >= kFirstFullbright;
      ASSERT_EQ(table[over * 256 + under],
                find_nearest(palette, {mean(a.r, b.r), mean(a.g, b.g), mean(a.b, b.b)}, fullbright))
          << over << " over " << under << ", step " << step;
    }
  }
}

TEST(BlendTables, SumsAreTheNearestEntries) {
  const formats::Palette palette = random_palette(8);
  const BlendTables tables(palette, PaletteMatch(palette, kFirstFullbright));
  const auto add = [](int a, int b) { return static_cast<std::uint8_t>(std::min(a + b, 255)); };
  for (int i = 0; i < 4000; ++i) {
    const std::size_t one = static_cast<std::size_t>(i * 7 % 256),
                      other = static_cast<std::size_t>(i * 89 % 256);
    const formats::Rgb a = palette[one], b = palette[other];
    ASSERT_EQ(tables.sums()[one * 256 + other],
              find_nearest(palette, {add(a.r, b.r), add(a.g, b.g), add(a.b, b.b)}, true))
        << one << " + " << other;
  }
}

TEST(BlendTables, TakeTheNearestStep) {
  const formats::Palette palette = random_palette(5);
  const BlendTables tables(palette, PaletteMatch(palette, kFirstFullbright));
  EXPECT_EQ(tables.table_for(0.0f), tables.table_for(1.0f / 16));
  EXPECT_EQ(tables.table_for(1.0f), tables.table_for(15.0f / 16));
  EXPECT_EQ(tables.table_for(0.51f), tables.table_for(0.5f));
  EXPECT_EQ(tables.table_for(0.49f), tables.table_for(0.5f));
  EXPECT_NE(tables.table_for(0.54f), tables.table_for(0.5f));
}

// Several threads request all tables at once, in different orders. The others are made all at once.
TEST(BlendTables, AreComputedOnceForAllThreads) {
  const formats::Palette palette = random_palette(11);
  const PaletteMatch match(palette, kFirstFullbright);
  const BlendTables tables(palette, match), alone(palette, match);
  alone.make_all();
  const auto find_table = [](const BlendTables& of, int step) {
    return std::span(of.table_for(static_cast<float>(step) / 16), 256 * 256);
  };
  std::array<std::array<std::uint8_t, 16>, 4> last{};
  std::vector<std::thread> threads;
  for (std::size_t number = 0; number < last.size(); ++number)
    threads.emplace_back([&, number] {
      for (int i = 0; i < 15; ++i) {
        const int step = 1 + (i * 7 + static_cast<int>(number) * 4) % 15;
        last[number][static_cast<std::size_t>(step)] = find_table(tables, step).back();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (int step = 1; step < 16; ++step) {
    ASSERT_TRUE(std::ranges::equal(find_table(tables, step), find_table(alone, step))) << step;
    for (const auto& seen : last)
      EXPECT_EQ(seen[static_cast<std::size_t>(step)], find_table(alone, step).back()) << step;
  }
}

// The entry for "clear", and full-bright entries, never result from others.
TEST(BlendTables, MakeNoLightOutOfTheDark) {
  DATA_FOLDER_OR_SKIP(data);
  const auto palette = formats::read_palette(test::read_file(data / "id1" / "gfx" / "palette.lmp"));
  ASSERT_TRUE(palette.ok());
  const BlendTables tables(*palette, PaletteMatch(*palette, kFirstFullbright));
  for (int step = 1; step < 16; ++step) {
    const std::uint8_t* table = tables.table_for(static_cast<float>(step) / 16);
    for (std::size_t over = 0; over < 256; ++over)
      for (std::size_t under = 0; under < 256; ++under) {
        const int limit = over >= kFirstFullbright || under >= kFirstFullbright ? 255 : kFirstFullbright;
        ASSERT_LT(table[over * 256 + under], limit) << over << " over " << under;
      }
  }
}

TEST(BlendChannel, IsTheRoundedMean) {
  EXPECT_EQ(opacity_256(0.0f), 0);
  EXPECT_EQ(opacity_256(1.0f), 256);
  EXPECT_EQ(opacity_256(7.0f), 256);
  EXPECT_EQ(opacity_256(-1.0f), 0);
  for (int opacity = 0; opacity <= 256; ++opacity)
    for (int over = 0; over < 256; over += 5)
      for (int under = 0; under < 256; under += 5) {
        const double exact = (over * opacity + under * (256 - opacity)) / 256.0;
        ASSERT_LE(std::abs(blend_channel(over, under, opacity) - exact), 0.5);
      }
  EXPECT_EQ(blend_rgb(0xff804020, 0x00102030, 128), 0xff483028u);
}

TEST(FogTables, FadeToTheFogAndFollowItsColor) {
  const formats::Palette palette = random_palette(3);
  const PaletteMatch match(palette, kFirstFullbright);
  FogTables fog;
  for (const math::Vec3 color : {math::Vec3(0.2f, 0.5f, 0.9f), math::Vec3(1.0f, 0.0f, 0.0f)}) {
    const std::uint8_t* rows = fog.rows_for(color, palette, match);
    const formats::Rgb bytes = to_bytes(color);
    for (int row = 0; row < FogTables::kRows; ++row) ASSERT_EQ(rows[row * 256 + 255], 255);
    for (std::size_t i = 0; i < 255; ++i) {
      ASSERT_EQ(rows[i], i);
      const bool fullbright = i >= kFirstFullbright;
      const auto mean = [](int a, int b) { return static_cast<std::uint8_t>((a + b + 1) / 2); };
      const formats::Rgb own = palette[i];
      ASSERT_EQ(rows[32 * 256 + i],
                find_nearest(palette, {mean(own.r, bytes.r), mean(own.g, bytes.g), mean(own.b, bytes.b)},
                             fullbright));
      ASSERT_EQ(rows[64 * 256 + i], find_nearest(palette, bytes, fullbright));
    }
  }
}

}  // namespace
}  // namespace temblor::render
