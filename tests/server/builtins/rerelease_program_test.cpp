// A compiled program that declares every function of the 2021 release by number 0 and name, and calls it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"
#include "server/system_source.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;

constexpr char kReleaseProgram[] = R"(
void(string s, ...) ex_bprint = #0;
void(entity client, string s, ...) ex_sprint = #0;
void(entity client, string s, ...) ex_centerprint = #0;
float() ex_finaleFinished = #0;
void(entity client, string sample) ex_localsound = #0;
void(vector point, float colormap, float lifetime, float depthtest) ex_draw_point = #0;
void(vector start, vector end, float colormap, float lifetime, float depthtest) ex_draw_line = #0;
void(vector start, vector end, float colormap, float size, float lifetime, float depthtest) ex_draw_arrow = #0;
void(vector start, vector direction, float length, float colormap, float size, float lifetime, float depthtest) ex_draw_ray = #0;
void(vector origin, float radius, float colormap, float lifetime, float depthtest) ex_draw_circle = #0;
void(vector min, vector max, float colormap, float lifetime, float depthtest) ex_draw_bounds = #0;
void(string s, vector origin, float size, float lifetime, float depthtest) ex_draw_worldtext = #0;
void(vector origin, float radius, float colormap, float lifetime, float depthtest) ex_draw_sphere = #0;
void(vector origin, float halfheight, float radius, float colormap, float lifetime, float depthtest) ex_draw_cylinder = #0;
float(entity bot, vector point) ex_bot_movetopoint = #0;
float(entity bot, entity goal) ex_bot_followentity = #0;
float(entity player) ex_CheckPlayerEXFlags = #0;
float(float distance, vector goal) ex_walkpathtogoal = #0;
void(string s) precache_sound = #19;
void(string name, string value) cvar_set = #72;
void(float to, float value) WriteByte = #52;
void(float to, string value) WriteString = #58;

void(entity player) test_prints = {
  precache_sound("a.wav");
  self.netname = "$qc_ogre";
  ex_bprint("$qc_died", player.netname, self.netname);
  ex_sprint(player, "$qc_got", "$qc_shells", "20");
  ex_centerprint(player, self.message);
  ex_centerprint(player, "$qc_unknown");
  ex_localsound(player, "a.wav");
};
void(entity player) test_harmless = {
  ex_draw_point('1 2 3', 4, 5, 0);
  ex_draw_line('1 2 3', '4 5 6', 7, 8, 0);
  ex_draw_arrow('1 2 3', '4 5 6', 7, 8, 9, 0);
  ex_draw_ray('1 2 3', '0 0 1', 100, 7, 8, 9, 1);
  ex_draw_circle('1 2 3', 4, 5, 6, 0);
  ex_draw_bounds('1 2 3', '4 5 6', 7, 8, 0);
  ex_draw_worldtext("text", '1 2 3', 4, 5, 0);
  ex_draw_sphere('1 2 3', 4, 5, 6, 0);
  ex_draw_cylinder('1 2 3', 4, 5, 6, 7, 0);
  cvar_set("campaign", "1");
  cvar_set("horde", "1");
  cvar_set("sv_gameplayfix_random", "1");
  self.health = ex_finaleFinished() + ex_bot_movetopoint(player, '1 2 3') + ex_bot_followentity(player, world) +
                ex_CheckPlayerEXFlags(player) + ex_walkpathtogoal(8, '1 2 3');
};
void() test_messages = {
  WriteByte(2, 52);
  WriteString(2, "ACH_FIND_SECRET");
  WriteByte(2, 31);
  WriteString(2, "$qc_finale");
};
)";

class ReleaseProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    QUAKEC_OR_SKIP(program, std::string(kSystemSource) + kReleaseProgram);
    stage = std::make_unique<Stage>(net::Dialect{}, program);
    stage->context.localization = &texts;
    for (const char* const name : {"campaign", "horde"})
      stage->variables.add_float(name, 0, 0, 1, "A number.");
    self = stage->spawn();
    stage->set_self(self);
    stage->set_text(self, server::field::kMessage, "$map_door");
    stage->set_text(Stage::kPlayer1, server::field::kNetName, "Joe");
  }
  std::string run(std::string_view function) {
    stage->machine.set_parameter_entity(0, Stage::kPlayer1);
    const base::Status status = stage->machine.call(stage->machine.program().find_function(function));
    return status.ok() ? "" : status.error().message();
  }
  template <typename Message>
  std::vector<std::string> texts_for(base::Bytes bytes) {
    std::vector<std::string> found;
    net::MessageReader reader(net::Dialect{});
    reader.begin(bytes, 0);
    for (auto message = reader.next().value(); message; message = reader.next().value())
      if (const auto* text = std::get_if<Message>(&*message)) found.emplace_back(text->text);
    return found;
  }
  const formats::Localization texts{formats::Localization::Texts{{"qc_ogre", "an ogre"},
                                                                 {"qc_died", "{0} was killed by {1}\n"},
                                                                 {"qc_got", "You get {1} {0}\n"},
                                                                 {"qc_shells", "shells"},
                                                                 {"qc_finale", "The end."},
                                                                 {"map_door", "It is locked."}}};
  std::unique_ptr<Stage> stage;
  vm::EntityIndex self{};
};

