// HUD programs, compiled from QuakeC: what they draw, what they read, and how they end.
#include "client/hud_program/hud_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "formats/images/image.h"
#include "render/renderer.h"
#include "support/programs/hud_source.h"
#include "support/programs/quakec.h"
#include "support/programs/temporary_folder.h"

namespace temblor::client {
namespace {

using test::kHudDeclarations;
using ::testing::HasSubstr;

constexpr int kWidth = 640, kHeight = 400, kScale = 2;

// A game folder with a program, two pictures, and a player who has 80 health.
class HudStage {
 public:
  explicit HudStage(std::string_view program, bool adds_declarations = true)
      : HudStage(test::compile_quakec(adds_declarations ? std::string(kHudDeclarations) + std::string(program)
                                                        : std::string(program))) {}
  explicit HudStage(const base::ByteVector& program) {
    folder.write("id1/csprogs.dat", program);
    // Left half red, right half clear.
    formats::Image image{4, 2, {}};
    for (int i = 0; i < 8; ++i) image.pixels.push_back(i % 4 < 2 ? 0xffff0000u : 0u);
    folder.write("id1/gfx/half.tga", formats::write_tga(image));
    // Colors that the palette lacks; the right half is half transparent.
    folder.write("id1/gfx/odd.tga", formats::write_tga({2, 1, {0xff123456u, 0x80ff80fdu}}));
    folder.write("id1/gfx/bad.png", std::string_view("no picture"));
    folder.write("id1/gfx/wide.lmp", formats::write_picture({2, 1, {3, 7}}));
    library.emplace(vfs::FileSystem::open(folder.path()).value());
    std::vector<std::string> notes;
    pictures.emplace(library->pictures(notes));
    hud.emplace(HudProgramServices{.library = *library,
                                   .pictures = *pictures,
                                   .palette = artgen::make_palette(),
                                   .variables = variables,
                                   .print = [this](std::string_view text) { printed += text; },
                                   .run_commands = [this](std::string_view lines) { commands += lines; },
                                   .run_stuffed = [this](std::string_view lines) { stuffed += lines; }});
    game.stats[0] = 80;
    game.view_entity = 1;
    game.models = {"", "maps/e1m1.bsp"};
    game.players = {{"Ranger", 3, 4, 5}, {}, {"Ogre", 9, 1, 2}};
  }

  const HudDrawing& draw(bool shows_scores = false) {
    hud->draw(game, {.time_s = 7,
                     .width = kWidth,
                     .height = kHeight,
                     .size = {.scale = kScale},
                     .shows_scores = shows_scores});
    return hud->drawing();
  }
  // Draws a frame, and returns what the program printed.
  std::string printed_in_frame() {
    printed.clear();
    draw();
    return printed;
  }
  const std::vector<render::DrawCommand>& drawn() const { return hud->draw_list().commands; }
  // The frame that its commands make on black, in true color.
  std::vector<std::uint32_t> picture(render::PixelFormat format) {
    const render::Renderer renderer(artgen::make_palette(), formats::make_colormap(artgen::make_palette()));
    render::FrameBuffer frame(kWidth, kHeight, format);
    render::FrameStats stats;
    render::DrawList list;
    list.commands.push_back({.area = {0, 0, kWidth, kHeight}, .fill = 0});
    list.commands.insert(list.commands.end(), drawn().begin(), drawn().end());
    renderer.draw_overlay(list, frame, stats);
    std::vector<std::uint32_t> pixels;
    const formats::Palette palette = artgen::make_palette();
    for (std::size_t i = 0; i < std::size_t{kWidth} * kHeight; ++i) {
      if (format == render::PixelFormat::kRgb) {
        pixels.push_back(frame.rgb()[i] & 0xffffffu);
        continue;
      }
      const formats::Rgb color = palette[frame.indexed()[i]];
      pixels.push_back(std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b);
    }
    return pixels;
  }

