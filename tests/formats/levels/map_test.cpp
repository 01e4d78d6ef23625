#include "formats/levels/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using namespace std::string_literals;

constexpr std::string_view kPoints = "( 0 0 0 ) ( 0 1 0 ) ( 0 0 1 ) ";

Map read_map_text(std::string_view text) {
  auto map = read_map(text);
  EXPECT_TRUE(map.ok()) << map.error().message();
  return map.ok() ? std::move(map).value() : Map{};
}

std::string error_of_map(std::string_view text) {
  const auto map = read_map(text);
  return map.ok() ? "no error" : map.error().what;
}

// Reads a map with one side, whose texture and alignment are the text `rest`.
MapSide read_side(std::string_view rest) {
  const Map map = read_map_text("{\n{\n" + std::string(kPoints) + std::string(rest) + "\n}\n}");
  if (map.entities.size() != 1 || map.entities[0].brushes.size() != 1 ||
      map.entities[0].brushes[0].sides.size() != 1) {
    ADD_FAILURE() << rest;
    return {};
  }
  return map.entities[0].brushes[0].sides[0];
}

std::string error_of_side(std::string_view rest) {
  return error_of_map("{\n\"classname\" \"func_wall\"\n{\n}\n{\n" + std::string(kPoints) + std::string(rest) +
                      "\n}\n}");
}

Map without_lines(Map map) {
  for (MapEntity& entity : map.entities) {
    entity.line = 0;
    for (MapBrush& brush : entity.brushes) {
      brush.line = 0;
      for (MapSide& side : brush.sides) side.line = 0;
    }
  }
  return map;
}

TEST(Map, EntitiesBrushesAndSidesKnowTheirLines) {
  const Map map = read_map_text(
      "// Game: Quake\r\n{\r\n\"classname\" \"worldspawn\"\r\n// brush 0\r\n{\r\n"
      "( 1 -2.5 3e1 ) ( 0 1 0 ) ( 0 0 1 ) wall 1 2 3 4 5\r\n"
      "( 0 0 0 ) ( 0 1 0 ) ( 0 0 1 ) wall 0 0 0 1 1 // behind\r\n}\r\n}\r\n{\n\"a\" \"b\"\n}");
  ASSERT_EQ(map.entities.size(), 2u);
  EXPECT_EQ(map.entities[0].fields.classname(), "worldspawn");
  EXPECT_EQ(map.entities[0].line, 2u);
  EXPECT_EQ(map.entities[1].line, 10u);
  ASSERT_EQ(map.entities[0].brushes.size(), 1u);
  EXPECT_EQ(map.entities[0].brushes[0].line, 5u);
  ASSERT_EQ(map.entities[0].brushes[0].sides.size(), 2u);
  const MapSide& side = map.entities[0].brushes[0].sides[0];
  EXPECT_EQ(side.line, 6u);
  EXPECT_EQ(side.points_world[0], math::Vec3d(1, -2.5, 30));
  EXPECT_EQ(side.points_world[2], math::Vec3d(0, 0, 1));
  EXPECT_EQ(map.entities[0].brushes[0].sides[1].line, 7u);
}

TEST(Map, StandardAlignment) {
  const MapSide side = read_side("*water1 16 -8.25 45 0.5 -1");
  EXPECT_EQ(side.texture, "*water1");
  EXPECT_EQ(side.texturing.alignment, MapAlignment::kStandard);
  EXPECT_EQ(side.texturing.offset, math::Vec2d(16, -8.25));
  EXPECT_EQ(side.texturing.rotation_deg, 45);
  EXPECT_EQ(side.texturing.scale, math::Vec2d(0.5, -1));
  EXPECT_EQ(side.flags, std::nullopt);
}

TEST(Map, ValveAlignment) {
  const MapSide side = read_side("w [ 2.22e-16 -1 0 8 ] [ 0 -0 -1 +4 ] 90 0.5 1");
  EXPECT_EQ(side.texturing.alignment, MapAlignment::kValve);
  EXPECT_EQ(side.texturing.s_axis, math::Vec3d(2.22e-16, -1, 0));
  EXPECT_EQ(side.texturing.t_axis, math::Vec3d(0, 0, -1));
  EXPECT_EQ(side.texturing.offset, math::Vec2d(8, 4));
  EXPECT_EQ(side.texturing.rotation_deg, 90);
  EXPECT_EQ(side.texturing.scale, math::Vec2d(0.5, 1));
}

