// `temblor compile` as mappers use it.
#include "app/compile/compile_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "artgen/palette.h"
#include "formats/bspx/light_directions.h"
#include "formats/images/png.h"
#include "formats/levels/pts.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Words = std::vector<std::string>;

TEST_F(CompileProgram, CompiledMapCanBeRendered) {
  folder_.write("room.map", lit_room());
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("texture")) << "the wall's texture is missing";
  EXPECT_THAT(run.out, HasSubstr("room.bsp"));
  const formats::Bsp bsp = read_level("room.bsp");
  EXPECT_EQ(bsp.version, formats::BspVersion::k29);
  EXPECT_THAT(bsp.lighting, Not(IsEmpty()));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "room.lit")) << "the light has a color";
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.pts"));
  const ProgramRun inspected = run_program(folder_.path(), {"inspect", "--json", "room.bsp"});
  EXPECT_EQ(inspected.exit_status, 0) << inspected.err;
  EXPECT_THAT(nlohmann::json::parse(inspected.out).value("problems", nlohmann::json::array()), IsEmpty());
}

TEST_F(CompileProgram, SameInputGivesTheSameBytes) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "a.bsp", "--threads", "1"}).exit_status,
            0);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "b.bsp", "--threads", "3"}).exit_status,
            0);
  EXPECT_EQ(read_text(folder_.path() / "a.bsp"), read_text(folder_.path() / "b.bsp"));
  EXPECT_EQ(read_text(folder_.path() / "a.lit"), read_text(folder_.path() / "b.lit"));
}

TEST_F(CompileProgram, StagesCanBeSkipped) {
  folder_.write("room.map", lit_room());
  const ProgramRun run = run_program(
      folder_.path(), {"compile", "room.map", "--no-light", "--no-vis", "--bsp2", "-o", "bare.bsp"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const formats::Bsp bsp = read_level("bare.bsp");
  EXPECT_EQ(bsp.version, formats::BspVersion::kBsp2);
  EXPECT_THAT(bsp.lighting, IsEmpty());
  EXPECT_THAT(bsp.visibility, IsEmpty());
}

TEST_F(CompileProgram, WritesLevelsForHalfLife) {
  folder_.write("room.map", lit_room());
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--hlbsp"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const formats::Bsp bsp = read_level("room.bsp");
  EXPECT_EQ(bsp.version, formats::BspVersion::k30);
  EXPECT_NE(bsp.find_bspx("RGBLIGHTING"), nullptr);
  EXPECT_GE(bsp.models[0].head_nodes[3], 0) << "the hull of ducking players";
  EXPECT_EQ(bsp.miptexes[0].palette.size(), 256u);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.lit")) << "the colors are in the level";
  const ProgramRun inspected = run_program(folder_.path(), {"inspect", "--json", "room.bsp"});
  EXPECT_EQ(inspected.exit_status, 0) << inspected.err;
  EXPECT_EQ(nlohmann::json::parse(inspected.out).at("version"), "30");
  // A second run reuses everything, and writes the same level.
  const std::string first = read_text(folder_.path() / "room.bsp");
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--hlbsp"}).exit_status, 0);
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), first);
  // The same map for Quake is another level.
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 0);
  EXPECT_EQ(read_level("room.bsp").version, formats::BspVersion::k29);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "room.lit"));
}

TEST_F(CompileProgram, WritesLumpsForNewerEngines) {
  folder_.write("room.map", lit_room());
  const Words compile{"compile", "room.map", "--2psb", "--brushlist", "--facenormals", "--hdr"};
  const ProgramRun run = run_program(folder_.path(), compile);
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const ProgramRun inspected = run_program(folder_.path(), {"inspect", "--json", "room.bsp"});
  ASSERT_EQ(inspected.exit_status, 0) << inspected.err;
  const nlohmann::json level = nlohmann::json::parse(inspected.out);
  const formats::Bsp bsp = read_level("room.bsp");
  EXPECT_EQ(level.at("version"), "2PSB");
  EXPECT_EQ(level.at("listed brushes").at("brushes"), 6);
  EXPECT_EQ(level.at("HDR light samples"), bsp.lighting.size());
  EXPECT_EQ(level.at("normals of corners"), bsp.surfedges.size());
  EXPECT_THAT(level.at("problems"), IsEmpty());
  const std::string first = read_text(folder_.path() / "room.bsp");
  EXPECT_THAT(run_program(folder_.path(), compile).out, ContainsRegex("bsp +unchanged"));
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), first);
  // Each option alone rebuilds what it changes.
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--clean", "-o", "plain.bsp"}).exit_status,
            0);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--brushlist"}).exit_status, 0);
  EXPECT_EQ(read_level("room.bsp").version, formats::BspVersion::k29);
  EXPECT_NE(read_level("room.bsp").find_bspx("BRUSHLIST"), nullptr);
  EXPECT_EQ(read_level("room.bsp").find_bspx("FACENORMALS"), nullptr);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 0);
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "plain.bsp"));
  // New light for a level without its map keeps the brushes.
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--brushlist", "--clean"}).exit_status, 0);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.bsp", "--only", "light", "--hdr"}).exit_status, 0);
  EXPECT_NE(read_level("room.bsp").find_bspx("BRUSHLIST"), nullptr);
  EXPECT_NE(read_level("room.bsp").find_bspx("LIGHTING_E5BGR9"), nullptr);
}

