// A game folder with a HUD program: the picture in the window, keys, commands, and settings.
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "support/game_data.h"
#include "support/programs/hud_source.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

// Starts the program again, as it lists the files of its folders only then.
void start_game(HeadlessHost& io_game, std::string_view program, std::string_view color) {
  io_game.folder().write("id1/csprogs.dat",
                         compile_quakec(std::string(kHudDeclarations) + std::string(program)));
  io_game.restart(nullptr, {"vid_color " + std::string(color), "map small"});
  ASSERT_TRUE(io_game.run_until_playing());
  io_game.run(0.2);
}

// The number of pixels in a row that are red.
int count_red(HeadlessHost& io_game, int row) {
  const std::vector<std::uint32_t>& picture = io_game.window().shown();
  const int width = io_game.window().shown_size().width;
  int count = 0;
  for (int x = 0; x < width; ++x) {
    const std::uint32_t pixel = picture[static_cast<std::size_t>(row * width + x)];
    count += (pixel >> 16 & 255) > 100 && (pixel >> 8 & 255) < 60 && (pixel & 255) < 60 ? 1 : 0;
  }
  return count;
}

int count_printed(const HeadlessHost& game, std::string_view part) {
  int count = 0;
  for (const std::string& line : game.lines()) count += line.find(part) != std::string::npos ? 1 : 0;
  return count;
}

TEST(HudProgramInAGame, ReplacesTheStatusBarInBothStylesAndFormats) {
  SKIP_WITHOUT_QUAKEC();
  for (const std::string_view program : {kModernHud, kOlderHud})
    for (const char* const color : {"rgb", "indexed"}) {
      SCOPED_TRACE(testing::Message() << color << (program == kModernHud ? ", modern" : ", older"));
      HeadlessHost game;
      start_game(game, program, color);
      EXPECT_GT(count_red(game, 199), 250);
      EXPECT_GT(count_red(game, 177), 250);
      EXPECT_LT(count_red(game, 170), 50) << "the view";
      game.command("cl_nocsqc 1");
      game.run(0.1);
      EXPECT_LT(count_red(game, 199), 50);
      game.command("cl_nocsqc 0");
      game.run(0.1);
      EXPECT_GT(count_red(game, 199), 250);
    }
}

TEST(HudProgramInAGame, GetsKeysAndCommands) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  start_game(game, kOlderHud, "rgb");
  game.command("bind x \"echo bound x\"; bind y \"echo bound y\"; paint 1 2");
  game.run(0.1);
  EXPECT_EQ(count_printed(game, "painted: paint 1 2"), 1);
  // Before the program is loaded.
  game.restart(nullptr, {"map small", "paint 3", "daub"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.1);
  EXPECT_EQ(count_printed(game, "painted: paint 3"), 1);
  EXPECT_EQ(count_printed(game, "unknown command or variable \"daub\""), 1);
  game.command("bind x \"echo bound x\"; bind y \"echo bound y\"");
  game.run(0.1);
  for (const char key : {'x', 'y'}) {
    game.press(platform::Key{static_cast<std::uint16_t>(key)});
    game.run(0.1);
    game.release(platform::Key{static_cast<std::uint16_t>(key)});
    game.run(0.1);
  }
  EXPECT_EQ(count_printed(game, "key 120 x"), 1);
  EXPECT_EQ(count_printed(game, "bound x"), 0) << "the program consumed it";
  EXPECT_EQ(count_printed(game, "key 121 y"), 1);
  EXPECT_EQ(count_printed(game, "bound y"), 1);
}

TEST(HudProgramInAGame, ThatFailsIsReportedOnce) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  start_game(game, "void(vector size, float scores) CSQC_DrawHud = { while (1) time = time + 1; };", "rgb");
  game.run(0.5);
  game.command("map small");
  game.run(0.5);
  EXPECT_EQ(count_printed(game, "id1/csprogs.dat: "), 1);
  EXPECT_TRUE(game.session().is_playing());
}

TEST(HudProgramInAGame, OfTheModdingPageWorks) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  const base::ByteVector program =
      read_file(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "docs/examples/hud.qc");
  game.folder().write("id1/csprogs.dat", compile_quakec(std::string(base::as_text(program))));
  game.restart(nullptr, {"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.2);
  EXPECT_EQ(count_printed(game, "csprogs.dat"), 0);
  EXPECT_TRUE(game.host().game.hud_program->drawing().is_active);
  EXPECT_EQ(game.host().game.hud_program->draw_list().commands.size(), 3u)
      << "the bar and two numbers; this game has no pictures";
}

// A program of the size and the style of today's mods, at three sizes of the window.
TEST(HudProgramInAGame, OfTodaysStyleWorksAtThreeSizes) {
  SKIP_WITHOUT_QUAKEC();
  const base::ByteVector file =
      read_file(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "tests/support/programs/full_hud.qc");
  for (const platform::PixelSize size : {platform::PixelSize{320, 200}, {640, 480}, {1280, 720}}) {
    SCOPED_TRACE(size.width);
    HeadlessHost game({}, size);
    start_game(game, base::as_text(file), "rgb");
    const auto& program = *game.host().game.hud_program;
    const auto count_commands = [&] {
      game.run(0.1);
      return program.draw_list().commands.size();
    };
    const std::size_t without_menu = count_commands();
    EXPECT_GT(without_menu, 30u);
    for (const render::DrawCommand& command : program.draw_list().commands)
      EXPECT_TRUE(command.area.x >= 0 && command.area.y >= 0 && command.area.x <= size.width &&
                  command.area.y <= size.height);
    const math::Vec3 angles = game.host().input.player.view_angles_deg();
    game.command("hudmenu");
    EXPECT_GT(count_commands(), without_menu + 30);
    game.window().put(platform::MouseMoved{0, 4000});  // to the lower edge
    game.run(0.1);
    EXPECT_EQ(game.host().input.player.view_angles_deg(), angles) << "the mouse moves the cursor";
    game.window().put(platform::MouseMoved{0, -4000});
    game.run(0.1);
    game.press(platform::Key::kMouse1);
    game.run(0.1);
    game.release(platform::Key::kMouse1);
    EXPECT_GT(count_commands(), without_menu + 30) << "the menu stays open";
    EXPECT_EQ(count_printed(game, "csprogs.dat"), 0);
  }
}

// The whole way of a stat: game code, server, connection, client, and its program.
TEST(HudProgramInAGame, ShowsStatsOfTheGame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  std::string program =
      small_program("void(float number, float type, ...) clientstat = #232;\n.float courage;\n");
  program.insert(program.find("  lightstyle(1"), "clientstat(77, 2, courage);\n");
  program.insert(program.find("  self.view_ofs ="), "self.courage = 12.5;\n");
  game.folder().write("id1/progs.dat", compile_quakec(program));
  start_game(
      game,
      "void(vector size, float scores) CSQC_DrawHud = { print(\"courage \", ftos(getstatf(77)), \"\\n\"); };",
      "rgb");
  game.run(0.5);
  EXPECT_GT(count_printed(game, "courage  12.5"), 0);
}

}  // namespace
}  // namespace temblor::test
