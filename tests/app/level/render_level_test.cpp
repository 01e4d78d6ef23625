// `temblor render --map`: which entities of a level it shows, in which sky, fog, and liquids, and what game
// code adds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "app/program.h"
#include "client_server/served_game.h"
#include "formats/images/png.h"
#include "formats/levels/entities.h"
#include "support/game_data.h"
#include "support/models/drawable_models.h"
#include "support/programs/quakec.h"
#include "support/programs/small_game.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;
using Keys = std::vector<std::pair<std::string, std::string>>;

// The game code of these tests: a prop is a model that only game code shows.
constexpr std::string_view kProp = R"(
void() func_wall = { self.solid = 4; self.movetype = 7; setmodel(self, self.model); };
void() prop = { setmodel(self, "progs/player.mdl"); };
)";
// Views of the level made in code: the middle of the hall, where a wall stands in the way; the pool in the
// court and the sky above it.
const Words kHall = {"--pos", "64,256,60", "--angles", "0,0,0"};
const Words kCourt = {"--pos", "1000,500,-20", "--angles", "10,315,0"};

class RenderLevel : public ::testing::Test {
 protected:
  // Adds keys to the world, and entities to the level.
  void write_level(const Keys& world_keys, const std::vector<Keys>& more = {},
                   formats::BspVersion version = formats::BspVersion::k29) {
    formats::Bsp bsp = game_.level();
    std::vector<formats::Entity> entities = formats::read_entities(bsp.entities).value();
    for (const auto& key : world_keys) entities[0].pairs.push_back(key);
    // The first entity of a model has the keys that count in Half-Life's levels.
    for (const Keys& keys : more) entities.insert(entities.begin() + 1, {keys});
    bsp.entities = formats::write_entities(entities);
    game_.folder().write("id1/maps/small.bsp", formats::write_bsp(bsp, version).value());
  }
  // A wall in the hall: the door's brush model, 400 units nearer.
  static Keys wall(const std::string& flags) {
    return {{"classname", "func_wall"}, {"model", "*1"}, {"origin", "-400 0 0"}, {"spawnflags", flags}};
  }
  void write_program(const std::string& code) {
    game_.folder().write("id1/progs/player.mdl", formats::write_mdl(box_mdl()));
    game_.folder().write("id1/progs.dat", compile_quakec(code));
  }

  ProgramRun run(const Words& view, const Words& more) {
    Words words = {"render", "--map", "small", "--size", "160x96", "-o", "x.png"};
    words.insert(words.end(), view.begin(), view.end());
    words.insert(words.end(), more.begin(), more.end());
    return run_program(game_.path(), words);
  }
  Png draw(const Words& view, const Words& more = {}) {
    const ProgramRun drawn = run(view, more);
    EXPECT_EQ(drawn.exit_status, 0) << drawn.err;
    return read_png(game_.path() / "x.png");
  }
  void expect_error(const Words& more, int status, const std::vector<std::string>& parts) {
    const ProgramRun failed = run(kHall, more);
    EXPECT_EQ(failed.exit_status, status);
    EXPECT_TRUE(is_one_error_line(failed.err)) << failed.err;
    for (const std::string& part : parts) EXPECT_THAT(failed.err, HasSubstr(part));
  }

  SmallGame game_;
};

TEST_F(RenderLevel, ShowsTheEntitiesOfASkillOrOfDeathmatch) {
  write_level({}, {});
  const Png without = draw(kHall);
  write_level({}, {wall("0")});
  const Png with = draw(kHall);
  ASSERT_NE(with, without);
  struct Case {
    const char* flags;
    Words options;
    bool is_shown;
  };
  const std::vector<Case> cases = {
      {"1792", {}, false},
      {"512", {}, false},
      {"1280", {}, true},
      {"2048", {}, true},
      {"1", {}, true},
      {"256", {"--skill", "0"}, false},
      {"512", {"--skill", "0"}, true},
      {"1024", {"--skill", "2"}, false},
      {"1024", {"--skill", "3"}, false},
      {"768", {"--skill", "3"}, true},
      {"1792", {"--deathmatch"}, true},
      {"2048", {"--deathmatch"}, false},
      {"2048", {"--deathmatch", "--skill", "3"}, false},
      {"512", {"--set", "skill=2"}, true},
      {"512", {"--set", "skill=2", "--skill", "1"}, false},
      {"1792", {"--set", "deathmatch=1"}, true},
  };
  for (const Case& c : cases) {
    write_level({}, {wall(c.flags)});
    EXPECT_EQ(draw(kHall, c.options), c.is_shown ? with : without)
        << c.flags << " " << ::testing::PrintToString(c.options);
  }
}

