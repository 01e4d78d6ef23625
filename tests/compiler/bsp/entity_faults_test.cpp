// Mistakes in entities are reported with entity and line, and correct entities are not.
#include "compiler/bsp/brushes/entity_faults.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/bsp/brushes/key_names.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> list_faults(const std::string& map_text) {
  compiler::Warnings warnings;
  compiler::warn_about_entity_faults(parse_map(map_text), warnings);
  std::vector<std::string> texts;
  for (const compiler::Warning& warning : warnings) texts.push_back(warning.kind + ": " + warning.what);
  return texts;
}

TEST(EntityFaults, NameEntityAndLine) {
  const std::string box = box_text({0, 0, 0}, {16, 16, 16}, "wall");
  EXPECT_THAT(
      list_faults("{\n\"classname\" \"worldspawn\"\n}\n{\n\"origin\" \"0 0 0\"\n}\n{\n" + box + "}\n"),
      ElementsAre(HasSubstr("entity without a class name: entity 1 (no class), line 4"),
                  HasSubstr("entity without a class name: entity 2 (no class), line 7")));
  EXPECT_THAT(list_faults(entity_text("func_door", "\"speed\" \"50\"")),
              ElementsAre(HasSubstr("brush entity without brushes: entity 0 (func_door), line 1")));
  EXPECT_THAT(
      list_faults(entity_text("light", "\"message\" \"" + std::string(4097, 'm') + "\"")),
      ElementsAre(HasSubstr("value too long: entity 0 (light), line 1: message has 4097 characters")));
  EXPECT_THAT(list_faults(entity_text("light", "\"_sofftangle\" \"9\"\n\"_zzz\" \"1\"")),
              ElementsAre("unknown key: entity 0 (light), line 1: _sofftangle is ignored; did you mean "
                          "_softangle?",
                          "unknown key: entity 0 (light), line 1: _zzz is ignored"));
}

TEST(EntityFaults, CorrectEntitiesHaveNone) {
  EXPECT_THAT(list_faults(entity_text("func_door", "", box_text({0, 0, 0}, {16, 16, 16}, "wall"))),
              IsEmpty());
  EXPECT_THAT(list_faults(entity_text("func_train", "\"model\" \"*3\"")), IsEmpty());
  // Points in many mods, and empty groups of editors.
  EXPECT_THAT(list_faults(entity_text("trigger_relay", "") + entity_text("func_group", "")), IsEmpty());
  EXPECT_THAT(list_faults(entity_text("light", "\"message\" \"" + std::string(4096, 'm') + "\"")), IsEmpty());
  // Keys of editors are not in the level, and the game reads keys without an underscore.
  EXPECT_THAT(
      list_faults(entity_text("worldspawn", "\"_tb_mod\" \"ad\"\n\"_tb_def\" \"" + std::string(9999, 'w') +
                                                "\"\n\"sofftangle\" \"1\"\n\"_Phong\" \"1\"")),
      IsEmpty());
  for (const std::string_view name : compiler::known_key_names())
    EXPECT_THAT(list_faults(entity_text("light", fmt::format("\"targetname\" \"1\"\n\"_{}\" \"1\"", name))),
                IsEmpty())
        << name;
}

TEST(EntityFaults, SurfaceLightsNameALight) {
  const std::string brushes = entity_text("func_group", "\"_surflight_targetname\" \"lamps\"",
                                          box_text({0, 0, 0}, {8, 8, 8}, "wall"));
  const auto with_name = [&](const char* of_class, const char* key, const char* name) {
    return list_faults(brushes + entity_text(of_class, fmt::format("\"{}\" \"{}\"", key, name)));
  };
  EXPECT_THAT(with_name("light_torch_small_walltorch", "targetname", "lamps"), IsEmpty());
  EXPECT_THAT(with_name("func_detail", "_switchableshadow_target", "lamps"), IsEmpty());
  const auto is_reported = ElementsAre(
      "surface lights with a missing light: entity 0 (func_group), line 1: no light has the targetname "
      "lamps, so _surflight_targetname is ignored");
  EXPECT_THAT(with_name("light", "targetname", "lamp"), is_reported);
  EXPECT_THAT(with_name("light", "target", "lamps"), is_reported);
  EXPECT_THAT(with_name("trigger_relay", "targetname", "lamps"), is_reported);
}

TEST(EntityFaults, FirstEntityIsWorldspawn) {
  const auto problem = [](const std::string& text) {
    const base::Status status = compiler::check_worldspawn(parse_map(text));
    return status.ok() ? std::string() : status.error().what;
  };
  EXPECT_EQ(problem(entity_text("worldspawn", "")), "");
  EXPECT_THAT(problem(""), HasSubstr("line 1: the file has no entities"));
  EXPECT_THAT(
      problem("\n" + entity_text("light", "") + entity_text("worldspawn", "")),
      HasSubstr("line 2: the first entity (light) is not worldspawn; move it from line 6 to the top"));
  EXPECT_THAT(problem(entity_text("light", "")), HasSubstr("(light) is not worldspawn; there is none"));
  EXPECT_THAT(problem("{\n}\n"), HasSubstr("line 1: the first entity (no class)"));
}

}  // namespace
}  // namespace temblor::test