  test::TemporaryFolder folder;
  command::Variables variables;
  std::optional<assets::Library> library;
  std::optional<assets::Pictures> pictures;
  std::string printed, commands, stuffed;
  Game game;
  std::optional<HudProgram> hud;
};

std::uint32_t pixel(const std::vector<std::uint32_t>& picture, int x, int y) {
  return picture[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
}

bool is_red(std::uint32_t color) {
  return (color >> 16 & 255) > 100 && (color >> 8 & 255) < 60 && (color & 255) < 60;
}

// A frame whose CSQC_DrawHud is these lines.
std::string draw_hud(std::string_view lines) {
  return "void(vector size, float shows_scores) CSQC_DrawHud = {\n" + std::string(lines) + "\n};\n";
}

TEST(HudProgram, WithoutAFileNothingIsActive) {
  const test::TemporaryFolder folder;
  folder.write("id1/x.txt", std::string_view("x"));
  const assets::Library library(vfs::FileSystem::open(folder.path()).value());
  std::vector<std::string> notes;
  const assets::Pictures pictures = library.pictures(notes);
  command::Variables variables;
  std::string printed;
  HudProgram hud({.library = library,
                  .pictures = pictures,
                  .palette = artgen::make_palette(),
                  .variables = variables,
                  .print = [&](std::string_view text) { printed += text; }});
  const Game game;
  hud.draw(game, {.width = kWidth, .height = kHeight});
  EXPECT_FALSE(hud.drawing().is_active);
  EXPECT_FALSE(hud.run_command(game, "x"));
  EXPECT_EQ(printed, "");
}

TEST(HudProgram, ModernStyleDrawsInBothPixelFormats) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(test::kModernHud);
  const HudDrawing& drawing = stage.draw();
  EXPECT_TRUE(drawing.is_active && drawing.shows_view);
  EXPECT_FALSE(drawing.parts.bars || drawing.parts.scores);
  EXPECT_TRUE(drawing.parts.crosshair && drawing.parts.center_text && drawing.parts.ending);
  for (const auto format : {render::PixelFormat::kRgb, render::PixelFormat::kIndexed}) {
    const std::vector<std::uint32_t> picture = stage.picture(format);
    EXPECT_TRUE(is_red(pixel(picture, 5, kHeight - 1))) << std::hex << pixel(picture, 5, kHeight - 1);
    EXPECT_TRUE(is_red(pixel(picture, kWidth - 1, kHeight - 24 * kScale)));
    EXPECT_FALSE(is_red(pixel(picture, 5, kHeight - 24 * kScale - 1)));
    EXPECT_FALSE(is_red(pixel(picture, 8 * kScale + 1, kHeight - 16 * kScale + 1))) << "a letter";
  }
  EXPECT_EQ(pixel(stage.picture(render::PixelFormat::kRgb), 5, kHeight - 1), 0xff0000u) << "exactly";
  EXPECT_EQ(stage.drawn().size(), 3u) << "the band and two digits";
  stage.draw(true);
  EXPECT_EQ(stage.drawn().size(), 4u) << "and the scores";
}

TEST(HudProgram, OlderStyleAsksForTheView) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(test::kOlderHud);
  const HudDrawing& drawing = stage.draw();
  EXPECT_TRUE(drawing.is_active && drawing.shows_view);
  EXPECT_FALSE(drawing.parts.bars || drawing.parts.crosshair || drawing.parts.scores);
  ASSERT_EQ(stage.drawn().size(), 1u) << "the view covers the first rectangle";
  EXPECT_TRUE(is_red(pixel(stage.picture(render::PixelFormat::kRgb), 0, kHeight - 1)));
  EXPECT_TRUE(stage.hud->run_command(stage.game, "PAINT it \"black now\""));
  EXPECT_EQ(stage.printed, "painted: PAINT it \"black now\"\n");
  EXPECT_FALSE(stage.hud->run_command(stage.game, "repaint"));
  stage.draw();
  EXPECT_EQ(stage.drawn().size(), 2u);
}

TEST(HudProgram, GetsKeysAndMayConsumeThem) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(test::kOlderHud);
  stage.draw();
  const auto press = [&](platform::Key key) {
    return stage.hud->handle_event(stage.game, {0, platform::KeyChange{key, true}});
  };
  EXPECT_TRUE(press(platform::Key{'x'}));
  EXPECT_FALSE(press(platform::Key{'y'}));
  EXPECT_FALSE(press(platform::Key::kMouse1));
  EXPECT_FALSE(press(platform::Key::kF12));
  EXPECT_EQ(stage.printed, "key 120 x\nkey 121 y\nkey 512 MOUSE1\nkey 146 F12\n");
  EXPECT_FALSE(stage.hud->handle_event(stage.game, {0, platform::MouseMoved{1, 2}}));
}

