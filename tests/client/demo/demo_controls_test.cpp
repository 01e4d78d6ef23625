#include "client/demo/demo_controls.h"

#include <gtest/gtest.h>

#include "support/generated_demo.h"

namespace temblor::test {
namespace {

using platform::Key;

struct DemoControlsTest : ::testing::Test {
  DemoControlsTest()
      : library(vfs::FileSystem::open(game.path()).value()),
        presentation(library),
        session(client::DemoSession::open(make_recording({}).bytes, "made.dem", presentation).value()) {
    EXPECT_TRUE(advance(0));
    EXPECT_TRUE(session.seek(session.begin_s() + 8, {}).value());
  }

  bool hold(Key key, bool down) { return controls.handle({0, platform::KeyChange{key, down, false}}); }
  bool press(Key key) {
    const bool taken = hold(key, true);
    EXPECT_FALSE(hold(key, false));
    return taken;
  }
  bool press(char key) { return press(Key{static_cast<std::uint16_t>(key)}); }
  bool advance(double elapsed_s) {
    return controls.advance(elapsed_s, {}, {}, presentation, session).value();
  }
  double second() const { return session.time_s() - session.begin_s(); }

  const MadeGame game;
  const assets::Library library;
  client::Presentation presentation;
  client::DemoSession session;
  client::DemoControls controls;
};

TEST_F(DemoControlsTest, PausesAndResumes) {
  EXPECT_TRUE(press(Key::kSpace));
  advance(1);
  EXPECT_NEAR(second(), 8, 1e-9);
  advance(1);
  EXPECT_NEAR(second(), 8, 1e-9);
  press(Key::kSpace);
  advance(1);
  EXPECT_NEAR(second(), 9, 1e-9);
}

TEST_F(DemoControlsTest, Seeks) {
  press(Key::kLeftArrow);
  advance(0.1);
  EXPECT_NEAR(second(), 3, 1e-9);
  press(Key::kRightArrow);
  press(Key::kRightArrow);
  advance(0.1);
  EXPECT_NEAR(second(), 13, 1e-9);
  hold(Key::kShift, true);
  press(Key::kLeftArrow);
  advance(0.1);
  EXPECT_EQ(second(), 0);
  press(Key::kRightArrow);
  hold(Key::kShift, false);
  EXPECT_TRUE(advance(0.1)) << "the end is visible";
  EXPECT_EQ(session.time_s(), session.end_s());
  press(Key::kHome);
  advance(0.1);
  EXPECT_EQ(second(), 0);
  press(Key::kEnd);
  advance(0.1);
  EXPECT_EQ(session.time_s(), session.end_s());
}

TEST_F(DemoControlsTest, StepsByPackets) {
  press('.');
  advance(0.5);
  const double here_s = second();
  EXPECT_TRUE(session.is_paused());
  press(',');
  press(',');
  advance(0.5);
  EXPECT_NEAR(second(), here_s - 2 * made_recording::kPacket_s, 1e-6);
}

TEST_F(DemoControlsTest, ChangesSpeed) {
  for (const double expected : {2.0, 4.0, 8.0, 8.0}) {
    press(Key::kUpArrow);
    advance(0);
    EXPECT_EQ(session.speed(), expected);
  }
  press(Key::kBackspace);
  advance(0);
  EXPECT_EQ(session.speed(), 1);
  for (const double expected : {0.5, 0.25, 0.1, 0.1}) {
    press(Key::kDownArrow);
    advance(0);
    EXPECT_EQ(session.speed(), expected);
  }
}

TEST_F(DemoControlsTest, RequestsOtherDemos) {
  press(Key::kPageDown);
  press(Key::kPageDown);
  press(Key::kPageUp);
  EXPECT_EQ(controls.take_demo_steps(), 1);
  EXPECT_EQ(controls.take_demo_steps(), 0);
}

TEST_F(DemoControlsTest, FliesACamera) {
  const math::Vec3 eyes = presentation.scene().camera.origin_world;
  EXPECT_FALSE(press('w'));
  EXPECT_FALSE(controls.handle({0, platform::MouseMoved{100, 0}}));
  press(Key::kSpace);
  press('f');
  EXPECT_TRUE(controls.is_flying());
  EXPECT_TRUE(hold(Key{'w'}, true));
  EXPECT_FALSE(press(Key::kF12));
  advance(0.5);
  const math::Vec3 flown = presentation.scene().camera.origin_world;
  EXPECT_GT(glm::distance(flown, eyes), 20);
  EXPECT_LT(glm::distance(flown, eyes), 200.1f) << "up to a wall";
  EXPECT_EQ(presentation.scene().view_weapon, nullptr);
  hold(Key{'w'}, false);
  const float yaw_deg = presentation.scene().camera.angles_deg.y;
  EXPECT_TRUE(controls.handle({0, platform::MouseMoved{100, 0}}));
  advance(0.5);
  EXPECT_NEAR(presentation.scene().camera.angles_deg.y, yaw_deg - 6.6f, 0.01);
  press('f');
  advance(0.5);
  EXPECT_EQ(presentation.scene().camera.origin_world, eyes);
}

// Only a camera outside the level comes back to the player.
TEST_F(DemoControlsTest, ASeekKeepsACameraThatIsInTheLevel) {
  press(Key::kSpace);
  press('f');
  hold(Key{'w'}, true);
  advance(0.1);
  hold(Key{'w'}, false);
  advance(0);
  const math::Vec3 flown = presentation.scene().camera.origin_world;
  press(Key::kLeftArrow);
  advance(0.1);
  EXPECT_EQ(presentation.scene().camera.origin_world, flown);
  EXPECT_TRUE(controls.is_flying());
}

TEST_F(DemoControlsTest, IgnoresOtherKeysAndKnowsWhenItIsIdle) {
  EXPECT_FALSE(press(Key::kEscape) || press(Key::kF12) || press(Key::kMouse1) || press('`'));
  advance(2);
  EXPECT_NEAR(controls.idle_s(), 2, 1e-9);
  press(Key::kSpace);
  EXPECT_EQ(controls.idle_s(), 0);
  EXPECT_FALSE(controls.handle({0, platform::FocusChanged{false}}));
}

}  // namespace
}  // namespace temblor::test
