// Compares animated textures and light styles with their definitions, in whole milliseconds.
#include "world/animation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "support/game_data.h"
#include "support/random.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

TestLevel level_with_textures(const std::vector<std::string>& names) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  const formats::BspMiptex pattern = bsp.miptexes[0];
  bsp.miptexes.clear();
  for (const std::string& name : names) {
    bsp.miptexes.push_back(pattern);
    bsp.miptexes.back().name = name;
  }
  return test_level("animation", std::move(bsp));
}

std::string shown_name(const Level& level, std::size_t texture, double time_s, int entity_frame) {
  return level.texture(find_animated_texture(level, static_cast<TextureIndex>(texture), time_s, entity_frame))
      .name;
}

// Times from the first second to months, never on the boundary of a tick.
std::vector<std::uint64_t> sample_times_ms() {
  std::vector<std::uint64_t> times;
  for (std::uint64_t ms = 50; ms < 5000; ms += 100) times.push_back(ms);
  test::Random random(11);
  for (const std::uint64_t base_s : {3600ull, 100'000ull, 10'000'000ull, 1'000'000'000ull})
    for (int i = 0; i < 200; ++i)
      times.push_back(base_s * 1000 + random.below(36'000) * 100 + 1 + random.below(98));
  return times;
}

TEST(AnimatedTexture, ShowsEachFrameForAFifthOfASecond) {
  const TestLevel test = level_with_textures({"+1lamp", "plain", "+2lamp", "+alamp", "+0lamp", "+blamp"});
  for (const std::uint64_t ms : sample_times_ms()) {
    const double time_s = static_cast<double>(ms) / 1000;
    const std::string main = fmt::format("+{}lamp", ms / 200 % 3);
    const std::string alternate = ms / 200 % 2 == 0 ? "+alamp" : "+blamp";
    for (const std::size_t texture : {0u, 2u, 4u}) {
      EXPECT_EQ(shown_name(*test.level, texture, time_s, 0), main) << ms;
      EXPECT_EQ(shown_name(*test.level, texture, time_s, 1), alternate) << ms;
    }
    for (const std::size_t texture : {3u, 5u}) {
      EXPECT_EQ(shown_name(*test.level, texture, time_s, 0), alternate) << ms;
      EXPECT_EQ(shown_name(*test.level, texture, time_s, 7), main) << ms;
    }
    EXPECT_EQ(shown_name(*test.level, 1, time_s, 1), "plain");
  }
}

TEST(AnimatedTexture, WithoutTheOtherSequenceKeepsItsOwn) {
  const TestLevel test = level_with_textures({"+0a", "+1a", "+ab"});
  EXPECT_EQ(shown_name(*test.level, 0, 0.3, 1), "+1a");
  EXPECT_EQ(shown_name(*test.level, 2, 0.3, 1), "+ab");
}

TEST(AnimatedTexture, NamesAreComparedWithoutCase) {
  const TestLevel test = level_with_textures({"+0Lamp", "+1LAMP", "+Alamp"});
  EXPECT_EQ(shown_name(*test.level, 0, 0.3, 0), "+1LAMP");
  EXPECT_EQ(shown_name(*test.level, 0, 0.3, 1), "+Alamp");
}

TEST(AnimatedTexture, SequenceWithAGapStandsStill) {
  const TestLevel test = level_with_textures({"+0gap", "+2gap", "+1late", "+", "+x"});
  for (std::size_t i = 0; i < 5; ++i)
    for (const double time_s : {0.1, 0.3, 0.5})
      EXPECT_EQ(shown_name(*test.level, i, time_s, 0), test.level->textures[i].name);
}

TEST(AnimatedTexture, BeforeTheStartShowsTheFirstFrame) {
  const TestLevel test = level_with_textures({"+0a", "+1a"});
  EXPECT_EQ(shown_name(*test.level, 1, -0.3, 0), "+0a");
}

TEST(AnimatedTexture, NeverLeavesTheSequenceHoweverLateItIs) {
  const TestLevel test = level_with_textures({"+0a", "+1a", "+2a"});
  for (double time_s = 1; time_s < 1e300; time_s *= 997) {
    const std::string name = shown_name(*test.level, 0, time_s, 0);
    EXPECT_TRUE(name == "+0a" || name == "+1a" || name == "+2a") << time_s;
  }
}

TEST(LightStyles, LettersAreTicksOfATenthOfASecond) {
  LightStylePatterns patterns;
  patterns[0] = std::string("m");
  patterns[5] = std::string("az");
  patterns[63] = std::string("abcxyz");
  for (const std::uint64_t ms : sample_times_ms()) {
    const LightStyleValues values = compute_light_styles(patterns, static_cast<double>(ms) / 1000);
    EXPECT_EQ(values[0], 264);
    EXPECT_EQ(values[5], ms / 100 % 2 == 0 ? 0 : 550) << ms;
    constexpr int kExpected[] = {0, 22, 44, 506, 528, 550};
    EXPECT_EQ(values[63], kExpected[ms / 100 % 6]) << ms;
    EXPECT_EQ(values[1], 256);
  }
}

TEST(LightStyles, CanBeConstant) {
  LightStylePatterns patterns;
  patterns[0] = std::string("m");
  patterns[5] = std::string("az");
  for (const double time_s : {0.0, 0.1, 7.25}) {
    const LightStyleValues mean = compute_light_styles(patterns, time_s, LightStyleMode::kMean);
    EXPECT_EQ(mean[0], 264);
    EXPECT_EQ(mean[5], 275);
    EXPECT_EQ(mean[1], 256);
    EXPECT_EQ(compute_light_styles(patterns, time_s, LightStyleMode::kHighest)[5], 550);
  }
}

TEST(LightStyles, OtherCharactersCountAsTheNearestLetter) {
  LightStylePatterns patterns;
  patterns[0] = std::string("A");
  patterns[1] = std::string("~");
  patterns[2] = std::string("\xff");
  const LightStyleValues values = compute_light_styles(patterns, 0);
  EXPECT_EQ(values[0], 0);
  EXPECT_EQ(values[1], 550);
  for (const std::uint16_t value : values) EXPECT_LE(value, 550);
}

// A stock demo contains the patterns as its server sent them: the message byte 12, the style, the text.
TEST(LightStyles, StandardPatternsAreThoseOfAStockGame) {
  DATA_FOLDER_OR_SKIP(base_folder);
  const base::ByteVector demo = test::read_file(base_folder / "id1" / "demo1_lite.dem");
  const std::string_view bytes = base::as_text(demo);
  const LightStylePatterns patterns = make_standard_light_styles();
  for (std::size_t style = 0; style < kLightStyles; ++style) {
    if (patterns[style].empty()) continue;
    const std::string message = fmt::format("\x0c{}{}{}", static_cast<char>(style), patterns[style], '\0');
    EXPECT_NE(bytes.find(message), std::string_view::npos) << style;
  }
}

}  // namespace
}  // namespace temblor::world