TEST(HudProgram, EngineBarAndCrosshairComeBackOnRequest) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(
      "void(float w, float h, float n) CSQC_UpdateView = { clearscene(); setproperty(20, 1); "
      "setproperty(21, 1); renderscene(); };");
  const HudDrawing drawing = stage.draw();
  EXPECT_TRUE(drawing.parts.bars && drawing.parts.crosshair && drawing.parts.scores && drawing.shows_view);
  HudStage blind("void(float w, float h, float n) CSQC_UpdateView = { };");
  EXPECT_FALSE(blind.draw().shows_view) << "no renderscene: the background is black";
}

TEST(HudProgram, ReadsStatsPlayersAndRules) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    print(ftos(getstatf(0)), "|", ftos(getstatf(40)), "|", getstats(41), "|", ftos(getstatf(42, 4, 3)), "|");
    print(ftos(getstatf(15, 1)), "|", ftos(getstatf(999)), "|", getstats(-1), "\n");
    print(getplayerkeyvalue(0, "name"), "|", getplayerkeyvalue(-1, "name"), "|", getplayerkeyvalue(-2, "frags"));
    print("|", getplayerkeyvalue(1, "name"), "|", getplayerkeyvalue(99, "name"), "|", getplayerkeyvalue(-9, "x"));
    print("|", serverkey("mapname"), "|", serverkey("deathmatch"), "\n");
    print(ftos(time), "|", ftos(maxclients), "|", ftos(player_localentnum), "|");
    print(ftos(size_x), "|", ftos(size_y));
    print("|", ftos(checkextension("EXT_CSQC")), "|", ftos(checkextension("FTE_STRINGS")), "\n");
  )"));
  stage.game.game_stats[40] = 2.5f;
  stage.game.game_stats[41] = std::string("keys; \"two\"");
  stage.game.stats[42] = 0x50;
  stage.game.data.items = 2;
  EXPECT_EQ(stage.printed_in_frame(),
            "80|  2.5|keys; \"two\"|5|1|0|\n"
            "Ranger|Ogre|3||||e1m1|0\n"
            "7|3|1|320|200|1|1\n");
}

// Integers are raw words: a compiler that knows integers converts them.
TEST(HudProgram, GetstatiReturnsAnInteger) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud("local float f = getstati(32); print(sprintf(\"%i\", f));"));
  stage.game.stats[32] = 70000;
  EXPECT_EQ(stage.printed_in_frame(), "70000");
}

TEST(HudProgram, FindsPicturesOfTheGame) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    print(vtos_(drawgetimagesize("gfx/wide.lmp")), vtos_(drawgetimagesize("gfx/half")), precache_pic("gfx/half.tga", 0));
    print("|", precache_pic("gfx/none", 0), "|", ftos(iscachedpic("gfx/bad.png")), ftos(iscachedpic("GFX/WIDE")), "|");
    print(ftos(drawpic('0 0 0', "gfx/none", '8 8 0', '1 1 1', 1, 0)), ftos(stringwidth("^1ab^^", 1, '4 4 0')));
    drawpic('10 10 0', "gfx/half", '8 4 0', '1 1 1', 1, 0);
    drawsubpic('50 10 0', '8 4 0', "gfx/half.tga", '0.5 0 0', '0.5 1 0', '1 1 1', 1, 0);
    drawpic('90 10 0', "gfx/half", '8 4 0', '0 0 0', 1, 0);
  )")
                     .insert(0, "string(vector v) vtos_ = #27;\n"));
  EXPECT_EQ(stage.printed_in_frame(), "'  2.0   1.0   0.0''  4.0   2.0   0.0'gfx/half.tga||01|012");
  const std::vector<std::uint32_t> picture = stage.picture(render::PixelFormat::kRgb);
  EXPECT_TRUE(is_red(pixel(picture, 10 * kScale, 10 * kScale)));
  EXPECT_TRUE(is_red(pixel(picture, 14 * kScale - 1, 14 * kScale - 1)));
  EXPECT_EQ(pixel(picture, 14 * kScale, 10 * kScale), pixel(picture, 0, 0)) << "the clear half";
  EXPECT_EQ(pixel(picture, 52 * kScale, 12 * kScale), pixel(picture, 0, 0)) << "only the clear half";
  EXPECT_EQ(pixel(picture, 90 * kScale, 10 * kScale), 0u) << "black times red";
}

