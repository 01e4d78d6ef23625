#include "formats/game/sav.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mutations.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

// In the style of a stock engine: the comment padded to 39 characters, numbers with six decimals.
std::string stock_text() {
  std::string text = "5\nthe_Slipgate_Complex___kills:__3/_34____\n";
  for (int i = 0; i < 16; ++i) text += fmt::format("{:f}\n", i == 1 ? 100.0 : 0.0);
  text += "2\ne1m1\n63.512894\n";
  for (int i = 0; i < 64; ++i) text += "m\n";
  text += "{\n\"serverflags\" \"0.000000\"\n}\n";
  text += "{\n\"classname\" \"worldspawn\"\n\"message\" \"the Slipgate\\nComplex\"\n}\n";
  text += "{\n\"classname\" \"player\"\n\"origin\" \"480.000000 -352.000000 88.031250\"\n}\n{\n}\n";
  return text;
}

formats::Sav random_sav(std::uint64_t seed) {
  Random random(seed);
  const auto word = [&] {
    std::string text;
    for (std::size_t i = random.below(12); i > 0; --i) text += static_cast<char>('!' + 2 + random.below(90));
    return text;
  };
  formats::Sav sav;
  sav.comment = fmt::format("level {}", seed);
  for (float& parameter : sav.spawn_parameters) parameter = static_cast<float>(random.uniform(-1e9, 1e9));
  sav.skill = static_cast<int>(random.below(4));
  sav.map = fmt::format("map{}", seed);
  sav.time_s = static_cast<float>(random.log_uniform(1e-6, 1e6));
  for (std::string& style : sav.light_styles) style = "m" + word();
  const auto pairs = [&](std::size_t count) {
    formats::SavPairs result;
    for (std::size_t i = 0; i < count; ++i) {
      std::string name = word();
      name += 'k';  // never empty
      result.emplace_back(std::move(name), word());
    }
    return result;
  };
  sav.globals = pairs(random.below(5));
  for (std::size_t i = 1 + random.below(6); i > 0; --i) sav.entities.push_back(pairs(random.below(4)));
  return sav;
}

TEST(Sav, ReadsStockFile) {
  const auto sav = formats::read_sav(stock_text());
  ASSERT_TRUE(sav.ok()) << sav.error().message();
  EXPECT_EQ(sav->comment, "the Slipgate Complex   kills:  3/ 34");
  EXPECT_EQ(sav->spawn_parameters[1], 100.0f);
  EXPECT_EQ(sav->skill, 2);
  EXPECT_EQ(sav->map, "e1m1");
  EXPECT_FLOAT_EQ(sav->time_s, 63.512894f);
  EXPECT_EQ(sav->light_styles[63], "m");
  ASSERT_EQ(sav->entities.size(), 3u);
  EXPECT_EQ(sav->entities[0][1].second, "the Slipgate\\nComplex");
  EXPECT_EQ(sav->entities[1][1].second, "480.000000 -352.000000 88.031250");
  EXPECT_TRUE(sav->entities[2].empty());
}

TEST(Sav, AcceptsOtherLineEndsAndTrailingText) {
  std::string text;
  for (const char c : stock_text()) text += c == '\n' ? "\r\n" : std::string(1, c);
  text += "// what another engine adds\n";
  const auto sav = formats::read_sav(text);
  ASSERT_TRUE(sav.ok()) << sav.error().message();
  EXPECT_EQ(*sav, formats::read_sav(stock_text()).value());
  EXPECT_FALSE(formats::read_sav(text + "more").ok());
}

