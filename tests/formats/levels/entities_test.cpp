#include "formats/levels/entities.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/levels/bsp.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Pairs = std::vector<std::pair<std::string, std::string>>;

std::vector<Entity> read(std::string_view text) {
  auto entities = read_entities(text);
  EXPECT_TRUE(entities.ok()) << entities.error().message();
  return entities.ok() ? std::move(entities).value() : std::vector<Entity>{};
}

std::string error_of_entities(std::string_view text) {
  const auto entities = read_entities(text);
  return entities.ok() ? "no error" : entities.error().what;
}

TEST(Entities, BlocksOfPairsInFileOrder) {
  const auto entities = read("{\n\"classname\" \"worldspawn\"\n\"wad\" \"\"\n}\n{ \"b\" \"1\" \"a\" \"2\" }");
  ASSERT_EQ(entities.size(), 2u);
  EXPECT_EQ(entities[0].pairs, (Pairs{{"classname", "worldspawn"}, {"wad", ""}}));
  EXPECT_EQ(entities[1].pairs, (Pairs{{"b", "1"}, {"a", "2"}}));
}

TEST(Entities, NothingIsNoEntities) {
  for (const std::string_view text : {"", " \r\n\t", "// only a comment", "//"})
    EXPECT_TRUE(read(text).empty());
  ASSERT_EQ(read("{}").size(), 1u);
  EXPECT_TRUE(read("{}")[0].pairs.empty());
}

TEST(Entities, BracesAndCommentMarksInQuotesAreText) {
  const auto entities = read("{\"message\" \"a { brace } // no comment\"}");
  EXPECT_EQ(entities[0].find("message"), "a { brace } // no comment");
}

TEST(Entities, CommentsRunToTheEndOfTheLine) {
  const auto entities = read("// one \"\n{ // two }\n\"a\" // three\n\"b\"\n}// four");
  ASSERT_EQ(entities.size(), 1u);
  EXPECT_EQ(entities[0].pairs, (Pairs{{"a", "b"}}));
}

TEST(Entities, LineEndsMayBeCrLf) {
  const auto entities = read("{\r\n\"a\" \"b\"\r\n\"c\" \"d\"\r\n}\r\n");
  EXPECT_EQ(entities[0].pairs, (Pairs{{"a", "b"}, {"c", "d"}}));
}

TEST(Entities, KeepsBackslashes) {
  EXPECT_EQ(read(R"({"message" "two\nlines \\ \"})")[0].find("message"), R"(two\nlines \\ \)");
}

TEST(Entities, BareWordsEndAtSpacesAndBraces) {
  EXPECT_EQ(read("{classname light say\"a b\" angle 90}")[0].pairs,
            (Pairs{{"classname", "light"}, {"say\"a", "b\""}, {"angle", "90"}}));
}

// QuakeSpasm and DarkPlaces spawn the same four of these five.
TEST(Entities, AnOpenQuoteCostsOneEntity) {
  const std::string good = "{\n\"classname\" \"good\"\n\"origin\" \"1 2 3\"\n}\n";
  const auto entities = read(good + good + "{\n\"classname\" \"bad\"\n\"message\" \"open\n}\n" + good + good);
  ASSERT_EQ(entities.size(), 4u);
  EXPECT_EQ(entities[2].find("classname"), "bad");
  EXPECT_EQ(entities[2].find("classname\""), "good");
  EXPECT_EQ(entities[3].find("origin"), "1 2 3");
}

TEST(Entities, LongKeysAndValuesAreKept) {
  const std::string key(100, 'k'), value(100000, 'v');
  EXPECT_EQ(read("{\"" + key + "\" \"" + value + "\"}")[0].find(key), value);
}

TEST(Entities, TheTextEndsAtItsFirstZero) {
  EXPECT_EQ(read("{\"a\" \"b\"}\0{ not read"s).size(), 1u);
  EXPECT_EQ(error_of_entities("{\"a\" \"b\0\"}"s), "line 1: this quote is never closed");
}