TEST(HudProgram, ClipsAndDrawsLines) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    drawsetcliparea(10, 10, 20, 20);
    drawfill('0 0 0', size, '1 0 0', 1, 0);
    drawresetcliparea();
    drawline(2, '100 100 0', '150 100 0', '1 0 0', 1, 0);
    drawline(1, '200 50 0', '220 90 0', '1 0 0', 1, 0);
    drawcharacter('60 60 0', 65, '8 8 0', '1 0 0', 0.5, 0);
    drawstring('70 60 0', "^1a^xf00b ^^", '8 8 0', '1 1 1', 1, 0);
  )"));
  stage.draw();
  const std::vector<std::uint32_t> picture = stage.picture(render::PixelFormat::kRgb);
  EXPECT_TRUE(is_red(pixel(picture, 20, 20)) && is_red(pixel(picture, 59, 59)));
  EXPECT_FALSE(is_red(pixel(picture, 19, 20)) || is_red(pixel(picture, 60, 59)) ||
               is_red(pixel(picture, 59, 60)));
  EXPECT_TRUE(is_red(pixel(picture, 200, 200)) && is_red(pixel(picture, 299, 203)));
  EXPECT_FALSE(is_red(pixel(picture, 199, 200)) || is_red(pixel(picture, 299, 204)));
  EXPECT_TRUE(is_red(pixel(picture, 420, 140))) << "the middle of the slanted line";
}

TEST(HudProgram, MayTakeCenterPrints) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud("") +
                 "float(string s) CSQC_Parse_CenterPrint = { print(s, \"!\"); return s == \"mine\"; };");
  EXPECT_TRUE(stage.draw().parts.center_text);
  stage.game.center_text = "mine";
  stage.game.center_text_since_s = 3;
  EXPECT_FALSE(stage.draw().parts.center_text);
  EXPECT_FALSE(stage.draw().parts.center_text);
  stage.game.center_text = "yours";
  EXPECT_TRUE(stage.draw().parts.center_text);
  stage.game.center_text_since_s = 4;
  EXPECT_TRUE(stage.draw().parts.center_text);
  EXPECT_EQ(stage.printed, "mine!yours!yours!") << "once for each message";
}

TEST(HudProgram, MayTakePrintsAndStuffedLines) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud("") + R"(
    void(string text, float level) CSQC_Parse_Print = { print(ftos(level), text); };
    void(string line) CSQC_Parse_StuffCmd = { if (line != "bad\n") localcmd(line); };
  )");
  EXPECT_FALSE(stage.hud->take_print(stage.game, "early\n")) << "the program does not run yet";
  stage.draw();
  EXPECT_TRUE(stage.hud->take_print(stage.game, "You got it\n"));
  EXPECT_TRUE(stage.hud->take_print(stage.game,
                                    "\x01"
                                    "Ann: hi\n"));
  EXPECT_EQ(stage.printed,
            "2You got it\n3\x01"
            "Ann: hi\n");
  EXPECT_TRUE(stage.hud->take_stuffed(stage.game, "bf"));
  EXPECT_TRUE(stage.hud->take_stuffed(stage.game, "bad"));
  EXPECT_EQ(stage.stuffed, "bf\n");
  EXPECT_EQ(stage.commands, "") << "the rules for the server's lines stay";

  HudStage other(draw_hud(""));
  other.draw();
  EXPECT_FALSE(other.hud->take_print(other.game, "x") || other.hud->take_stuffed(other.game, "x"));
  HudStage broken(draw_hud("") + "void(string t, float l) CSQC_Parse_Print = { error(\"broke\"); };");
  broken.draw();
  EXPECT_FALSE(broken.hud->take_print(broken.game, "kept\n")) << "the engine prints what a program lost";
  EXPECT_THAT(broken.printed, HasSubstr("broke"));
}

TEST(HudProgram, AsksForPingsOnlyIfItShowsThem) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud("if (getstatf(0) < 50) print(getplayerkeyvalue(0, \"ping\"));"));
  stage.game.players[0].ping_ms = 48;
  EXPECT_EQ(stage.printed_in_frame(), "");
  EXPECT_FALSE(stage.hud->take_ping_request());
  stage.game.stats[0] = 20;
  EXPECT_EQ(stage.printed_in_frame(), "48");
  EXPECT_TRUE(stage.hud->take_ping_request());
  EXPECT_FALSE(stage.hud->take_ping_request());
}

