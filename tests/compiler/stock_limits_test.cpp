// Warnings about the limits of the original engine (compiler/stock_limits.h).
#include "compiler/stock_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "compiler/drafts.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

compiler::Warnings find_limits(const std::string& map_text) {
  compiler::Warnings warnings, limits;
  EXPECT_TRUE(try_compile_draft(map_text, warnings).ok());
  for (const compiler::Warning& warning : warnings)
    if (warning.kind.find("limit") != std::string::npos) limits.push_back(warning);
  return limits;
}

// Brush entities in the room, and the line on which the brushes of number `asked` begin.
struct ManyModels {
  std::string text = room_text();
  std::ptrdiff_t line = 0;
};
ManyModels make_models(int count, int asked) {
  ManyModels made;
  for (int i = 1; i <= count; ++i) {
    if (i == asked) made.line = 1 + std::ranges::count(made.text, '\n');
    const math::Vec3d at(-120 + i % 16 * 8, -120 + i / 16 * 8, 8);
    made.text += entity_text("func_wall", "", box_text(at, at + 4.0, "block"));
  }
  return made;
}

TEST(StockLimits, TheFirstModelBeyondTheLimitIsNamed) {
  EXPECT_THAT(find_limits(make_models(255, 0).text), IsEmpty()) << "256 with the world";
  const ManyModels more = make_models(270, 256);
  const compiler::Warnings limits = find_limits(more.text);
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_EQ(limits[0].kind, "271 models exceed the original engine's limit of 256");
  // Entity 0 is the world and entity 1 the player's start.
  EXPECT_EQ(limits[0].what,
            fmt::format("entity 257 (func_wall), line {}, is the first beyond it", more.line));
}

// A floor of pillars with sides of their own. Every cut side is a plane, a node, and a face.
TEST(StockLimits, TheGroupWithMostBrushesOfTheWorldIsNamed) {
  std::string pillars;
  for (int i = 0; i < 2500; ++i) {
    const math::Vec3d at(-4000 + i % 50 * 160 + i * 0.01, -4000 + i / 50 * 160 + i * 0.013, -8);
    pillars += box_text(at, at + math::Vec3d(40 + i * 0.003, 50 + i * 0.007, 100 + i * 0.01), "wall");
  }
  const std::string walls = walls_text({-4090, -4090, 0}, {4090, 4090, 400}, "wall");
  const std::string world = entity_text("worldspawn", "", walls);
  const compiler::Warnings limits =
      find_limits(world + entity_text("func_group", "", pillars) + point_text("light", {0, 0, 300}));
  ASSERT_FALSE(limits.empty());
  for (const compiler::Warning& limit : limits) {
    EXPECT_THAT(limit.what, HasSubstr(fmt::format("entity 1 (func_group), line {}, adds most: 2500 brushes",
                                                  1 + std::ranges::count(world, '\n'))));
    EXPECT_THAT(limit.kind, ::testing::AnyOf(HasSubstr("leaves"), HasSubstr("clipnodes"))) << limit.kind;
  }
}

TEST(StockLimits, TheFarthestCornerIsNamed) {
  const auto room_to = [](double x) {
    return entity_text("worldspawn", "", walls_text({x - 200, 0, -100}, {x, 256, 100}, "wall")) +
           point_text("info_player_start", {x - 100, 100, -50});
  };
  EXPECT_THAT(find_limits(room_to(4096)), IsEmpty());
  const compiler::Warnings limits = find_limits(room_to(5000));
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_EQ(limits[0].kind, "5000 units from the origin exceed the original engine's limit of 4096");
  EXPECT_THAT(limits[0].what, HasSubstr("a corner at 5000 "));
}

TEST(StockLimits, BytesNameTheirLargestPart) {
  // The level has neither groups nor keys of editors.
  const std::string unwritten(90'000, 'x');
  std::string text = room_text() + entity_text("func_group", fmt::format("\"name\" \"{}\"", unwritten), "") +
                     entity_text("info_null", fmt::format("\"_tb_name\" \"{}\"", unwritten), "");
  const auto lines = std::ranges::count(text, '\n');
  text += entity_text("info_notnull", fmt::format("\"message\" \"{}\"", std::string(70'000, 'x')), "");
  const formats::Map map = parse_map(text);
  const compiler::DraftResult result = compile_draft(text);
  formats::Bsp bsp = result.draft.bsp;
  bsp.miptexes[0].mips[0].assign(3'000'000, 0);
  bsp.lighting.assign(1'048'577, 0);
  bsp.visibility.assign(1'048'576, 0);
  compiler::Warnings warnings;
  compiler::warn_about_bytes({map, result.draft.brush_entities}, bsp, warnings);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_THAT(warnings[0].kind, HasSubstr("3000040 bytes of textures exceed"));
  EXPECT_THAT(warnings[0].what, HasSubstr("\"wall\" is the largest, 3000040 bytes, first on line"));
  EXPECT_THAT(warnings[1].kind, HasSubstr("bytes of entity text exceed"));
  EXPECT_THAT(
      warnings[1].what,
      HasSubstr(fmt::format("4 entities; the longest is entity 4 (info_notnull), line {}", lines + 1)));
  EXPECT_THAT(warnings[2].kind, HasSubstr("1048577 bytes of light exceed"));
  EXPECT_THAT(warnings[2].what, HasSubstr("entity 0 (worldspawn), line 1, has most faces: "));
}

}  // namespace
}  // namespace temblor::test