TEST(Entities, ErrorsNameTheLine) {
  EXPECT_EQ(error_of_entities("{\n\"a\" \"b\"\n"), "line 1: this entity is never closed");
  EXPECT_EQ(error_of_entities("{}\n{\n\"a\" \"b\"\n{"),
            "line 4: an entity starts inside of the one from line 2");
  EXPECT_EQ(error_of_entities("{}\n\n}"), "line 3: expected the opening brace of an entity");
  EXPECT_EQ(error_of_entities("\n\"a\" \"b\""), "line 2: expected the opening brace of an entity");
  EXPECT_EQ(error_of_entities("{\n\"a\" \"b\"\n\"c\"\n}"), "line 3: the key \"c\" has no value");
  EXPECT_EQ(error_of_entities("{\n\"c\""), "line 2: the key \"c\" has no value");
  EXPECT_EQ(error_of_entities("{\n\"two\nlines\" \"b\"\n\"open"), "line 4: this quote is never closed");
}

// The entities, one line for each: "k=v k=v".
std::vector<std::string> faulty(std::string_view text) {
  const EntityText result = read_faulty_entities(text);
  EXPECT_EQ(result.first_fault, error_of_entities(text) == "no error" ? "" : error_of_entities(text));
  std::vector<std::string> lines;
  for (const Entity& entity : result.entities) {
    std::string& line = lines.emplace_back();
    for (const auto& [key, value] : entity.pairs) line += (line.empty() ? "" : " ") + key + "=" + value;
  }
  return lines;
}

TEST(Entities, BlockCommentsAreSkipped) {
  EXPECT_THAT(faulty("/* one } \" */{/**/\"a\"/* \n* / */\"b\"} /* not closed {"), ElementsAre("a=b"));
  EXPECT_EQ(error_of_entities("/*\n\n*/ x"), "line 3: expected the opening brace of an entity");
  EXPECT_THAT(faulty("/*/{}"), IsEmpty());
}

TEST(Entities, FaultsArePassedOver) {
  EXPECT_THAT(faulty("{\"a\" \"b\"} {\"c\" \"d\""), ElementsAre("a=b", "c=d"));
  EXPECT_THAT(faulty("{\"a\" \"b\""), ElementsAre("a=b"));
  EXPECT_THAT(faulty("{\"a\" \"b"), ElementsAre("a=b"));
  EXPECT_THAT(faulty("{\"a\" \""), ElementsAre("a="));
  EXPECT_THAT(faulty("{\"a\" \"b\" \"c\"} {\"d\" \"e\"}"), ElementsAre("a=b", "d=e"));
  EXPECT_THAT(faulty("{\"a\" \"b\" \"c"), ElementsAre("a=b"));
  EXPECT_THAT(faulty("{\"a\" \"b\" {\"c\" \"d\"} {\"e\" \"f\"}"), ElementsAre("a=b", "c=d", "e=f"));
  EXPECT_THAT(faulty("{\"a\" {\"c\" \"d\"}"), ElementsAre("", "c=d"));
  EXPECT_THAT(faulty("} x {\"a\" \"b\"} } \"y\" {\"c\" \"d\"} z"), ElementsAre("a=b", "c=d"));
  EXPECT_THAT(faulty("{\"message\" \"say \\\"hi\\\"\"}"), ElementsAre("message=say \\"));
}

TEST(Entities, OddKeysAreKept) {
  EXPECT_THAT(faulty("{\"\" \"v\" \"_x\" \"1\" \"angle \" \"2\" \"two words\" \"3\" ( 4 }"),
              ElementsAre("=v _x=1 angle =2 two words=3 (=4"));
}

TEST(Entities, FindTakesTheFirstOfEqualKeys) {
  const Entity entity{{{"a", "1"}, {"a", "2"}, {"A", "3"}}};
  EXPECT_EQ(entity.find("a"), "1");
  EXPECT_EQ(entity.find("b"), std::nullopt);
  EXPECT_EQ(entity.classname(), "");
  EXPECT_EQ((Entity{{{"classname", "light"}}}.classname()), "light");
}