TEST(Map, BrushPrimitiveAlignment) {
  const Map map = read_map_text("{ { brushDef { " + std::string(kPoints) +
                                "( ( 0.5 0 0.25 ) ( 0 2 -1 ) ) base/floor 1 2 3 } } }");
  const MapSide& side = map.entities.at(0).brushes.at(0).sides.at(0);
  EXPECT_EQ(side.texture, "base/floor");
  EXPECT_EQ(side.texturing.alignment, MapAlignment::kBrushPrimitive);
  EXPECT_EQ(side.texturing.matrix[0], (std::array{0.5, 0.0, 0.25}));
  EXPECT_EQ(side.texturing.matrix[1], (std::array{0.0, 2.0, -1.0}));
  EXPECT_EQ(side.flags, (MapSideFlags{1, 2, 3}));
}

TEST(Map, DialectsMayBeMixed) {
  const Map map = read_map_text("{ { " + std::string(kPoints) + "a 0 0 0 1 1 " + std::string(kPoints) +
                                "b [ 1 0 0 0 ] [ 0 1 0 0 ] 0 1 1 } { brushDef { } } }");
  ASSERT_EQ(map.entities.at(0).brushes.size(), 2u);
  EXPECT_EQ(map.entities[0].brushes[0].sides.at(0).texturing.alignment, MapAlignment::kStandard);
  EXPECT_EQ(map.entities[0].brushes[0].sides.at(1).texturing.alignment, MapAlignment::kValve);
}

TEST(Map, ScaleZeroMeansOne) {
  EXPECT_EQ(read_side("w 0 0 0 0 -0").texturing.scale, math::Vec2d(1, 1));
}

TEST(Map, NamesMayHoldBracesAndQuotesMayHoldSpaces) {
  EXPECT_EQ(read_side("{char_a 0 0 0 1 1").texture, "{char_a");
  EXPECT_EQ(read_side("}[(\" 0 0 0 1 1").texture, "}[(\"");
  EXPECT_EQ(read_side("\"two words\" 0 0 0 1 1").texture, "two words");
  EXPECT_EQ(read_side("\"\" 0 0 0 1 1").texture, "");
  EXPECT_EQ(read_side(std::string(500, 'n') + " 0 0 0 1 1").texture, std::string(500, 'n'));
}

TEST(Map, ReadsSideFlags) {
  EXPECT_EQ(read_side("w 0 0 0 1 1 134217728 -1 7").flags, (MapSideFlags{134217728, -1, 7}));
  EXPECT_EQ(read_side("w [ 1 0 0 0 ] [ 0 1 0 0 ] 0 1 1 3 // c").flags, (MapSideFlags{3, 0, 0}));
  EXPECT_EQ(read_side("w 0 0 0 1 1 4294967295").flags, (MapSideFlags{-1, 0, 0}));
}

TEST(Map, SkipsPatches) {
  const Map map = read_map_text(
      "{\n{\npatchDef2\n{\n{grate\n( 3 3 0 0 0 )\n(\n( ( 0 0 0 0 0 ) ( 0 8 0 0 1 ) )\n)\n}\n}\n"
      "{\n}\n}");
  ASSERT_EQ(map.entities.at(0).brushes.size(), 1u);
  EXPECT_EQ(map.entities[0].brushes[0].line, 12u);
}

TEST(Map, BrushWithoutSidesIsKept) {
  EXPECT_EQ(read_map_text("{ { } }").entities.at(0).brushes.size(), 1u);
}

TEST(Map, CommentsLineEndsAndTheEnd) {
  EXPECT_TRUE(read_map_text("").entities.empty());
  EXPECT_TRUE(read_map_text(" // only\r; this").entities.empty());
  EXPECT_EQ(read_map_text("\xef\xbb\xbf{\r}\r\n{ }\n").entities.at(1).line, 3u);
  EXPECT_EQ(read_map_text("{ }\0{ not read"s).entities.size(), 1u);
}