// A modder compiles again and restarts the level.
TEST(HudProgram, EachLevelReadsTheFileAgain) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud("print(\"old\");"));
  EXPECT_EQ(stage.printed_in_frame(), "old");
  const auto replace = [&](std::string_view program) {
    stage.folder.write("id1/csprogs.dat",
                       test::compile_quakec(std::string(kHudDeclarations) + draw_hud(program)));
  };
  replace("print(\"new\");");
  EXPECT_EQ(stage.printed_in_frame(), "old");
  stage.hud->begin_level();
  EXPECT_EQ(stage.printed_in_frame(), "new");

  std::filesystem::remove(stage.folder.path() / "id1/csprogs.dat");
  stage.library.emplace(vfs::FileSystem::open(stage.folder.path()).value());
  stage.hud->begin_level();
  EXPECT_EQ(stage.printed_in_frame(), "");
  replace("print(\"first\");");
  stage.hud->begin_level();
  EXPECT_EQ(stage.printed_in_frame(), "first") << "a file that is newer than the list of files";
}

TEST(HudProgram, HasEntitiesAndCommandsOfItsOwn) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    local entity a, b;
    a = spawn(); b = spawn();
    a.score = 5; b.classname = strcat("x", ftos(a.score));
    remove(a);
    print(nextent(world).classname, "|");
    a = spawn();
    print(ftos(a.score), "|", ftos(nextent(world) == a));
    localcmd("echo ", "hi\n");
    remove(a); remove(b);
  )"));
  EXPECT_EQ(stage.printed_in_frame(), "x5|0|1");
  EXPECT_EQ(stage.commands, "echo hi\n");
  EXPECT_EQ(stage.printed_in_frame(), "x5|0|1") << "entities are used again";
}

// Each level starts the program again.
TEST(HudProgram, ForgetsAtTheEndOfALevel) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(
      "float frames;\nvoid(float a, string n, float v) CSQC_Init = { print(n, \" starts\\n\"); };\n"
      "void() CSQC_Shutdown = { print(ftos(getstatf(0)), \" ends\\n\"); };\n" +
      draw_hud("frames = frames + 1; print(ftos(frames), \"\\n\");"));
  stage.draw();
  stage.draw();
  stage.hud->begin_level();
  EXPECT_FALSE(stage.hud->drawing().is_active);
  stage.draw();
  EXPECT_EQ(stage.printed, "Temblor starts\n1\n2\n0 ends\nTemblor starts\n1\n");
}

struct BadProgram {
  const char* name;
  std::string source;
  const char* problem;
};
void PrintTo(const BadProgram& program, std::ostream* out) {
  *out << program.name;
}

class BadHudPrograms : public ::testing::TestWithParam<BadProgram> {};

TEST_P(BadHudPrograms, FailOnceAndTheBuiltInHudReturns) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(GetParam().source);
  EXPECT_FALSE(stage.draw().is_active);
  EXPECT_THAT(stage.printed, HasSubstr(GetParam().problem));
  EXPECT_THAT(stage.printed, HasSubstr("csprogs.dat: "));
  const std::string once = stage.printed;
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(stage.draw().is_active);
  stage.hud->begin_level();
  EXPECT_FALSE(stage.draw().is_active);
  EXPECT_EQ(stage.printed, once) << "no error is printed twice";
  EXPECT_TRUE(stage.hud->draw_list().commands.empty());
}

