#include "client/demo/demo_bar.h"

#include <gtest/gtest.h>

#include "client/console/console_screen.h"
#include "support/generated_demo.h"

namespace temblor::test {
namespace {

struct DemoBar : ::testing::Test {
  DemoBar()
      : library(vfs::FileSystem::open(game.path()).value()),
        presentation(library),
        session(client::DemoSession::open(make_recording({}).bytes, "made.dem", presentation).value()) {}

  // The texts in order, and how much of the bar is filled.
  std::string text(int width = 320, int height = 200) {
    list.clear();
    client::draw_demo_bar(session, no_pictures(), width, height, {}, list);
    std::string text;
    for (const render::DrawCommand& command : list.commands)
      if (command.picture != nullptr) text += static_cast<char>(command.part_y / 8 * 16 + command.part_x / 8);
    return text;
  }
  int filled() const { return list.commands.back().area.width; }
  int length() const { return list.commands[list.commands.size() - 2].area.width - 2; }

  const MadeGame game;
  const assets::Library library;
  client::Presentation presentation;
  client::DemoSession session;
  render::DrawList list;
};

TEST_F(DemoBar, ShowsThePositionInTheDemo) {
  EXPECT_EQ(text(), "0:00/0:17");
  EXPECT_EQ(filled(), 0);
  ASSERT_TRUE(session.seek(session.begin_s() + 8.5, {}).value());
  session.set_speed(0.25);
  EXPECT_EQ(text(), "0:08/0:170.25x");
  EXPECT_NEAR(filled(), length() / 2.0, 2);
  session.pause(true);
  EXPECT_EQ(text(), "0:08/0:17paused");
  EXPECT_FALSE(session.seek(1e9, {}).value());
  EXPECT_EQ(text(), "0:17/0:17end");
  EXPECT_EQ(filled(), length());
}

TEST_F(DemoBar, FindsTheTimeOfAPixel) {
  for (const int width : {320, 1280, 1919}) {
    text(width, 720);
    const render::ScreenRect bar = list.commands[list.commands.size() - 2].area;
    const auto time_at = [&](int x_px) { return client::find_demo_time(session, x_px, width, 720, {}); };
    EXPECT_EQ(time_at(-5), session.begin_s());
    EXPECT_EQ(time_at(width + 5), session.end_s());
    EXPECT_NEAR(time_at(bar.x + bar.width / 2), (session.begin_s() + session.end_s()) / 2, 0.1);
    ASSERT_TRUE(session.seek(time_at(bar.x + bar.width / 4), {}).value());
    text(width, 720);
    EXPECT_NEAR(filled(), bar.width / 4, bar.width / 100.0) << width;
  }
}

}  // namespace
}  // namespace temblor::test
