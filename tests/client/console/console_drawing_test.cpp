// Reads the console's text back from its draw commands, and draws pictures of it for people to look at.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "assets/library.h"
#include "client/console/console_canvas.h"
#include "client/console/console_screen.h"
#include "client/hud/panel.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/picture_file.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using platform::Key;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ConsoleDrawing : public ::testing::Test, protected test::ConsoleScreen {
 protected:
  void print_numbers(int count) {
    for (int i = 0; i < count; ++i) ui.print(fmt::format("line {}\n", i), view.time_s);
  }
  // The lower edge of the background.
  int bottom() {
    int bottom = 0;
    for (const render::DrawCommand& command : draw().commands)
      if (command.picture == nullptr) bottom = std::max(bottom, command.area.y + command.area.height);
    return bottom;
  }
};

TEST_F(ConsoleDrawing, DrawsNothingWhileClosed) {
  EXPECT_TRUE(draw().commands.empty());
  EXPECT_FALSE(ui.covers_frame());
}

TEST_F(ConsoleDrawing, SlidesAtItsSpeed) {
  draw();
  ui.open();
  const auto bottom_after = [&](double seconds) {
    view.time_s += seconds;
    return bottom();
  };
  EXPECT_EQ(bottom_after(0.1), 30) << "300 rows per second";
  EXPECT_EQ(bottom_after(0.2), 90);
  EXPECT_EQ(bottom_after(0.2), 100) << "half of the frame";
  ui.close();
  EXPECT_EQ(bottom_after(0.25), 25);
  EXPECT_EQ(bottom_after(-5), 25) << "time running backward counts as no time";
  EXPECT_EQ(bottom_after(1), 0);
}

TEST_F(ConsoleDrawing, CoversTheFrameWithoutAGame) {
  view.game_runs = false;
  EXPECT_EQ(bottom(), 200);
  EXPECT_TRUE(ui.covers_frame());
  view.game_runs = true;
  view.time_s += 100;
  EXPECT_EQ(bottom(), 0);
  EXPECT_FALSE(ui.covers_frame());
}

TEST_F(ConsoleDrawing, NewestLinesAreAboveTheInputLine) {
  view.version = "Temblor 1";
  print_numbers(20);
  open();
  type("god");
  view.time_s = 100.1;
  const auto shown = rows();
  EXPECT_EQ(shown.at(100 - 8), std::string(30, ' ') + "Temblor 1");
  // Above the lower edge of the background picture, 12 of its 200 rows.
  EXPECT_EQ(shown.at(100 - 12 - 10), " ]god@");
  EXPECT_EQ(shown.at(100 - 12 - 20), " line 19");
  EXPECT_EQ(shown.at(-2), " line 12") << "cut off";
  EXPECT_EQ(shown.size(), 10u);
  // Letters of 8 pixels must not touch those of the next row.
  for (auto row = shown.begin(); std::next(row) != shown.end(); ++row)
    EXPECT_GT(std::next(row)->first, row->first + 8);
}

TEST_F(ConsoleDrawing, TheCursorBlinks) {
  open();
  type("god");
  press(Key::kLeftArrow);
  view.time_s = 50.1;
  EXPECT_EQ(lines().back(), " ]go@") << "over the letter";
  view.time_s = 50.4;
  EXPECT_EQ(lines().back(), " ]god");
  int cursors = 0;
  for (int tenth = 0; tenth < 100; ++tenth) {
    view.time_s = 60 + tenth * 0.1 + 0.01;
    for (const render::DrawCommand& command : draw().commands)
      cursors += command.picture != nullptr && command.part_x == 11 * 8 && command.part_y == 0;
  }
  EXPECT_NEAR(cursors, 50, 10);
}

TEST_F(ConsoleDrawing, ScrollingShowsArrowsForNewerText) {
  print_numbers(50);
  open();
  press(Key::kWheelUp);
  auto shown = rows();
  EXPECT_EQ(shown.at(100 - 32), " ^   ^   ^   ^   ^   ^   ^   ^   ^   ^");
  EXPECT_EQ(shown.at(100 - 42), " line 46");
  ui.print("new\n", view.time_s);
  EXPECT_EQ(rows().at(100 - 42), " line 46") << "the view stays";
  press(Key::kHome);
  shown = rows();
  EXPECT_EQ(shown.begin()->second, " line 0");
  press(Key::kPageDown);
  press(Key::kEnd);
  EXPECT_EQ(rows().at(100 - 32), " new");
}