INSTANTIATE_TEST_SUITE_P(
    HudProgram, BadHudPrograms,
    ::testing::Values(
        BadProgram{"loop", draw_hud("while (1) time = time + 1;"), "instructions"},
        BadProgram{"loop_at_start",
                   draw_hud("") + "void(float a, string n, float v) CSQC_Init = { while (1) a = a + 1; };",
                   "instructions"},
        BadProgram{"pictures",
                   draw_hud("local float i; for (i = 0; i < 1000000; i = i + 1) "
                            "drawfill('0 0 0', '1 1 0', '1 1 1', 1, 0);"),
                   "more than 32768 pictures"},
        BadProgram{"area",
                   draw_hud("local float i; for (i = 0; i < 1000; i = i + 1) "
                            "drawfill('0 0 0', size, '1 1 1', 1, 0);"),
                   "over the whole frame"},
        BadProgram{
            "letters",
            draw_hud("local string s; local float i; s = \"0123456789abcdef\"; "
                     "for (i = 0; i < 14; i = i + 1) s = strcat(s, s); "
                     "drawstring('0 0 0', s, '0.6 0.6 0', '1 1 1', 1, 0);"
                     "for (i = 0; i < 50000; i = i + 1) drawcharacter('9 9 0', 65, '1 1 0', '1 1 1', 1, 0);"),
            "more than 32768 pictures"},
        BadProgram{
            "long_text",
            draw_hud("local string s; local float i; s = \"0123456789abcdef\"; "
                     "for (i = 0; i < 15; i = i + 1) s = strcat(s, s); "
                     "for (i = 0; i < 10000; i = i + 1) drawstring('9999 0 0', s, '8 8 0', '1 1 1', 1, 0);"),
            "instructions"},
        BadProgram{"long_lines",
                   draw_hud("local float i; for (i = 0; i < 100000; i = i + 1) "
                            "drawline(1, '9999 0 0', '19999 9999 0', '1 1 1', 1, 0);"),
                   "instructions"},
        BadProgram{"memory",
                   draw_hud("local string s; s = \"0123456789abcdef\"; while (1) s = strcat(s, s);"),
                   "strcat"},
        BadProgram{"entities", draw_hud("while (1) spawn();"), "spawn"},
        BadProgram{"recursion", "void() again = { again(); };\n" + draw_hud("again();"), "again"},
        BadProgram{"missing",
                   "void(float a) nothing_knows = #0;\nvoid(float a) number_none = #690;\n" +
                       draw_hud("number_none(1);"),
                   "690"},
        BadProgram{"missing_name", "void(float a) nothing_knows = #0;\n" + draw_hud("nothing_knows(1);"),
                   "nothing_knows"},
        BadProgram{"null_function", "void() nobody;\n" + draw_hud("nobody();"), "CSQC_DrawHud"},
        BadProgram{"bad_string",
                   "float(vector place, float name, vector size, vector rgb, float alpha, float flag) "
                   "drawpic_f = #322;\n" +
                       draw_hud("drawpic_f('0 0 0', 3000000000, '8 8 0', '1 1 1', 1, 0);"),
                   "not a string"},
        BadProgram{
            "outside",
            "void(float a, string n, float v) CSQC_Init = { drawfill('0 0 0', '1 1 0', '1 1 1', 1, 0); };\n" +
                draw_hud(""),
            "outside of a frame"},
        BadProgram{"error", draw_hud("error(\"it \", \"broke\");"), "it broke"},
        BadProgram{"commands",
                   draw_hud("local string s; local float i; s = \"0123456789abcdef\"; "
                            "for (i = 0; i < 12; i = i + 1) s = strcat(s, s); localcmd(s);"),
                   "bytes of commands"}),
    [](const ::testing::TestParamInfo<BadProgram>& tested) { return std::string(tested.param.name); });

// A fill, a picture, and letters over gray. Flag 1 adds the color times the opacity.
TEST(HudProgram, AdditiveDrawingAddsInBothPixelFormats) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    drawfill('0 0 0', '100 100 0', '0.4 0.4 0.4', 1, 0);
    drawfill('0 0 0', '10 10 0', '0.4 0.4 0.8', 0.5, 1);
    drawpic('20 0 0', "gfx/half.tga", '40 20 0', '1 1 1', 1, 1);
    drawpic('70 0 0', "gfx/half.tga", '20 20 0', '1 1 1', 1, 9);
  )"));
  ASSERT_TRUE(stage.draw().is_active) << stage.printed;
  const std::uint32_t gray = 0x666666;
  const auto rgb = stage.picture(render::PixelFormat::kRgb);
  EXPECT_EQ(pixel(rgb, 10, 10), gray + 0x333366) << "half of 2/5 and 4/5";
  const std::uint32_t red = pixel(rgb, 50, 10);
  EXPECT_EQ(red, 0xff6666u) << "the file's own red is added";
  EXPECT_EQ(pixel(rgb, 110, 10), gray) << "the picture's clear half";
  EXPECT_TRUE(is_red(pixel(rgb, 150, 10))) << "other flags blend";
  const auto indexed = stage.picture(render::PixelFormat::kIndexed);
  const formats::NearestColor nearest(artgen::make_palette(), 0, 255);
  const auto unpack = [](std::uint32_t color) {
    return formats::Rgb{static_cast<std::uint8_t>(color >> 16 & 255),
                        static_cast<std::uint8_t>(color >> 8 & 255), static_cast<std::uint8_t>(color & 255)};
  };
  // The sum of two entries, in the nearest entry.
  const formats::Palette palette = artgen::make_palette();
  const formats::Rgb under = palette[nearest.find(unpack(gray))],
                     over = palette[nearest.find(unpack(0x333366))];
  const formats::Rgb sum = palette[nearest.find({static_cast<std::uint8_t>(under.r + over.r),
                                                 static_cast<std::uint8_t>(under.g + over.g),
                                                 static_cast<std::uint8_t>(under.b + over.b)})];
  EXPECT_EQ(unpack(pixel(indexed, 10, 10)), sum);
}