TEST_F(RenderLevel, StartsWhereThePlayersOfThatGameStart) {
  const auto start = [](const char* classname, const char* origin, const char* flags) {
    return Keys{{"classname", classname}, {"origin", origin}, {"angle", "45"}, {"spawnflags", flags}};
  };
  formats::Bsp bsp = game_.level();
  bsp.entities = formats::write_entities({{Keys{{"classname", "worldspawn"}}},
                                          {start("info_player_start", "100 64 40", "512")},
                                          {start("info_player_start", "256 64 40", "0")},
                                          {start("info_player_deathmatch", "64 300 40", "0")}});
  game_.folder().write("id1/maps/small.bsp", formats::write_bsp(bsp, formats::BspVersion::k29).value());
  EXPECT_EQ(draw({}), draw({"--pos", "256,64,62", "--angles", "0,45,0"}));
  EXPECT_EQ(draw({}, {"--skill", "2"}), draw({"--pos", "100,64,62", "--angles", "0,45,0"}));
  EXPECT_EQ(draw({}, {"--deathmatch"}), draw({"--pos", "64,300,62", "--angles", "0,45,0"}));
}

TEST_F(RenderLevel, LiquidsHaveTheLevelsOpacity) {
  const Png opaque = draw(kCourt);
  const Png translucent = draw(kCourt, {"--set", "r_wateralpha=0.5"});
  ASSERT_NE(opaque, translucent);
  write_level({{"wateralpha", "0.5"}});
  EXPECT_EQ(draw(kCourt), translucent);
  EXPECT_EQ(draw(kCourt, {"--set", "r_wateralpha=1"}), translucent)
      << "the level comes first, as in the game";
}

TEST_F(RenderLevel, EntitiesHaveTheOpacityOfTheirKeys) {
  const auto draw_wall = [&](const Keys& more) {
    Keys keys = wall("0");
    keys.insert(keys.end(), more.begin(), more.end());
    write_level({}, {keys});
    return draw(kHall);
  };
  write_level({});
  const Png without = draw(kHall), opaque = draw_wall({});
  ASSERT_NE(opaque, without);
  const Png translucent = draw_wall({{"alpha", "0.5"}});
  EXPECT_NE(translucent, opaque);
  EXPECT_NE(translucent, without);
  EXPECT_EQ(draw_wall({{"alpha", "0"}}), opaque);
  EXPECT_EQ(draw_wall({{"alpha", "-1"}}), without);
}

TEST_F(RenderLevel, EntitiesOfHalfLifeHaveItsRenderModes) {
  const auto draw_wall = [&](const Keys& more) {
    Keys keys = wall("0");
    keys.insert(keys.end(), more.begin(), more.end());
    write_level({}, {keys}, formats::BspVersion::k30);
    return draw(kHall);
  };
  write_level({}, {}, formats::BspVersion::k30);
  const Png without = draw(kHall), opaque = draw_wall({});
  const Png half = draw_wall({{"rendermode", "2"}, {"renderamt", "128"}});
  EXPECT_NE(half, opaque);
  EXPECT_NE(half, without);
  EXPECT_NE(draw_wall({{"rendermode", "5"}, {"renderamt", "128"}}), half) << "additive";
  EXPECT_NE(draw_wall({{"rendermode", "1"}, {"renderamt", "128"}, {"rendercolor", "255 0 0"}}), half);
  EXPECT_EQ(draw_wall({{"rendermode", "2"}}), without);
  EXPECT_EQ(draw_wall({{"rendermode", "4"}, {"renderamt", "9"}}), opaque);
}