TEST_F(CompileProgram, WritesDirectionsOfLightBesideTheLevel) {
  folder_.write("room.map", lit_room());
  const auto lux_path = folder_.path() / "room.lux";
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--lux"}).exit_status, 0);
  const auto directions = formats::read_lux(read_file(lux_path)).value();
  EXPECT_EQ(directions, formats::read_light_directions(read_level("room.bsp")).value());
  EXPECT_FALSE(directions.empty());
  const ProgramRun inspected = run_program(folder_.path(), {"inspect", "--json", "room.bsp"});
  EXPECT_EQ(nlohmann::json::parse(inspected.out).at("light directions"), directions.size() / 3);
  const std::string first = read_text(folder_.path() / "room.bsp");
  // Another stage keeps them, and so does a level without its lump.
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.bsp", "--only", "vis"}).exit_status, 0);
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), first);
  formats::Bsp bare = read_level("room.bsp");
  formats::set_light_directions({}, bare);
  folder_.write("room.bsp", formats::write_bsp(bare, bare.version).value());
  std::filesystem::remove(folder_.path() / "room.build");
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.bsp", "--only", "vis"}).exit_status, 0);
  EXPECT_EQ(formats::read_light_directions(read_level("room.bsp")).value(), directions);
  // Without the option they disappear.
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 0);
  EXPECT_FALSE(std::filesystem::exists(lux_path));
  EXPECT_EQ(read_level("room.bsp").find_bspx("LIGHTINGDIR"), nullptr);
}

TEST_F(CompileProgram, ReportsAMissingLightLibraryAtOnce) {
  folder_.write("room.map", lit_room());
  for (const char* name : {"libembree3.so.3", "libembree4.so.4"})
    folder_.write(name, std::string_view("no library"));
  setenv("LD_LIBRARY_PATH", folder_.path().c_str(), 1);
  const ProgramRun refused = run_program(folder_.path(), {"compile", "room.map"});
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(refused.err)) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("libembree"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.bsp"));
  const ProgramRun bare = run_program(folder_.path(), {"compile", "room.map", "--no-light"});
  unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(bare.exit_status, 0) << bare.err;
}

TEST_F(CompileProgram, ReportsALeakAndWritesItsPath) {
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  const std::string world = entity_text("worldspawn", "", walls.substr(walls.find("}\n") + 2));
  folder_.write("leak.map", world + point_text("info_player_start", {0, 0, 32}));
  const ProgramRun run = run_program(folder_.path(), {"compile", "leak.map"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.err,
              HasSubstr(fmt::format(
                  "entity 1 (info_player_start) at 0 0 32, line {} of the map, can reach the outside at -",
                  1 + std::count(world.begin(), world.end(), '\n'))));
  EXPECT_THAT(run.err, HasSubstr("leak.pts"));
  const std::string path = read_text(folder_.path() / "leak.pts");
  EXPECT_THAT(path, HasSubstr("0.00 0.00 32.00\n"));
  const auto points = formats::read_pts(path);
  ASSERT_TRUE(points.ok()) << points.error().message();
  EXPECT_EQ(points->front(), math::Vec3(0, 0, 32)) << "`pointfile` draws from here";
  EXPECT_LT(points->back().x, -128) << "to the void";
  EXPECT_THAT(run.err, HasSubstr("leak.leak.png"));
  const Png picture = read_png(folder_.path() / "leak.leak.png");
  const auto has_pixel = [&](int red, int green, int blue) {
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
      if (picture.rgb[i] == red && picture.rgb[i + 1] == green && picture.rgb[i + 2] == blue) return true;
    return false;
  };
  EXPECT_TRUE(has_pixel(64, 230, 89)) << "the start of the path";
  EXPECT_TRUE(has_pixel(255, 51, 51)) << "the end of the path";
  // Removed when the leak is fixed.
  folder_.write("leak.map", lit_room());
  EXPECT_EQ(run_program(folder_.path(), {"compile", "leak.map"}).exit_status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "leak.pts"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "leak.leak.png"));
}

