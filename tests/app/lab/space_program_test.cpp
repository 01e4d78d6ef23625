// `temblor lab run space`: the space battle as a picture, figures, a plot, and in a window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "app/lab/space_pilot.h"
#include "app/lab/space_window.h"
#include "app/program.h"
#include "platform/headless/window.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using app::SpacePilot;
using math::Vec3d;
using nlohmann::json;
using platform::Key;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

ProgramRun run_space(const std::filesystem::path& folder, const Words& words) {
  Words all{"lab", "run", "space"};
  all.insert(all.end(), words.begin(), words.end());
  return run_program(folder, all);
}

TEST(SpaceProgram, WritesAPictureOfTheBattle) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_space(folder.path(), {"--shape", "both", "--solids", "200", "--size", "160x120", "-o", "x.png"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  const Png png = read_png(folder.path() / "x.png");
  EXPECT_EQ(png.width, 160u);
  EXPECT_EQ(png.height, 120u);
  EXPECT_GT(count_colors(png), 100u);
}

TEST(SpaceProgram, MeasuresItsCost) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_space(folder.path(), {"--size", "64x48", "--json", "--shape", "concave", "-o", "x.svg"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result.at("size"), "64x48");
  EXPECT_EQ(result.at("shape"), "concave");
  std::vector<int> solids;
  double edges = 0;
  for (const json& figures : result.at("figures")) {
    solids.push_back(figures.at("solids"));
    EXPECT_GT(figures.at("frame_ms"), 0.0);
    EXPECT_GT(figures.at("edges"), edges);
    EXPECT_GE(figures.at("spans"), 48.0);
    edges = figures.at("edges");
  }
  EXPECT_EQ(solids, (std::vector{10, 100, 1000, 10000}));
  const std::string svg = read_text(folder.path() / "x.svg");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(svg, HasSubstr(">convex<"));
  EXPECT_THAT(svg, HasSubstr(">concave<"));
  EXPECT_THAT(svg, HasSubstr(">10000<"));
}

TEST(SpaceProgram, IsListed) {
  const TemporaryFolder folder;
  EXPECT_THAT(run_program(folder.path(), {"lab", "list"}).out,
              HasSubstr("space: The sorted-spans sample, a space battle\n"));
  const json list = json::parse(run_program(folder.path(), {"lab", "list", "--json"}).out);
  EXPECT_EQ(list.back().at("name"), "space");
}

TEST(SpaceProgram, ExplainsMistakes) {
  const TemporaryFolder folder;
  struct Mistake {
    Words words;
    const char* message;
  };
  const Mistake mistakes[] = {
      {{"run", "space", "--map", "start"}, "--map is for levels, and space has none"},
      {{"run", "space", "--demo", "demo1"}, "--demo is for levels"},
      {{"run", "space", "--threads", "2"}, "--threads is for levels"},
      {{"run", "space", "--rounds", "3"}, "--rounds is for levels"},
      {{"run", "space", "--solids", "0"}, "not in range 1 to 10000"},
      {{"run", "space", "--solids", "10001"}, "not in range 1 to 10000"},
      {{"run", "space", "--shape", "cube"}, "is not convex, concave, or both"},
      {{"run", "space", "--sorting", "bsp"}, "is not independent, abutting, or intersecting"},
      {{"run", "space", "--spacing", "0"}, "--spacing"},
      {{"run", "space", "--spacing", "nan"}, "Value nan is not a number"},
      {{"run", "space:solids=3"}, "space has options instead of parameters"},
      {{"compare", "painter", "space:solids=3"}, "space has options instead of parameters"},
      {{"run", "space", "--size", "0x10"}, "--size"},
      {{"run", "space", "-o", "x.gif"}, "space writes a picture (.png) or a plot (.svg)"},
      {{"run", "space", "-o", "nowhere/x.png"}, "nowhere"},
      {{"run", "painter", "--solids", "3"}, "--solids is an option of `temblor lab run space`"},
      {{"compare", "painter", "space"}, "space is a scene of its own"}};
  for (const Mistake& mistake : mistakes) {
    Words words{"lab"};
    words.insert(words.end(), mistake.words.begin(), mistake.words.end());
    const ProgramRun run = run_program(folder.path(), words);
    EXPECT_NE(run.exit_status, 0) << mistake.message;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(mistake.message));
  }
}

// Holds a key for a second.
SpacePilot fly(Key key) {
  SpacePilot pilot(Vec3d(0.0), {});
  pilot.handle({0, platform::KeyChange{key, true}});
  for (int i = 0; i < 100; ++i) pilot.fly(0.01);
  return pilot;
}

TEST(SpacePilotKeys, TurnAndThrust) {
  EXPECT_LT(fly(Key::kRightArrow).axes().forward.y, -0.5);
  EXPECT_GT(fly(Key::kLeftArrow).axes().forward.y, 0.5);
  EXPECT_GT(fly(Key::kUpArrow).axes().forward.z, 0.5);
  EXPECT_LT(fly(Key::kDownArrow).axes().forward.z, -0.5);
  EXPECT_LT(fly(Key{'d'}).axes().up.y, -0.5);
  EXPECT_GT(fly(Key{'a'}).axes().up.y, 0.5);
  EXPECT_GT(fly(Key{'w'}).place().x, 3);
  EXPECT_LT(fly(Key{'s'}).place().x, -3);
  for (const Key key : {Key::kRightArrow, Key::kUpArrow, Key{'d'}}) {
    const math::Basis axes = fly(key).axes();
    EXPECT_NEAR(glm::length(axes.up), 1, 1e-12);
    EXPECT_NEAR(glm::length(glm::cross(axes.forward, axes.up) - axes.right), 0, 1e-12);
  }
}

TEST(SpacePilotKeys, GoWithTheFocus) {
  SpacePilot pilot(Vec3d(0.0), {});
  pilot.handle({0, platform::KeyChange{Key::kUpArrow, true}});
  pilot.handle({0, platform::FocusChanged{false}});
  pilot.fly(1);
  EXPECT_EQ(pilot.axes().forward, Vec3d(1, 0, 0));
  EXPECT_FALSE(pilot.has_left());
  pilot.handle({0, platform::CloseRequested{}});
  EXPECT_TRUE(pilot.has_left());
}

TEST(SpaceWindow, ShowsTheBattleUntilEscape) {
  platform::headless::HeadlessWindow window({.size = {160, 120}});
  window.put_at(platform::KeyChange{Key::kRightArrow, true}, window.now_s() + 0.05);
  window.put_at(platform::KeyChange{Key::kEscape, true}, window.now_s() + 0.3);
  ASSERT_TRUE(app::play_space_in(window, {.size = {160, 120}}).ok());
  EXPECT_GT(window.pictures(), 2u);
  EXPECT_EQ(window.shown_size(), (platform::PixelSize{160, 120}));
  EXPECT_GT(std::set(window.shown().begin(), window.shown().end()).size(), 50u);
  window.set_can_present(false);
  EXPECT_FALSE(app::play_space_in(window, {.size = {160, 120}}).ok());
}

}  // namespace
}  // namespace temblor::test