TEST_F(RenderLevel, ShowsTheLevelsFog) {
  const Words plan = {"--projection", "orthographic"};
  const Png clear = draw(kCourt), clear_plan = draw(plan);
  // So dense that only fog is visible, except in the sky and at the nearest places.
  write_level({{"fog", "10 1 0 0"}});
  const Png foggy = draw(kCourt);
  std::size_t red = 0;
  for (std::size_t i = 0; i < foggy.rgb.size(); i += 3)
    red += foggy.rgb[i] > 250 && foggy.rgb[i + 1] < 5 && foggy.rgb[i + 2] < 5;
  EXPECT_GT(red, foggy.rgb.size() / 3 / 2);
  EXPECT_EQ(draw(kCourt, {"--set", "r_fog=0"}), clear);
  EXPECT_EQ(draw(plan), clear_plan) << "fog would hide everything from an overview";
}

TEST_F(RenderLevel, ShowsTheLevelsSkybox) {
  const Words up = {"--pos", "1000,500,-20", "--angles", "-80,0,0"};
  const Png clouds = draw(up);
  const std::vector<std::uint32_t> pixels(16, 0xff00ff00);
  for (const char* side : {"rt", "bk", "lf", "ft", "up", "dn"})
    game_.folder().write(std::string("id1/gfx/env/green") + side + ".png",
                         formats::write_png(pixels, 4, 4).value());
  write_level({{"sky", "green"}});
  const ProgramRun drawn = run(up, {});
  EXPECT_THAT(drawn.err, IsEmpty());
  const Png green = read_png(game_.path() / "x.png");
  const std::size_t middle = (green.rgb.size() / 3 / 2 + green.width / 2) * 3;
  EXPECT_EQ(green.rgb[middle], 0);
  EXPECT_EQ(green.rgb[middle + 1], 255);
  EXPECT_EQ(green.rgb[middle + 2], 0);
  EXPECT_EQ(draw(up, {"--set", "r_skybox=0"}), clouds);
}

TEST_F(RenderLevel, CameraInALiquidSeesWhatAPlayerThereSees) {
  const Words pool = {"--pos", "1200,224,-200", "--angles", "0,0,0"};
  EXPECT_NE(draw(pool), draw(pool, {"--set", "r_waterwarp=0"}));
  EXPECT_NE(draw(pool), draw(pool, {"--set", "v_tint_liquid=0"}));
}

// The server sends a player in the hall nothing about the cellar, which is a corner away.
TEST_F(RenderLevel, EntitiesAreThoseOfTheWholeLevel) {
  SKIP_WITHOUT_QUAKEC();
  write_program(small_program(kProp));
  const Words cellar = {"--pos", "256,960,60", "--angles", "0,180,0"};
  const Words above = {"--projection", "orthographic"};
  const Png empty = draw(cellar), plan = draw(above);
  EXPECT_EQ(draw(cellar, {"--time", "0"}), empty);
  write_level({}, {Keys{{"classname", "prop"}, {"origin", "100 960 60"}}});
  EXPECT_EQ(draw(cellar), empty) << "game code does not run";
  EXPECT_NE(draw(cellar, {"--entities", "--time", "0"}), empty);
  EXPECT_NE(draw(above, {"--entities", "--time", "0"}), plan);
  write_level({}, {Keys{{"classname", "prop"}, {"origin", "100 960 60"}, {"spawnflags", "512"}}});
  EXPECT_NE(draw(cellar, {"--entities", "--skill", "2"}), draw(cellar, {"--entities"}));
}

// Without a camera of its own, the picture is from the eyes of the player, whose body is never in it.
TEST_F(RenderLevel, PlayerIsNotInThePicture) {
  SKIP_WITHOUT_QUAKEC();
  write_program(small_program(kProp));
  const Words time = {"--time", "0"}, running = {"--time", "0", "--entities"};
  formats::Bsp bsp = game_.level();
  const Keys start = {{"classname", "info_player_start"}, {"origin", "256 256 24"}, {"angle", "90"}};
  bsp.entities = formats::write_entities({{Keys{{"classname", "worldspawn"}}}, {start}});
  game_.folder().write("id1/maps/small.bsp", formats::write_bsp(bsp, formats::BspVersion::k29).value());
  const Words beside = {"--pos", "200,256,60", "--angles", "0,0,0"};
  EXPECT_EQ(draw(beside, running), draw(beside, time));
  const Png seen = draw({}, running);
  EXPECT_GT(count_colors(seen), 100u);
  EXPECT_NE(seen, draw(beside, time));
}