TEST(Entities, Numbers) {
  const auto number = [](const std::string& text) { return Entity{{{"n", text}}}.find_number("n"); };
  EXPECT_EQ(number("300"), 300.0f);
  EXPECT_EQ(number(" -1.5 "), -1.5f);
  EXPECT_EQ(number("+2e2"), 200.0f);
  EXPECT_EQ(number(".5"), 0.5f);
  for (const std::string text :
       {"", " ", "abc", "1x", "1 2", "1,5", "nan", "inf", "-inf", "1e999", "+-1", "0x10"})
    EXPECT_EQ(number(text), std::nullopt) << text;
  EXPECT_EQ(Entity{}.find_number("n"), std::nullopt);
}

TEST(Entities, Vectors) {
  const auto vec3 = [](const std::string& text) { return Entity{{{"v", text}}}.find_vec3("v"); };
  EXPECT_EQ(vec3("1 -2 3.25"), math::Vec3(1, -2, 3.25f));
  EXPECT_EQ(vec3("  1\t2\r\n3  "), math::Vec3(1, 2, 3));
  for (const std::string text : {"", "1 2", "1 2 3 4", "1 2 z", "1 2 nan", "1,2,3", "1 2 3x"})
    EXPECT_EQ(vec3(text), std::nullopt) << text;
  EXPECT_EQ(Entity{}.find_vec3("v"), std::nullopt);
}

TEST(Entities, StockLevelsReadAndRoundTrip) {
  DATA_FOLDER_OR_SKIP(data);
  int levels = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "maps")) {
    if (entry.path().extension() != ".bsp") continue;
    SCOPED_TRACE(entry.path().filename());
    const auto bsp = read_bsp(test::read_file(entry.path()));
    ASSERT_TRUE(bsp.ok()) << bsp.error().message();
    const auto entities = read(bsp->entities);
    ASSERT_FALSE(entities.empty());
    EXPECT_EQ(entities[0].classname(), "worldspawn");
    // No stock text has a brace in quotes or a comment, so there is one entity for each opening brace.
    EXPECT_EQ(static_cast<std::ptrdiff_t>(entities.size()), std::ranges::count(bsp->entities, '{'));
    // Every pair has four quotes.
    std::size_t pairs = 0;
    for (const Entity& entity : entities) pairs += entity.pairs.size();
    EXPECT_EQ(static_cast<std::ptrdiff_t>(4 * pairs), std::ranges::count(bsp->entities, '"'));
    EXPECT_TRUE(read(write_entities(entities)) == entities);
    ++levels;
  }
  EXPECT_GT(levels, 0);
}

std::string random_text(test::Random& random, std::string_view alphabet) {
  std::string text(random.below(6), ' ');
  for (char& c : text) c = alphabet[random.below(alphabet.size())];
  return text;
}

TEST(Entities, RoundTrips) {
  for (int seed = 0; seed < test::effort(2000, 300); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    std::vector<Entity> entities(random.below(5));
    for (Entity& entity : entities)
      for (std::size_t i = random.below(4); i > 0; --i)
        entity.pairs.emplace_back(random_text(random, "ab{}/\\ \n"), random_text(random, "cd{}/\\ \r\n\xff"));
    EXPECT_TRUE(read(write_entities(entities)) == entities) << "seed " << seed;
  }
}

TEST(Entities, SurvivesRandomText) {
  int sound = 0;
  for (int seed = 0; seed < test::effort(20000, 3000); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    std::string text;
    for (std::size_t i = random.below(12); i > 0; --i) {
      constexpr std::string_view kParts[] = {"{",  "}",  "\"", "a",         "\"b\" ", "//",
                                             "\n", "\\", " ",  "{\"c\" d}", "/*",     "*/"};
      text += kParts[random.below(std::size(kParts))];
    }
    const EntityText faulty_text = read_faulty_entities(text);
    EXPECT_TRUE(read(write_entities(faulty_text.entities)) == faulty_text.entities) << "seed " << seed;
    const auto entities = read_entities(text);
    EXPECT_EQ(entities.ok(), faulty_text.first_fault.empty()) << "seed " << seed;
    if (!entities.ok()) {
      EXPECT_EQ(entities.error().what.substr(0, 5), "line ") << "seed " << seed;
      continue;
    }
    ++sound;
    EXPECT_TRUE(read(write_entities(*entities)) == *entities) << "seed " << seed;
  }
  EXPECT_GT(sound, 100);
}

}  // namespace
}  // namespace temblor::formats