TEST_F(ConsoleDrawing, LongInputLinesScrollWithTheCursor) {
  open();
  type(std::string(50, 'a') + "xyz");
  view.time_s = 100.75;
  EXPECT_EQ(lines().back(), " ]" + std::string(33, 'a') + "xyz");
  press(Key::kHome);
  view.time_s = 100.75;
  EXPECT_EQ(lines().back(), " ]" + std::string(37, 'a'));
}

TEST_F(ConsoleDrawing, RecentLinesAppearOverTheGame) {
  view.time_s = 10;
  print_numbers(6);
  EXPECT_THAT(lines(), ElementsAre(" line 2", " line 3", " line 4", " line 5"));
  view.time_s = 12;
  ui.print("later\n", view.time_s);
  view.time_s = 12.9;
  EXPECT_THAT(lines(), ElementsAre(" line 3", " line 4", " line 5", " later"));
  view.time_s = 13.1;
  EXPECT_THAT(lines(), ElementsAre(" later"));
  ui.clear_notify();
  EXPECT_THAT(lines(), IsEmpty());
  ui.print("more\n", view.time_s);
  view.settings.notify_rows = 0;
  EXPECT_THAT(lines(), IsEmpty());
}

TEST_F(ConsoleDrawing, NotifyLinesWrap) {
  view.time_s = 10;
  ui.print("one\n" + std::string(30, 'x') + " " + std::string(30, 'y') + "\n", 10);
  EXPECT_THAT(lines(), ElementsAre(" one", " " + std::string(30, 'x'), " " + std::string(30, 'y')));
}

TEST_F(ConsoleDrawing, LinesSeenInTheConsoleAreNotShownAgain) {
  view.time_s = 10;
  open();
  ui.print("read\n", view.time_s);
  ui.close();
  view.time_s += 1;
  EXPECT_THAT(lines(), IsEmpty());
}

TEST_F(ConsoleDrawing, ChatIsBelowTheMessages) {
  view.time_s = 10.1;
  ui.print("hello\n", view.time_s);
  ui.begin_chat(false);
  type("hi");
  EXPECT_THAT(lines(), ElementsAre(" hello", " say: hi@"));
  ui.begin_chat(true);
  EXPECT_THAT(lines(), ElementsAre(" hello", " say_team: @"));
}

TEST_F(ConsoleDrawing, HighContrastIsWhiteOnBlack) {
  view.settings.high_contrast = true;
  view.time_s = 10;
  ui.print(
      "\x02"
      "bronze\n",
      view.time_s);
  ASSERT_THAT(lines(), ElementsAre(" bronze"));
  EXPECT_EQ(list.commands[0].picture, nullptr) << "the background";
  view.settings.opacity = 0.25f;
  open();
  for (const render::DrawCommand& command : draw().commands) {
    EXPECT_EQ(command.opacity, 1);
    if (command.picture == nullptr) {
      EXPECT_EQ(command.fill, 0);
      continue;
    }
    EXPECT_LT(command.part_y, 64);
    ASSERT_NE(command.translation, nullptr);
    EXPECT_EQ((*command.translation)[15], 254);
    EXPECT_EQ((*command.translation)[2], 0);
  }
}

TEST(LayoutInputLine, KeepsTheCursorVisible) {
  for (int columns = 1; columns < 12; ++columns)
    for (std::size_t length = 0; length < 30; ++length)
      for (std::size_t cursor = 0; cursor <= length; ++cursor) {
        std::string glyphs;
        for (std::size_t i = 0; i < length; ++i) glyphs += static_cast<char>('a' + i);
        const InputLineView shown = layout_input_line("]", glyphs, cursor, columns);
        ASSERT_LE(shown.glyphs.size(), static_cast<std::size_t>(columns));
        ASSERT_GE(shown.cursor_column, 0);
        ASSERT_LT(shown.cursor_column, columns);
        const auto at = static_cast<std::size_t>(shown.cursor_column);
        if (cursor < length) {
          ASSERT_LT(at, shown.glyphs.size());
          ASSERT_EQ(shown.glyphs[at], glyphs[cursor]);
        } else {
          ASSERT_EQ(at, shown.glyphs.size());
        }
      }
}