TEST_F(RenderLevel, ReadsGameCodeFromAFile) {
  SKIP_WITHOUT_QUAKEC();
  game_.folder().write("id1/progs/player.mdl", formats::write_mdl(box_mdl()));
  game_.folder().write("code.dat", compile_quakec(small_program(kProp)));
  write_level({}, {Keys{{"classname", "prop"}, {"origin", "400 256 60"}}});
  EXPECT_NE(draw(kHall, {"--entities", "--progs", "code.dat", "--time", "0"}), draw(kHall));
  expect_error({"--entities", "--progs", "nowhere.dat"}, 1, {"nowhere.dat"});
}

TEST_F(RenderLevel, MissingOrFaultyGameCodeIsAnError) {
  expect_error({"--entities"}, 1, {"progs.dat", "id1", "--progs", "--basedir", "--game"});
  game_.folder().write("id1/progs.dat", std::string_view("no code"));
  expect_error({"--entities"}, 1, {"progs.dat"});
  SKIP_WITHOUT_QUAKEC();
  write_program(small_program("void() prop = { error(\"the prop broke\"); };"));
  write_level({}, {Keys{{"classname", "prop"}}});
  expect_error({"--entities"}, 1, {"the prop broke"});
  write_program(
      small_program("void() late = { error(\"too late\"); };"
                    "void() prop = { self.think = late; self.nextthink = time + 0.9; };"));
  expect_error({"--entities"}, 1, {"small", "too late"});
  write_program(
      small_program("void() late = { changelevel(\"other\"); };"
                    "void() prop = { self.think = late; self.nextthink = time + 0.9; };"));
  game_.folder().write("id1/maps/other.bsp", game_.level_bytes(formats::BspVersion::k29));
  expect_error({"--entities"}, 1, {"small", "other"});
}

TEST_F(RenderLevel, OptionsThatDoNotFitAreUsageErrors) {
  expect_error({"--skill", "7"}, 2, {"--skill", "3"});
  expect_error({"--skill", "-1"}, 2, {"--skill"});
  expect_error({"--skill", "hard"}, 2, {"--skill"});
  expect_error({"--progs", "x.dat"}, 2, {"--progs", "--entities"});
  for (const Words& words : {Words{"--entities"}, {"--skill", "1"}, {"--deathmatch"}}) {
    Words all = {"render", "--demo", "x", "-o", "x.png"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun failed = run_program(game_.path(), all);
    EXPECT_EQ(failed.exit_status, 2);
    EXPECT_TRUE(is_one_error_line(failed.err)) << failed.err;
    EXPECT_THAT(failed.err, HasSubstr("--demo"));
  }
  const ProgramRun failed = run_program(game_.path(), {"render", "--entities", "-o", "x.png"});
  EXPECT_EQ(failed.exit_status, 2);
  EXPECT_THAT(failed.err, HasSubstr("--map"));
}

// The program is not beside the shipped game, and there is no id1.
TEST_F(RenderLevel, LevelOnDiskNeedsNoGameData) {
  write_level({{"sky", "green"}});
  const Png by_name = draw(kCourt, {"--set", "r_skybox=0"});
  TemporaryFolder empty;
  std::filesystem::copy_file(game_.path() / "id1/maps/small.bsp", empty.path() / "castle.bsp");
  Words words = {"render", "--map", "castle.bsp", "--size", "160x96", "-o", "x.png"};
  words.insert(words.end(), kCourt.begin(), kCourt.end());
  const ProgramRun drawn = run_program_alone(empty.path(), words);
  EXPECT_EQ(drawn.exit_status, 0) << drawn.err;
  EXPECT_TRUE(is_one_error_line(drawn.err)) << drawn.err;
  EXPECT_THAT(drawn.err, HasSubstr("note: castle: the skybox green"));
  EXPECT_EQ(read_png(empty.path() / "x.png"), by_name);
  words.emplace_back("--entities");
  const ProgramRun failed = run_program_alone(empty.path(), words);
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(failed.err)) << failed.err;
  EXPECT_THAT(failed.err, HasSubstr("--basedir"));
}