// Flag 2 multiplies what is there by the color, and flag 3 by twice the color.
TEST(HudProgram, ModulatingDrawingMultipliesInBothPixelFormats) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    drawfill('0 0 0', '100 100 0', '0.4 0.8 0.4', 1, 0);
    drawfill('0 0 0', '10 10 0', '0.2 0.6 1', 1, 2);
    drawfill('0 10 0', '10 10 0', '0 0 0', 0.5, 2);
    drawpic('20 0 0', "gfx/half.tga", '40 20 0', '1 1 1', 1, 2);
    drawfill('60 0 0', '10 10 0', '0.2 0.6 1', 1, 3);
    drawfill('60 10 0', '10 10 0', '0 0 0', 0.5, 3);
  )"));
  ASSERT_TRUE(stage.draw().is_active) << stage.printed;
  const std::uint32_t under = 0x66cc66;
  const auto rgb = stage.picture(render::PixelFormat::kRgb);
  EXPECT_EQ(pixel(rgb, 10, 10), 0x147a66u);
  EXPECT_EQ(pixel(rgb, 10, 30), 0x336633u) << "half of black";
  EXPECT_EQ(pixel(rgb, 130, 10), 0x29f5ccu) << "twice 0.2, 0.6, and 1";
  EXPECT_EQ(pixel(rgb, 130, 30), 0x336633u) << "half of black";
  EXPECT_EQ(pixel(rgb, 50, 10), 0x660000u) << "only red is left under red";
  EXPECT_EQ(pixel(rgb, 110, 10), under) << "the picture's clear half";
  const auto indexed = stage.picture(render::PixelFormat::kIndexed);
  // The product of two entries, in the nearest entry.
  const formats::Palette palette = artgen::make_palette();
  const formats::NearestColor nearest(palette, 0, 255);
  const formats::Rgb one = palette[nearest.find({0x66, 0xcc, 0x66})],
                     other = palette[nearest.find({255, 0, 0})];
  const auto multiply = [](int a, int b) { return static_cast<std::uint8_t>((a * b + 127) / 255); };
  const formats::Rgb product =
      palette[nearest.find({multiply(one.r, other.r), multiply(one.g, other.g), multiply(one.b, other.b)})];
  EXPECT_EQ(pixel(indexed, 50, 10),
            std::uint32_t{product.r} << 16 | std::uint32_t{product.g} << 8 | product.b);
  EXPECT_EQ(pixel(indexed, 110, 10), pixel(indexed, 150, 150));
  EXPECT_NE(pixel(indexed, 10, 10), pixel(indexed, 150, 150));
}

