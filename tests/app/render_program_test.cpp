// `temblor render` and `temblor settings`.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/program.h"
#include "formats/levels/entities.h"
#include "support/game_data.h"
#include "support/programs/small_game.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;

class RenderProgram : public ::testing::Test {
 protected:
  // Draws one small picture and reads it back.
  Png draw(Words words) {
    words.insert(words.end(), {"-o", "picture.png"});
    const ProgramRun run = run_program(folder_.path(), words);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    return read_png(folder_.path() / "picture.png");
  }
  static Words small_render(const Words& more = {}) {
    Words words = {"render", "--size", "160x96"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  TemporaryFolder folder_;
};

TEST_F(RenderProgram, DrawsALevelWithoutGameData) {
  const Png png = draw(small_render());
  EXPECT_EQ(png.width, 160u);
  EXPECT_EQ(png.height, 96u);
  EXPECT_FALSE(png.indexed);
  EXPECT_GT(count_colors(png), 100u);
}

TEST_F(RenderProgram, IndexedPicturesKeepTheirPalette) {
  const Png png = draw(small_render({"--color", "indexed"}));
  EXPECT_TRUE(png.indexed);
  EXPECT_GT(count_colors(png), 30u);
  EXPECT_LE(count_colors(png), 256u);
}

TEST_F(RenderProgram, ThreadsDoNotChangeThePicture) {
  EXPECT_EQ(draw(small_render({"--threads", "1"})),
            draw(small_render({"--threads", "3", "--set", "r_job_backend=stdthread"})));
}

TEST_F(RenderProgram, DefaultViewIsThePlayers) {
  const std::vector<formats::Entity> entities =
      formats::read_entities(artgen::make_small_level().entities).value();
  const auto start = std::find_if(entities.begin(), entities.end(), [](const formats::Entity& entity) {
    return entity.classname() == "info_player_start";
  });
  ASSERT_NE(start, entities.end());
  const math::Vec3 origin = start->find_vec3("origin").value();
  const std::string position = fmt::format("{},{},{}", origin.x, origin.y, origin.z + 22);
  const std::string angles = fmt::format("0,{},0", start->find_number("angle").value_or(0));
  EXPECT_EQ(draw(small_render()), draw(small_render({"--pos", position, "--angles", angles})));
  EXPECT_NE(draw(small_render()), draw(small_render({"--pos", position, "--angles", "0,200,0"})));
}

TEST_F(RenderProgram, OrthographicViewLooksDownAtTheCenter) {
  const formats::BspModel world = artgen::make_small_level().models[0];
  const math::Vec3 center = (world.mins + world.maxs) * 0.5f;
  const Words overview = small_render({"--projection", "orthographic"});
  Words same = overview;
  same.insert(same.end(),
              {"--pos", fmt::format("{},{},{}", center.x, center.y, center.z), "--angles", "90,0,0"});
  const Png png = draw(overview);
  EXPECT_EQ(png, draw(same));
  EXPECT_GT(count_colors(png), 30u);
}

TEST_F(RenderProgram, LevelByNameEqualsLevelByFile) {
  const SmallGame game;
  const Png made_in_code = draw(small_render());
  EXPECT_EQ(draw(small_render({"--basedir", game.path().string(), "--map", "small"})), made_in_code);
  EXPECT_EQ(draw(small_render({"--basedir", game.path().string(), "--map", "SMALL"})), made_in_code);
  EXPECT_EQ(draw(small_render(
                {"--basedir", game.path().string(), "--map", (game.path() / "id1/maps/small.bsp").string()})),
            made_in_code);
}

TEST_F(RenderProgram, CurrentDirectoryIsTheBasedirIfItContainsId1) {
  const SmallGame game;
  const ProgramRun run = run_program(game.path(), small_render({"--map", "small", "-o", "x.png"}));
  EXPECT_EQ(run.exit_status, 0) << run.err;
}

TEST_F(RenderProgram, LastGameHasPriority) {
  const SmallGame game;
  artgen::SmallLevelOptions other;
  other.tiny = true;
  const base::ByteVector bytes =
      formats::write_bsp(artgen::make_small_level(other), formats::BspVersion::k29).value();
  game.folder().write("mod/maps/small.bsp", bytes);
  game.folder().write("last/maps/other.bsp", bytes);
  const std::string base = game.path().string();
  const Png plain = draw(small_render({"--basedir", base, "--map", "small"}));
  const Png modded =
      draw(small_render({"--basedir", base, "--game", "mod", "--game", "last", "--map", "small"}));
  EXPECT_NE(plain, modded);
  EXPECT_EQ(draw(small_render({"--basedir", base, "--game", "last", "--map", "small"})), plain);
  EXPECT_EQ(draw(small_render({"--basedir", base, "--game", "last", "--map", "other"})), modded);
}

TEST_F(RenderProgram, TurnMakesASequenceOfViews) {
  const ProgramRun run =
      run_program(folder_.path(),
                  small_render({"--angles", "5,30,0", "--frames", "3", "--turn", "10", "-o", "t-%03d.png"}));
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(read_png(folder_.path() / "t-000.png"), draw(small_render({"--angles", "5,30,0"})));
  EXPECT_EQ(read_png(folder_.path() / "t-002.png"), draw(small_render({"--angles", "5,50,0"})));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "t-003.png"));
}