// DarkPlaces writes such a comment after the entities.
TEST(Sav, SkipsBlockComments) {
  const std::string comment =
      "/*\n// DarkPlaces extended savegame\nsv.lightstyles 0 m\nsv.model_precache 1 maps/start.bsp\n"
      "sv.sound_precache 1 { \"x\n*/\n";
  const formats::Sav expected = formats::read_sav(stock_text()).value();
  for (const std::string& text : {stock_text() + comment, stock_text() + comment + comment + "/* not closed",
                                  stock_text().replace(stock_text().find("{\n\"cl"), 0, comment)}) {
    const auto sav = formats::read_sav(text);
    ASSERT_TRUE(sav.ok()) << sav.error().message();
    EXPECT_EQ(*sav, expected);
  }
}

// Other engines read the header with scanf(), which skips white space.
TEST(Sav, SkipsWhiteSpaceInTheHeader) {
  std::string text = stock_text();
  text.replace(text.find("2\ne1m1\n63.512894\n"), 17, "\n 2 \n\n\te1m1 \n\r\n 63.512894\t\n");
  const auto sav = formats::read_sav(text);
  ASSERT_TRUE(sav.ok()) << sav.error().message();
  EXPECT_EQ(*sav, formats::read_sav(stock_text()).value());
}

TEST(Sav, SpawnParametersNeedNotBeFinite) {
  for (const std::string number : {"nan", "-nan", "inf", "-inf"}) {
    std::string text = stock_text();
    text.replace(text.find("100.000000"), 10, number);
    const auto sav = formats::read_sav(text);
    ASSERT_TRUE(sav.ok()) << sav.error().message();
    EXPECT_EQ(sav->spawn_parameters[1], 0);
  }
  std::string text = stock_text();
  text.replace(text.find("63.512894"), 9, "nan");
  EXPECT_THAT(formats::read_sav(text).error().what, HasSubstr("line 21: the time is nan"));
}

TEST(Sav, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const formats::Sav sav = random_sav(seed);
    const auto text = formats::write_sav(sav);
    ASSERT_TRUE(text.ok()) << "seed " << seed << ": " << text.error().message();
    const auto read = formats::read_sav(*text);
    ASSERT_TRUE(read.ok()) << "seed " << seed << ": " << read.error().message();
    EXPECT_EQ(*read, sav) << "seed " << seed;
  }
}

// Stock readers skip empty lines, and then take the first block for a light style.
TEST(Sav, WritesUndefinedLightStylesAsStockEnginesDo) {
  formats::Sav sav = random_sav(1);
  sav.light_styles.fill("");
  const auto read = formats::read_sav(formats::write_sav(sav).value());
  ASSERT_TRUE(read.ok()) << read.error().message();
  for (const std::string& style : read->light_styles) EXPECT_EQ(style, "m");
}

TEST(Sav, RejectsOtherVersions) {
  const auto sav = formats::read_sav("6\n" + stock_text().substr(2));
  ASSERT_FALSE(sav.ok());
  EXPECT_EQ(sav.error().code, base::ErrorCode::kUnsupported);
}

TEST(Sav, ErrorsNameTheLine) {
  std::string text = stock_text();
  text.replace(text.find("2\ne1m1"), 1, "hard");
  const auto sav = formats::read_sav(text);
  ASSERT_FALSE(sav.ok());
  EXPECT_THAT(sav.error().what, HasSubstr("line 19: the skill must be a number, not \"hard\""));
}

TEST(Sav, TruncationFailsOrLosesWholeEntities) {
  const std::string text = stock_text();
  const auto whole = formats::read_sav(text);
  for_each_truncation(base::as_bytes(text), [&](const base::ByteVector& bytes) {
    const auto sav = formats::read_sav(base::as_text(bytes));
    if (sav.ok()) {
      EXPECT_LE(sav->entities.size(), whole->entities.size());
    }
  });
}

TEST(Sav, WriteRejectsInvalidValues) {
  formats::Sav sav;
  sav.comment = "two\nlines";
  EXPECT_FALSE(formats::write_sav(sav).ok());
  sav.comment.clear();
  sav.entities.push_back({{"netname", "a \"quote\""}});
  EXPECT_FALSE(formats::write_sav(sav).ok());
}

}  // namespace
}  // namespace temblor::test