// Any size, any text; the renderer checks all draw commands.
TEST_F(ConsoleDrawing, SurvivesAnySize) {
  const render::Renderer renderer({}, {});
  std::string hostile;
  for (int c = 1; c < 256; ++c) hostile += static_cast<char>(c);
  for (int i = 0; i < 30; ++i) ui.print(hostile + std::string(300, 'x') + hostile, view.time_s);
  ui.load_history("somewhere\n");
  for (int seed = 0; seed < test::effort(150, 30); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const int width = seed == 0 ? 1 : static_cast<int>(random.log_uniform(1, 2000));
    const int height = seed == 0 ? 1 : static_cast<int>(random.log_uniform(1, 1000));
    view.settings.text_size = static_cast<float>(random.uniform(0, 5));
    view.settings.scale = static_cast<int>(random.below(6));
    view.settings.high_contrast = random.chance(0.3);
    view.settings.opacity = random.chance(0.5) ? 1 : 0.5f;
    view.settings.notify_rows = static_cast<int>(random.below(100));
    view.game_runs = random.chance(0.7);
    random.chance(0.3) ? ui.begin_chat(true) : ui.toggle();
    press(random.chance(0.5) ? Key::kPageUp : Key::kHome);
    type("some text");
    view.time_s += random.uniform(0, 1);
    render::FrameBuffer frame(width, height, render::PixelFormat::kIndexed);
    render::FrameStats stats;
    renderer.draw_overlay(draw(width, height), frame, stats);
  }
}

struct Screenshot {
  const char* name;
  int width, height;
  bool high_contrast, game_runs;
  float text_size;
};
void PrintTo(const Screenshot& shot, std::ostream* out) {
  *out << shot.name;
}

class ConsoleShots : public ::testing::TestWithParam<Screenshot> {};

TEST_P(ConsoleShots, ShowTheGamesPictures) {
  DATA_FOLDER_OR_SKIP(folder);
  const Screenshot& shot = GetParam();
  const assets::Library library(vfs::FileSystem::open(folder).value());
  std::vector<std::string> notes;
  const assets::Pictures pictures = library.pictures(notes);
  const assets::Look look = library.look().value();
  const render::Renderer renderer(look.palette, look.colormap);
  const formats::Picture* const background = pictures.find_real("gfx/conback.lmp");
  ASSERT_NE(background, nullptr);

  test::ConsoleScreen screen;
  ConsoleView view{
      .pictures = pictures, .game_runs = shot.game_runs, .version = "Temblor 0.1.0", .settings = {}};
  view.settings.high_contrast = shot.high_contrast;
  view.settings.text_size = shot.text_size;
  render::FrameBuffer frame(shot.width, shot.height, render::PixelFormat::kIndexed);
  std::fill(frame.indexed().begin(), frame.indexed().end(), std::uint8_t{20});
  const auto draw = [&] {
    screen.list.clear();
    screen.ui.draw(view, shot.width, shot.height, screen.list);
  };
  screen.ui.print(
      "\x02"
      "Temblor\x1d\x1e\x1e\x1e\x1f\n",
      0);
  for (int i = 0; i < 60; ++i)
    screen.ui.print(fmt::format("{}: a line of some length, so that it has to go on below in narrow frames, "
                                "at its spaces\n",
                                i),
                    0);
  screen.ui.print("\x01player: good game\n", 0);
  screen.ui.open();
  draw();
  screen.type("m");
  screen.press(Key::kTab);
  screen.type("_sp");
  if (shot.text_size > 1) screen.press(Key::kPageUp);
  view.time_s = 2.2;
  draw();
  render::FrameStats stats;
  renderer.draw_overlay(screen.list, frame, stats);
  const bool fills =
      std::any_of(screen.list.commands.begin(), screen.list.commands.end(), [&](const auto& command) {
        return command.picture == background && command.area.x <= 0 &&
               command.area.x + command.area.width >= shot.width;
      });
  EXPECT_EQ(fills, !shot.high_contrast);
  test::show_picture(fmt::format("console_{}", shot.name), frame, look.palette);

  std::fill(frame.indexed().begin(), frame.indexed().end(), std::uint8_t{20});
  screen.ui.close();
  view.game_runs = true;
  view.time_s = 5;
  draw();
  screen.ui.print("\x01player: good game\nYou got the nailgun\n", 5);
  screen.ui.begin_chat(false);
  screen.type("thank you");
  draw();
  renderer.draw_overlay(screen.list, frame, stats);
  test::show_picture(fmt::format("chat_{}", shot.name), frame, look.palette);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ConsoleShots,
                         ::testing::Values(Screenshot{"320x200", 320, 200, false, true, 1},
                                           Screenshot{"1280x720", 1280, 720, false, true, 1},
                                           Screenshot{"1920x1080", 1920, 1080, false, false, 1},
                                           Screenshot{"1920x1080_contrast", 1920, 1080, true, true, 1},
                                           Screenshot{"1920x1080_large", 1920, 1080, false, true, 2},
                                           Screenshot{"800x1600", 800, 1600, false, true, 1}),
                         [](const auto& shot) { return std::string(shot.param.name); });

}  // namespace
}  // namespace temblor::client