// In `rgb`, a file keeps colors that the palette lacks, and its half transparent pixels.
TEST(HudProgram, PictureFilesKeepTheirOwnColors) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    drawpic('0 0 0', "gfx/odd.tga", '20 20 0', '1 1 1', 1, 0);
    drawpic('20 0 0', "gfx/odd.tga", '20 20 0', '0.2 1 0.6', 1, 0);
  )"));
  ASSERT_TRUE(stage.draw().is_active) << stage.printed;
  const auto rgb = stage.picture(render::PixelFormat::kRgb);
  EXPECT_EQ(pixel(rgb, 5, 10), 0x123456u);
  EXPECT_NEAR(pixel(rgb, 30, 10) >> 16 & 255, 0x80, 1) << "half over black";
  EXPECT_EQ(pixel(rgb, 45, 10), 0x043434u) << "tinted";
  const auto indexed = stage.picture(render::PixelFormat::kIndexed);
  const formats::Palette palette = artgen::make_palette();
  const formats::Rgb nearest = palette[formats::NearestColor(palette, 0, 255).find({0x12, 0x34, 0x56})];
  EXPECT_EQ(pixel(indexed, 5, 10),
            std::uint32_t{nearest.r} << 16 | std::uint32_t{nearest.g} << 8 | nearest.b);
}

// CSQC_DrawScores is the screen after a level; without it, and in a finale, the built-in ones stay.
TEST(HudProgram, DrawsTheScreenAfterALevel) {
  SKIP_WITHOUT_QUAKEC();
  const std::string hud = draw_hud("drawfill('0 0 0', '9 9 0', '1 0 0', 1, 0);");
  HudStage bare(hud);
  bare.game.ending = Ending::kIntermission;
  EXPECT_TRUE(bare.draw().parts.ending);
  EXPECT_TRUE(bare.drawn().empty());
  HudStage stage(hud + R"(
    float intermission, intermission_time;
    void(vector size, float shows_scores) CSQC_DrawScores = {
      print(ftos(intermission), " ", ftos(intermission_time));
      drawfill('20 20 0', '9 9 0', '0 0 1', 1, 0);
      drawfill('40 20 0', '9 9 0', '0 1 0', 1, 0);
    };
  )");
  EXPECT_TRUE(stage.draw().parts.ending);
  EXPECT_EQ(stage.drawn().size(), 1u);
  stage.game.ending = Ending::kIntermission;
  stage.game.ending_since_s = 65;
  EXPECT_EQ(stage.printed_in_frame(), "1 65");
  EXPECT_FALSE(stage.hud->drawing().parts.ending);
  EXPECT_EQ(stage.drawn().size(), 2u) << "the scores, without the bar";
  stage.game.ending = Ending::kFinale;
  EXPECT_TRUE(stage.draw(true).parts.ending);
  EXPECT_TRUE(stage.drawn().empty());
}

TEST(HudProgram, EmptyTextsAndOddNumbersAreHarmless) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage(draw_hud(R"(
    local string none;
    local float odd, zero;
    odd = zero / zero;
    drawpic('0 0 0', none, '8 8 0', '1 1 1', 1, 0);
    drawstring('0 0 0', none, '8 8 0', '1 1 1', 1, 0);
    drawfill(at(odd, odd), at(odd, 1000000000), at(odd, -5) * 9, odd, odd);
    drawfill('-1000000000 -1000000000 0', '2000000000 2000000000 0', '9 9 9', 9, 0);
    drawline(odd, at(odd, 0), '10 10 0', '1 1 1', 1, 0);
    drawline(-5, '0 0 0', '-1000000000 1000000000 0', '1 1 1', 1, 0);
    drawsubpic('0 0 0', '8 8 0', "gfx/half", '-5 99 0', at(odd, -1), '1 1 1', 1, 0);
    drawsetcliparea(odd, -1000000000, odd, 2000000000);
    drawfill('0 0 0', '8 8 0', '1 1 1', 1, 0);
    drawcharacter('0 0 0', odd, '8 8 0', '1 1 1', 1, 0);
  )"));
  EXPECT_TRUE(stage.draw().is_active) << stage.printed;
  stage.picture(render::PixelFormat::kRgb);
  stage.picture(render::PixelFormat::kIndexed);
}

TEST(HudProgram, DamagedFilesAreReported) {
  HudStage stage(base::ByteVector(100, std::byte{7}));
  EXPECT_FALSE(stage.draw().is_active);
  EXPECT_THAT(stage.printed, HasSubstr("csprogs.dat: "));
}

// A program for another purpose, without functions that draw, is not an error.
TEST(HudProgram, WithoutDrawingFunctionsNothingIsActive) {
  SKIP_WITHOUT_QUAKEC();
  HudStage stage("void() nothing = {};");
  EXPECT_FALSE(stage.draw().is_active);
  EXPECT_EQ(stage.printed, "");
}

}  // namespace
}  // namespace temblor::client