TEST(Map, QuotesInsideValues) {
  const auto value = [](std::string_view quoted) {
    return std::string(
        read_map_text("{\n\"k\" " + std::string(quoted) + "\n}").entities.at(0).fields.find("k").value());
  };
  EXPECT_EQ(value(R"("say \"hi\" twice")"), "say 'hi' twice");
  EXPECT_EQ(value(R"("\"")"), "'");
  EXPECT_EQ(value(R"("C:\wads\")"), R"(C:\wads\)");
  EXPECT_EQ(value(R"("C:\wads\"  )"), R"(C:\wads\)");
  EXPECT_EQ(value(R"("a // { } ; b")"), "a // { } ; b");
  EXPECT_EQ(value("bare"), "bare");
}

TEST(Map, ErrorsNameEntityBrushAndLine) {
  EXPECT_EQ(error_of_map("\n}\n\n{ }"), "line 2: expected the opening brace of an entity, found \"}\"");
  EXPECT_EQ(error_of_map("{ }\nVersion 2\n{ }"),
            "line 2: expected the opening brace of an entity, found \"Version\"");
  EXPECT_EQ(error_of_map("{\n}\n\n{\n\"a\" \"b\"\n"), "entity 1, line 4: this entity is never closed");
  EXPECT_EQ(error_of_map("{\n\"classname\" \"func_wall\"\n{\n"),
            "entity 0 (func_wall), brush 0, line 3: this brush is never closed");
  EXPECT_EQ(error_of_map("{\n{\n}\n{\n{\n"),
            "entity 0, brush 1, line 5: unexpected brace inside of the brush from line 4");
  EXPECT_EQ(error_of_map("{\n\"a\"\n}"), "entity 0, line 2: the key \"a\" has no value");
  EXPECT_EQ(error_of_map("{\n\"a\" \"b\n\"c\" \"d\"\n}"),
            "entity 0, line 2: this quote is not closed on its line");
  EXPECT_EQ(error_of_map("{\n\"a"), "entity 0, line 2: this quote is not closed on its line");
  EXPECT_EQ(
      error_of_map("{\n{\nbrushDef3\n{\n}\n}\n}"),
      "entity 0, brush 0, line 3: expected a side or the closing brace of the brush, found \"brushDef3\"");
  EXPECT_EQ(error_of_map("{\n{\n\"a\" \"b\"\n}\n}"),
            "entity 0, brush 0, line 3: expected a side or the closing brace of the brush, found \"\"a\"\"");
}

TEST(Map, ErrorsOfASide) {
  const std::string place = "entity 0 (func_wall), brush 1, line 6: ";
  EXPECT_EQ(error_of_side("w 0 0 nan 1 1"), place + "expected a finite number, found \"nan\"");
  EXPECT_EQ(error_of_side("w 0 0 0 inf 1"), place + "expected a finite number, found \"inf\"");
  EXPECT_EQ(error_of_side("w 0 1e999 0 1 1"), place + "expected a finite number, found \"1e999\"");
  EXPECT_EQ(error_of_side("w 0 +-1 0 1 1"), place + "expected a finite number, found \"+-1\"");
  EXPECT_EQ(error_of_side("w 0 1,5 0 1 1"), place + "expected a finite number, found \"1,5\"");
  EXPECT_EQ(error_of_side("w [ 1 0 0 ] [ 0 1 0 0 ] 0 1 1"), place + "expected a finite number, found \"]\"");
  EXPECT_EQ(error_of_side("w [ 1 0 0 0 0 ] [ 0 1 0 0 ] 0 1 1"), place + "expected \"]\", found \"0\"");
  EXPECT_EQ(error_of_side("( ( 1 0 0 ) w"), place + "expected \"(\", found \"w\"");
  EXPECT_EQ(error_of_side("\"open 0 0 0 1 1"), place + "this quote is not closed on its line");
  EXPECT_EQ(error_of_side("w 0 0 0 1 1 5000000000"),
            place + "expected the flags of a side (32-bit integers), found \"5000000000\"");
  EXPECT_EQ(error_of_side("w 0 0 0 1 1 1 2 3 4"),
            place + "expected a side or the closing brace of the brush, found \"4\"");
  EXPECT_EQ(error_of_side("w 0 0 0 " + std::string(500, 'x')),
            place + "expected a finite number, found \"" + std::string(40, 'x') + "...\"");
  EXPECT_EQ(error_of_map("{ { ( 0 0 1e8 )\n ( 0 0 0 ) ( 0 0 0 ) w 0 0 0 1 1 } }"),
            "entity 0, brush 0, line 1: the coordinate 100000000 is beyond +-16777216");
  EXPECT_EQ(error_of_map("{ { ( 0 0"),
            "entity 0, brush 0, line 1: expected a finite number, found the end of the text");
}

TEST(Map, NumbersTooSmallForADoubleAreRead) {
  EXPECT_EQ(read_side("w 1e-310 4.9e-324 0 1 1").texturing.offset, math::Vec2d(1e-310, 4.9e-324));
}

TEST(Map, HundredThousandBrushes) {
  const int brushes = test::effort(100000, 5000);
  std::string text = "{\n";
  for (int i = 0; i < brushes; ++i) {
    text += "{\n";
    for (int side = 0; side < 6; ++side) text += std::string(kPoints) + "wall 0 0 0 1 1\n";
    text += "}\n";
  }
  EXPECT_EQ(read_map_text(text + "}").entities.at(0).brushes.size(), static_cast<std::size_t>(brushes));
}

// Classifies the lines of a stock map by their first character: sides start with a parenthesis, pairs with a
// quote; a brace opens an entity, or a brush in an entity.
struct LineCounts {
  std::size_t entities = 0, brushes = 0, sides = 0, pairs = 0;
  bool operator==(const LineCounts&) const = default;
};

LineCounts count_lines(std::string_view text) {
  LineCounts counts;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    if (text[at] == '(') ++counts.sides;
    if (text[at] == '"') ++counts.pairs;
    if (text[at] == '{') ++(depth++ == 0 ? counts.entities : counts.brushes);
    if (text[at] == '}') --depth;
  }
  EXPECT_EQ(depth, 0);
  return counts;
}

LineCounts count_map_lines(const Map& map) {
  LineCounts counts;
  counts.entities = map.entities.size();
  for (const MapEntity& entity : map.entities) {
    counts.pairs += entity.fields.pairs.size();
    counts.brushes += entity.brushes.size();
    for (const MapBrush& brush : entity.brushes) counts.sides += brush.sides.size();
  }
  return counts;
}

TEST(Map, StockMapsReadAndRoundTrip) {
  DATA_FOLDER_OR_SKIP(data);
  int maps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "mapsrc")) {
    SCOPED_TRACE(entry.path().filename());
    const base::ByteVector bytes = test::read_file(entry.path());
    const Map map = read_map_text(base::as_text(bytes));
    EXPECT_EQ(count_map_lines(map), count_lines(base::as_text(bytes)));
    EXPECT_EQ(map.entities.at(0).fields.classname(), "worldspawn");
    EXPECT_EQ(without_lines(read_map_text(write_map(map))), without_lines(map));
    ++maps;
  }
  EXPECT_GT(maps, 0);
}

double random_number(test::Random& random) {
  switch (random.below(4)) {
    case 0:
      return static_cast<double>(random.below(64)) * 8 - 256;
    case 1:
      return random.uniform(-4096, 4096);
    case 2:
      return random.log_uniform(1e-300, 1e7);
    default:
      return -random.log_uniform(1e-30, 1);
  }
}

std::string random_map_text(test::Random& random, std::string_view alphabet) {
  std::string text(random.below(6), ' ');
  for (char& c : text) c = alphabet[random.below(alphabet.size())];
  return text;
}

MapSide random_side(test::Random& random) {
  MapSide side;
  for (math::Vec3d& point : side.points_world)
    for (const int axis : {0, 1, 2}) point[axis] = random_number(random);
  side.texture = random_map_text(random, "a{};/*+ ()[]\xc3");
  MapTexturing& texturing = side.texturing;
  texturing.alignment = static_cast<MapAlignment>(random.below(3));
  if (texturing.alignment == MapAlignment::kBrushPrimitive) {
    for (auto& row : texturing.matrix)
      for (double& number : row) number = random_number(random);
  } else {
    texturing.offset = {random_number(random), random_number(random)};
    texturing.rotation_deg = random_number(random);
    texturing.scale = {random_number(random) + 1e8, random_number(random) - 1e8};
  }
  if (texturing.alignment == MapAlignment::kValve)
    for (const int axis : {0, 1, 2}) {
      texturing.s_axis[axis] = random_number(random);
      texturing.t_axis[axis] = random_number(random);
    }
  if (random.chance(0.3))
    side.flags = {static_cast<std::int32_t>(random.bits()), 0, static_cast<std::int32_t>(random.bits())};
  return side;
}

Map random_map(test::Random& random) {
  Map map;
  map.entities.resize(random.below(4));
  for (MapEntity& entity : map.entities) {
    for (std::size_t i = random.below(4); i > 0; --i)
      entity.fields.pairs.emplace_back(random_map_text(random, "ab{}/\\ ;"),
                                       random_map_text(random, "cd{}/\\ '\xff"));
    entity.brushes.resize(random.below(3));
    for (MapBrush& brush : entity.brushes)
      for (std::size_t i = random.below(5); i > 0; --i) brush.sides.push_back(random_side(random));
  }
  return map;
}

TEST(Map, RoundTrips) {
  for (int seed = 0; seed < test::effort(3000, 300); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const Map map = random_map(random);
    EXPECT_TRUE(without_lines(read_map_text(write_map(map))) == map) << "seed " << seed << '\n'
                                                                     << write_map(map);
  }
}

TEST(Map, TruncatedTextIsAnErrorOrTheFirstEntities) {
  test::Random random(1);
  for (int round = 0; round < test::effort(20, 4); ++round) {
    const std::string text = write_map(random_map(random));
    const Map whole = read_map_text(text);
    for (std::size_t size = 0; size < text.size(); ++size) {
      const auto map = read_map(std::string_view(text).substr(0, size));
      if (map.ok()) {
        EXPECT_LE(map->entities.size(), whole.entities.size());
        EXPECT_TRUE(std::ranges::equal(map->entities, std::span(whole.entities).first(map->entities.size())));
      } else {
        EXPECT_NE(map.error().what.find("line "), std::string::npos);
      }
    }
  }
}

}  // namespace
}  // namespace temblor::formats