// The texels of the level's textures are the only sign of its palette.
TEST_F(RenderLevel, LevelOnDiskOfAnotherGameGetsANote) {
  formats::Bsp bsp = game_.level();
  const TemporaryFolder empty;
  const auto draw_alone = [&] {
    empty.write("castle.bsp", formats::write_bsp(bsp, formats::BspVersion::k29).value());
    return run_program_alone(empty.path(),
                             {"render", "--map", "castle.bsp", "--size", "160x96", "-o", "x.png"});
  };
  EXPECT_EQ(draw_alone().err, "");
  bsp.miptexes[0].mips[0][0] ^= 1;
  const ProgramRun drawn = draw_alone();
  EXPECT_EQ(drawn.exit_status, 0) << drawn.err;
  EXPECT_TRUE(is_one_error_line(drawn.err)) << drawn.err;
  EXPECT_THAT(drawn.err, HasSubstr("note: castle: drawn with Temblor's palette"));
  EXPECT_THAT(drawn.err, HasSubstr("--basedir"));
}

// Game data without a palette: a folder that only holds levels.
TEST_F(RenderLevel, LevelOnDiskNeedsNoPalette) {
  const Png expected = draw(kHall);
  std::filesystem::remove(game_.path() / "id1/gfx/palette.lmp");
  Words words = {"render", "--map", "id1/maps/small.bsp", "--size", "160x96", "-o", "x.png"};
  words.insert(words.end(), kHall.begin(), kHall.end());
  const ProgramRun drawn = run_program(game_.path(), words);
  EXPECT_EQ(drawn.exit_status, 0) << drawn.err;
  EXPECT_THAT(drawn.err, HasSubstr("gfx/palette.lmp"));
  EXPECT_EQ(read_png(game_.path() / "x.png"), expected);
}

// The game has another level of that name, with another .lit.
TEST_F(RenderLevel, LevelOnDiskRunsWithTheGamesCode) {
  SKIP_WITHOUT_QUAKEC();
  write_program(small_program(kProp));
  write_level({}, {Keys{{"classname", "prop"}, {"origin", "400 256 60"}}});
  const Png expected = draw(kHall, {"--entities"});
  TemporaryFolder folder;
  std::filesystem::rename(game_.path() / "id1/maps/small.bsp", folder.path() / "small.bsp");
  game_.folder().write("id1/maps/small.bsp", std::string_view("another level"));
  game_.folder().write("id1/maps/small.lit", std::string_view("another level's light"));
  Words words = {
      "render", "--basedir", game_.path().string(), "--map", "small.bsp", "--entities", "--size", "160x96",
      "-o",     "x.png"};
  words.insert(words.end(), kHall.begin(), kHall.end());
  const ProgramRun drawn = run_program(folder.path(), words);
  EXPECT_EQ(drawn.exit_status, 0) << drawn.err;
  EXPECT_EQ(read_png(folder.path() / "x.png"), expected);
}

// Sky brushes hid these levels from above: one color covered the middle.
TEST(StockOverview, ShowsRoomsBelowTheSky) {
  DATA_FOLDER_OR_SKIP(data);
  const TemporaryFolder folder;
  for (const char* map : {"lqdm5", "lq_e1m2", "start"}) {
    const ProgramRun drawn =
        run_program(folder.path(), {"render", "--basedir", std::filesystem::absolute(data).string(), "--map",
                                    map, "--projection", "orthographic", "--size", "128x128", "-o", "x.png"});
    EXPECT_EQ(drawn.exit_status, 0) << drawn.err;
    EXPECT_GT(count_colors(read_png(folder.path() / "x.png")), 400u) << map;
  }
}

}  // namespace
}  // namespace temblor::test