TEST_F(ReleaseProgram, PrintsTexts) {
  EXPECT_EQ(run("test_prints"), "");
  const base::Bytes own = stage->outbox.reliable_to(Stage::kPlayer1)->view();
  EXPECT_THAT(texts_for<net::Print>(stage->outbox.reliable().view()),
              ElementsAre("Joe was killed by an ogre\n"));
  EXPECT_THAT(texts_for<net::Print>(own), ElementsAre("You get 20 shells\n"));
  EXPECT_THAT(texts_for<net::CenterPrint>(own), ElementsAre("It is locked.", "$qc_unknown"));
  const server::Edict edict = stage->edict(self);
  EXPECT_EQ(stage->machine.text(edict[server::field::kNetName]), "$qc_ogre")
      << "entities keep keys, for saved games";
}

TEST_F(ReleaseProgram, OtherFunctionsAreHarmless) {
  EXPECT_EQ(run("test_harmless"), "");
  EXPECT_EQ(stage->edict(self)[server::field::kHealth], 0);
  EXPECT_EQ(stage->outbox.reliable().size() + stage->outbox.broadcast().size(), 0u);
  EXPECT_EQ(stage->variables.find("horde")->number, 1);
  EXPECT_EQ(stage->variables.find("sv_gameplayfix_random")->text, "1");
  EXPECT_EQ(stage->printed, "") << "no warnings";
}

TEST_F(ReleaseProgram, DrawsShapesForTheLocalPlayer) {
  EXPECT_EQ(run("test_harmless"), "");
  const server::DebugShapes& shapes = stage->context.debug_shapes;
  // Point 3, line 1, arrow and ray 5 each, circle 24, box 12, sphere 3 circles, cylinder 2 circles and 4
  // sides.
  EXPECT_EQ(shapes.lines().size(), 3u + 1 + 5 + 5 + 24 + 12 + 72 + 48 + 4);
  const auto& [line, look] = shapes.lines()[3];
  EXPECT_EQ(line.from_world, math::Vec3(1, 2, 3));
  EXPECT_EQ(line.to_world, math::Vec3(4, 5, 6));
  EXPECT_EQ(line.color, 7);
  EXPECT_FALSE(look.is_depth_tested);
  EXPECT_EQ(look.end_time_s, stage->world.time_s + 8);
  const auto& [ray, ray_look] = shapes.lines()[9];
  EXPECT_EQ(ray.to_world, math::Vec3(1, 2, 103));
  EXPECT_TRUE(ray_look.is_depth_tested);
  for (std::size_t i = 14; i < 38; ++i)
    EXPECT_NEAR(glm::distance(shapes.lines()[i].shape.to_world, math::Vec3(1, 2, 3)), 4, 1e-4) << "circle";
  for (std::size_t i = 50; i < 122; ++i)
    EXPECT_NEAR(glm::distance(shapes.lines()[i].shape.to_world, math::Vec3(1, 2, 3)), 4, 1e-4) << "sphere";
  ASSERT_EQ(shapes.texts().size(), 1u);
  EXPECT_EQ(shapes.texts()[0].shape.text, "text");
  EXPECT_EQ(shapes.texts()[0].shape.size, 4);
}

TEST_F(ReleaseProgram, ShapesEndAfterTheirLifetime) {
  EXPECT_EQ(run("test_harmless"), "");
  server::DebugShapes& shapes = stage->context.debug_shapes;
  const double now_s = stage->world.time_s;
  shapes.drop_ended(now_s + 5.5);
  // Text, point, and those that end at 5 or less are gone: the line, arrow, and cylinder are left, and
  // others.
  EXPECT_TRUE(shapes.texts().empty());
  for (const auto& [line, look] : shapes.lines()) EXPECT_GE(look.end_time_s, now_s + 5.5);
  EXPECT_FALSE(shapes.lines().empty());
  shapes.drop_ended(now_s + 100);
  EXPECT_TRUE(shapes.lines().empty());
}

TEST_F(ReleaseProgram, ShapesAreLimited) {
  for (int i = 0; i < 200; ++i) EXPECT_EQ(run("test_harmless"), "");
  for (int i = 0; i < 300; ++i) stage->context.debug_shapes.add({std::string(9999, 'x')}, {});
  EXPECT_EQ(stage->context.debug_shapes.lines().size(), server::DebugShapes::kMaxLines);
  EXPECT_EQ(stage->context.debug_shapes.texts().size(), server::DebugShapes::kMaxTexts);
  EXPECT_EQ(stage->context.debug_shapes.texts().back().shape.text.size(), server::DebugShapes::kMaxTextChars);
}

TEST_F(ReleaseProgram, WritesMessagesThatStockClientsKnow) {
  EXPECT_EQ(run("test_messages"), "");
  EXPECT_THAT(texts_for<net::Finale>(stage->outbox.reliable().view()), ElementsAre("The end."));
}

}  // namespace
}  // namespace temblor::test