TEST_F(CompileProgram, ReusesWhatDidNotChange) {
  folder_.write("room.map", lit_room());
  const Words compile{"compile", "room.map"};
  ASSERT_EQ(run_program(folder_.path(), compile).exit_status, 0);
  const std::string level = read_text(folder_.path() / "room.bsp"),
                    lit = read_text(folder_.path() / "room.lit");
  const ProgramRun again = run_program(folder_.path(), compile);
  EXPECT_THAT(again.out, ContainsRegex("bsp +unchanged"));
  EXPECT_THAT(again.out, ContainsRegex("visibility +unchanged"));
  EXPECT_THAT(again.out, ContainsRegex("light +unchanged"));
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), level);
  EXPECT_EQ(read_text(folder_.path() / "room.lit"), lit);
  // A level that another program wrote and a damaged build file are not reused.
  folder_.write("room.lit", std::string(lit.size(), 'x'));
  EXPECT_THAT(run_program(folder_.path(), compile).out, Not(HasSubstr("unchanged")));
  folder_.write("room.build", "no build file");
  const ProgramRun damaged = run_program(folder_.path(), compile);
  EXPECT_THAT(damaged.err, HasSubstr("room.build"));
  EXPECT_THAT(damaged.out, Not(HasSubstr("unchanged")));
  EXPECT_EQ(read_text(folder_.path() / "room.lit"), lit);
  EXPECT_THAT(run_program(folder_.path(), {"compile", "room.map", "--clean"}).out,
              Not(HasSubstr("unchanged")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.build"));
}

TEST_F(CompileProgram, OnlyOneStage) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "whole.bsp"}).exit_status, 0);
  for (const char* stage : {"bsp", "vis", "light"}) {
    const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--only", stage});
    ASSERT_EQ(run.exit_status, 0) << run.err;
    const formats::Bsp bsp = read_level("room.bsp");
    EXPECT_EQ(bsp.visibility.empty(), std::string(stage) == "bsp");
    EXPECT_EQ(bsp.lighting.empty(), std::string(stage) != "light");
  }
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "whole.bsp"));
}