TEST_F(RenderProgram, UsesSettings) {
  const Png plain = draw(small_render());
  EXPECT_NE(draw(small_render({"--set", "r_mip_force=3"})), plain);
  EXPECT_EQ(draw(small_render({"--set", "r_mip_force=3", "--set", "r_mip_force=-1"})), plain);
  EXPECT_NE(draw(small_render({"--set", "r_colored_light=0"})), plain);
}

TEST_F(RenderProgram, UsesTheGamesOwnSettings) {
  const SmallGame game;
  const auto drawn = [&](const Words& more) {
    Words words = small_render({"--basedir", game.path().string(), "--map", "small"});
    words.insert(words.end(), more.begin(), more.end());
    return draw(words);
  };
  const Png plain = drawn({});
  game.folder().write("id1/default.cfg",
                      "bind x quit; r_mip_force 3 // coarse\nr_fullbright maybe\nnonsense 1\n");
  EXPECT_NE(drawn({}), plain);
  EXPECT_EQ(drawn({"--set", "r_mip_force=-1"}), plain);
  game.folder().write("mod/default.cfg", "r_mip_force -1");
  EXPECT_EQ(drawn({"--game", "mod"}), plain);
}

TEST_F(RenderProgram, ShowDrawsDifferentPictures) {
  std::vector<Png> pictures = {draw(small_render())};
  for (const char* kind : {"faces", "edges", "spans", "surfaces", "mips", "pvs", "overdraw", "depth"}) {
    const Png png = draw(small_render({"--show", kind}));
    EXPECT_EQ(png, draw({"--set", fmt::format("r_show={}", kind), "render", "--size", "160x96"})) << kind;
    EXPECT_NE(png, pictures.front()) << kind;
  }
}

TEST_F(RenderProgram, StatsNameEveryStage) {
  const ProgramRun run = run_program(folder_.path(), small_render({"--stats", "-o", "x.png"}));
  ASSERT_EQ(run.exit_status, 0) << run.err;
  for (const char* word : {"in PVS", "edges", "spans", "built", "cache", "texels", "view", "visibility",
                           "scan", "surfaces", "total", "cycles/pixel"})
    EXPECT_THAT(run.out, HasSubstr(word));
}

TEST_F(RenderProgram, ReportsAMissingTextureOnce) {
  const SmallGame game({.missing_texture = true});
  const ProgramRun run = run_program(game.path(), small_render({"--map", "small", "-o", "x.png"}));
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("note"));
}

// The loader of EGL finds no driver then.
TEST_F(RenderProgram, SaysThatOpenGlIsMissing) {
  ASSERT_EQ(setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1), 0);
  const ProgramRun run = run_program(folder_.path(), small_render({"--renderer", "gl", "-o", "x.png"}));
  unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  if (run.exit_status == 0) GTEST_SKIP() << "this system's EGL does not read the variable";
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("OpenGL is missing"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "x.png"));
}

TEST_F(RenderProgram, EveryCommandHasHelpWithExamples) {
  for (const char* command : {"", "render", "bench", "inspect", "settings"}) {
    Words words = {command, "--help"};
    if (words[0].empty()) words.erase(words.begin());
    const ProgramRun run = run_program(folder_.path(), words);
    EXPECT_EQ(run.exit_status, 0);
    EXPECT_THAT(run.out, HasSubstr("Examples:")) << command;
    EXPECT_THAT(run.err, IsEmpty());
  }
}

TEST_F(RenderProgram, SettingsListsValuesAndHelp) {
  const ProgramRun run = run_program(folder_.path(), {"--set", "r_mip_rule=stock", "settings"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.out, HasSubstr("r_mip_rule = stock\n"));
  EXPECT_THAT(run.out, HasSubstr("Values: footprint or stock. Default: footprint."));
}

TEST_F(RenderProgram, StockLevelsInBothFormats) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* color : {"indexed", "rgb"}) {
    const ProgramRun run =
        run_program(folder_.path(), small_render({"--basedir", std::filesystem::absolute(data).string(),
                                                  "--map", "lq_e0m1", "--color", color, "-o", "x.png"}));
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_GT(count_colors(read_png(folder_.path() / "x.png")), 30u);
  }
}

}  // namespace
}  // namespace temblor::test