TEST_F(CompileProgram, LevelWithoutItsMapGetsVisibilityAndLight) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--clean"}).exit_status, 0);
  const formats::Bsp whole = read_level("room.bsp");
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--clean", "--only", "bsp", "-o", "bare.bsp"})
                .exit_status,
            0);
  const ProgramRun run = run_program(folder_.path(), {"compile", "bare.bsp", "-o", "again.bsp"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const formats::Bsp again = read_level("again.bsp");
  EXPECT_EQ(again.lighting, whole.lighting);
  EXPECT_EQ(again.visibility, whole.visibility);
  EXPECT_EQ(read_text(folder_.path() / "again.lit"), read_text(folder_.path() / "room.lit"));
}

TEST_F(CompileProgram, ErrorsAreOneLine) {
  folder_.write("broken.map", "{\n\"classname\" \"worldspawn\"\n{\n( 0 0 x )\n");
  folder_.write("empty.map", "");
  folder_.write("broken.bsp", "no level");
  folder_.write("room.map", lit_room());
  struct Case {
    Words words;
    int status;
    std::vector<std::string> parts;
  };
  const std::vector<Case> cases = {
      {{"compile"}, 2, {"map"}},
      {{"compile", "--textures", "."}, 2, {"map", ".wad"}},
      {{"compile", "--textures", ".", "-o", "art.wad"}, 1, {"--textures", ".png"}},
      {{"compile", "none.map"}, 1, {"none.map"}},
      {{"compile", "broken.map"}, 1, {"broken.map", "line 4"}},
      {{"compile", "empty.map"}, 1, {"empty.map", "worldspawn"}},
      {{"compile", "room.map", "--wad", "none.wad"}, 1, {"none.wad", "--wad"}},
      {{"compile", "room.map", "--extra", "3"}, 2, {"--extra"}},
      {{"compile", "room.map", "-o", "nowhere/room.bsp"}, 1, {"nowhere/room.bsp", "-o"}},
      {{"compile", "room.map", "--only", "qbsp"}, 2, {"qbsp", "bsp, vis, and light"}},
      {{"compile", "room.map", "--only", "vis", "--no-light"}, 2, {"--only", "--no-light"}},
      {{"compile", "room.map", "--shard", "1/2"}, 2, {"--only"}},
      {{"compile", "room.map", "--only", "bsp", "--merge"}, 2, {"--merge"}},
      {{"compile", "room.map", "--only", "vis", "--shard", "0/2"}, 2, {"0/2"}},
      {{"compile", "room.map", "--only", "vis", "--shard", "3/2"}, 2, {"3/2"}},
      {{"compile", "room.map", "--only", "light", "--merge"}, 1, {"room.light", "--shard"}},
      {{"compile", "none.bsp"}, 1, {"none.bsp"}},
      {{"compile", "broken.bsp"}, 1, {"broken.bsp"}},
      {{"compile", "none.bsp", "--watch"}, 2, {"--watch"}},
      {{"compile", "none.bsp", "--bsp2"}, 2, {"--bsp2", ".map"}},
      {{"compile", "none.bsp", "--brushlist"}, 2, {"--brushlist", ".map"}},
      {{"compile", "room.map", "--bsp2", "--2psb"}, 2, {"--bsp2", "--2psb"}},
      {{"compile", "none.bsp", "--no-vis"}, 2, {"--no-vis", ".map"}},
      {{"compile", "none.bsp", "--wad", "none.wad"}, 2, {"--wad", ".map"}},
  };
  for (const Case& c : cases) {
    const ProgramRun run = run_program(folder_.path(), c.words);
    EXPECT_EQ(run.exit_status, c.status) << run.err;
    std::string last = run.err;  // notes about textures may come before
    last.pop_back();
    last = last.substr(last.rfind('\n') + 1) + "\n";
    EXPECT_TRUE(is_one_error_line(last)) << run.err;
    for (const std::string& part : c.parts) EXPECT_THAT(last, HasSubstr(part));
  }
}

TEST_F(CompileProgram, PicturesInAFolderBecomeTextures) {
  folder_.write("room.map", lit_room());
  const formats::Palette palette = artgen::make_palette();
  std::filesystem::create_directory(folder_.path() / "art");
  const std::vector<std::uint8_t> gray(32 * 16, 5);
  const base::ByteVector png = formats::write_png(gray, 32, 16, palette).value();
  folder_.write("art/wall.png", std::string(base::as_text(png)));
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--textures", "art"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const formats::Bsp bsp = read_level("room.bsp");
  ASSERT_EQ(bsp.miptexes.size(), 1u);
  EXPECT_EQ(bsp.miptexes[0].name, "wall");
  EXPECT_EQ(bsp.miptexes[0].width, 32u);
  EXPECT_EQ(bsp.miptexes[0].mips[0], gray);
  // The same textures in a WAD, for editors.
  const ProgramRun wad = run_program(folder_.path(), {"compile", "--textures", "art", "-o", "art.wad"});
  ASSERT_EQ(wad.exit_status, 0) << wad.err;
  ASSERT_EQ(
      run_program(folder_.path(), {"compile", "room.map", "--wad", "art.wad", "-o", "b.bsp"}).exit_status, 0);
  EXPECT_EQ(read_level("b.bsp").miptexes, bsp.miptexes);
  const ProgramRun without = run_program(folder_.path(), {"compile", "room.map", "--textures", "nowhere"});
  EXPECT_EQ(without.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(without.err)) << without.err;
  EXPECT_THAT(without.err, HasSubstr("nowhere"));
}

// The order of ericw-tools, in which mappers list their WADs.
TEST_F(CompileProgram, TheLastWadWithATextureWins) {
  for (const std::uint8_t color : std::initializer_list<std::uint8_t>{5, 9, 13}) {
    const std::string name = fmt::format("art{}", color);
    std::filesystem::create_directory(folder_.path() / name);
    const std::vector<std::uint8_t> texels(32 * 16, color);
    folder_.write(
        name + "/wall.png",
        std::string(base::as_text(formats::write_png(texels, 32, 16, artgen::make_palette()).value())));
    ASSERT_EQ(run_program(folder_.path(), {"compile", "--textures", name, "-o", name + ".wad"}).exit_status,
              0);
  }
  const auto compile = [&](const char* key, std::vector<std::string> more) {
    std::string map = lit_room();
    map.insert(map.find("\"worldspawn\"\n") + 13, key);
    folder_.write("room.map", map);
    std::vector<std::string> arguments{"compile", "room.map", "--no-light"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(folder_.path(), arguments).exit_status, 0);
    return read_level("room.bsp").miptexes[0].mips[0][0];
  };
  EXPECT_EQ(compile("\"wad\" \"art5.wad;art9.wad\"\n", {}), 9);
  EXPECT_EQ(compile("\"wad\" \"art9.wad;art5.wad\"\n", {}), 5);
  EXPECT_EQ(compile("", {"--wad", "art5.wad", "--wad", "art9.wad"}), 9);
  EXPECT_EQ(compile("\"wad\" \"art9.wad;art5.wad\"\n", {"--wad", "art13.wad"}), 13);
}

// An existing level is replaced only by a complete one.
TEST_F(CompileProgram, FailureKeepsTheOldLevel) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 0);
  const std::string before = read_text(folder_.path() / "room.bsp");
  folder_.write("room.map", lit_room() + "{");
  EXPECT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 1);
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), before);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.bsp.new"));
}

}  // namespace
}  // namespace temblor::test
