// From mouse, keys and sticks to view angles and moves, compared with the stock rates and formulas.
#include "client/input/player_input.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace temblor::client {
namespace {

constexpr int kKey = 'w', kOtherKey = 'd';

TEST(ButtonState, CountsHeldTimeHoweverOftenItIsRead) {
  ButtonState asked_once, asked_often;
  asked_once.press(kKey, 1.0);
  asked_once.release(kKey, 1.25);
  EXPECT_DOUBLE_EQ(asked_once.take_held_s(2.0), 0.25);
  double sum_s = 0;
  asked_often.press(kKey, 1.0);
  for (int i = 0; i < 24; ++i) sum_s += asked_often.take_held_s(1.0 + 0.01 * i);
  asked_often.release(kKey, 1.25);
  sum_s += asked_often.take_held_s(2.0);
  EXPECT_NEAR(sum_s, 0.25, 1e-12);
}

TEST(ButtonState, APressBetweenTwoMovesIsNotLost) {
  ButtonState button;
  button.press(kKey, 1.0);
  button.release(kKey, 1.001);
  EXPECT_FALSE(button.is_down());
  EXPECT_TRUE(button.take_was_down());
  EXPECT_FALSE(button.take_was_down());
}

TEST(ButtonState, ATapOfUnknownLengthCountsHalfOfTheFrame) {
  ButtonState button;
  button.press(kKey, 1.0);
  button.release(kKey, 1.0);
  EXPECT_DOUBLE_EQ(button.take_held_s(1.5), 0.25);
  EXPECT_DOUBLE_EQ(button.take_held_s(2.0), 0);
  // A second press in the same frame holds it.
  button.press(kKey, 2.0);
  button.release(kKey, 2.0);
  button.press(kKey, 2.0);
  EXPECT_DOUBLE_EQ(button.take_held_s(2.5), 0.5);
  button.release(kKey, 2.5);
  EXPECT_DOUBLE_EQ(button.take_held_s(3.0), 0);
}

TEST(ButtonState, ATypedReleaseReleasesAllKeys) {
  ButtonState button;
  button.press(kKey, 0);
  button.press(kOtherKey, 0);
  button.release(0, 1);
  EXPECT_FALSE(button.is_down());
}

TEST(PlayerInput, MouseTurnsByTheStockRate) {
  PlayerInput input;
  input.add_mouse(100, 50);
  input.look({.time_s = 1}, {});
  // 0.022 degrees per count, times sensitivity 3.
  EXPECT_FLOAT_EQ(input.view_angles_deg().y, -6.6f);
  EXPECT_FLOAT_EQ(input.view_angles_deg().x, 3.3f);
  InputSettings inverted;
  inverted.invert_mouse = true;
  PlayerInput other;
  other.add_mouse(0, 50);
  other.look({.time_s = 1}, inverted);
  EXPECT_FLOAT_EQ(other.view_angles_deg().x, -3.3f);
}

TEST(PlayerInput, ZoomSlowsTurning) {
  PlayerInput input;
  input.add_mouse(100, 0);
  input.look({.time_s = 1, .zoom = 4}, {});
  EXPECT_FLOAT_EQ(input.view_angles_deg().y, -1.65f);
}

TEST(PlayerInput, PitchStopsAtItsLimits) {
  PlayerInput input;
  input.add_mouse(0, 1e6f);
  input.look({.time_s = 1}, {});
  EXPECT_FLOAT_EQ(input.view_angles_deg().x, 80);
  input.add_mouse(0, -1e7f);
  input.look({.time_s = 1.01}, {});
  EXPECT_FLOAT_EQ(input.view_angles_deg().x, -70);
}

// At any frame rate, a key held for half a second turns by half of cl_yawspeed.
TEST(PlayerInput, KeysTurnAlikeAtAnyFrameRate) {
  for (const int rate : {30, 72, 1000}) {
    PlayerInput input;
    input.look({.time_s = 0}, {});
    input.buttons()[Button::kTurnLeft].press(kKey, 0);
    for (int i = 1; i <= rate; ++i) {
      const double time_s = static_cast<double>(i) / rate;
      if (time_s > 0.5 && input.buttons()[Button::kTurnLeft].is_down())
        input.buttons()[Button::kTurnLeft].release(kKey, 0.5);
      input.look({.time_s = time_s}, {});
    }
    EXPECT_NEAR(input.view_angles_deg().y, 70, 0.01) << rate;
  }
}

TEST(PlayerInput, WalksAndRunsAtTheStockSpeeds) {
  InputSettings walking;
  walking.always_run = false;
  PlayerInput input;
  input.take_move(0, walking);
  input.buttons()[Button::kForward].press(kKey, 0);
  input.buttons()[Button::kMoveRight].press(kOtherKey, 0);
  const net::Move walk = input.take_move(0.01, walking);
  EXPECT_EQ(walk.forward, 200);
  EXPECT_EQ(walk.side, 350);
  const net::Move run = input.take_move(0.02, {});
  EXPECT_EQ(run.forward, 400);
  EXPECT_EQ(run.side, 700);
  // With cl_alwaysrun the run key walks.
  input.buttons()[Button::kSpeed].press('s', 0.02);
  EXPECT_EQ(input.take_move(0.03, {}).forward, 200);
}

TEST(PlayerInput, AKeyHeldForHalfOfAMoveGivesHalfTheSpeed) {
  PlayerInput input;
  input.take_move(1, {});
  input.buttons()[Button::kForward].press(kKey, 1.005);
  EXPECT_NEAR(input.take_move(1.01, {}).forward, 200, 1);
}

TEST(PlayerInput, ImpulsesAndButtonsAreSentOnce) {
  PlayerInput input;
  input.set_impulse(7);
  input.buttons()[Button::kAttack].press(kKey, 0);
  input.buttons()[Button::kAttack].release(kKey, 0.001);
  const net::Move first = input.take_move(0.01, {}), second = input.take_move(0.02, {});
  EXPECT_EQ(first.impulse, 7);
  EXPECT_EQ(first.buttons, 1);
  EXPECT_EQ(second.impulse, 0);
  EXPECT_EQ(second.buttons, 0);
}

TEST(PlayerInput, StrafeMakesTheMouseMoveSideways) {
  PlayerInput input;
  input.take_move(0, {});
  input.buttons()[Button::kStrafe].press(kKey, 0);
  input.add_mouse(100, 0);
  input.look({.time_s = 0.01}, {});
  EXPECT_EQ(input.view_angles_deg().y, 0);
  EXPECT_EQ(input.take_move(0.01, {}).side, 240);  // 100 counts * sensitivity 3 * m_side 0.8
}

TEST(PlayerInput, CenterviewLevelsTheView) {
  PlayerInput input;
  input.set_view_angles({40, 10, 0});
  input.center_view();
  for (int i = 1; i < 100; ++i) input.look({.time_s = i * 0.01}, {});
  EXPECT_EQ(input.view_angles_deg().x, 0);
  EXPECT_EQ(input.view_angles_deg().y, 10);
}

TEST(PlayerInput, SticksHaveADeadZoneAndACurve) {
  EXPECT_EQ(shape_stick({0.1f, 0.1f}, 0.2f, 1), math::Vec2(0.0f));
  EXPECT_NEAR(shape_stick({1, 0}, 0.2f, 3).x, 1, 1e-6);
  EXPECT_NEAR(shape_stick({0.6f, 0}, 0.2f, 2).x, 0.25, 1e-6);
  // A stick's corner reaches farther than its sides; that must not make the player faster.
  EXPECT_NEAR(glm::length(shape_stick({1, 1}, 0.2f, 1)), 1, 1e-6);
}

TEST(PlayerInput, StickTurnsWhileItIsPushed) {
  PlayerInput input;
  input.look({.time_s = 0}, {});
  input.set_axis(platform::PadAxis::kRightX, 1);
  for (int i = 1; i <= 50; ++i) input.look({.time_s = i * 0.01}, {});
  EXPECT_NEAR(input.view_angles_deg().y, -120, 0.1);  // half a second of 240
}

TEST(PlayerInput, AnyInputGivesNumbersThatCanBeSent) {
  test::Random random(7);
  PlayerInput input;
  for (int i = 0; i < 2000; ++i) {
    const double time_s = i * 0.003;
    const Button button{static_cast<std::uint8_t>(random.below(static_cast<std::uint32_t>(kButtons)))};
    random.below(2) == 0 ? input.buttons()[button].press(kKey, time_s)
                         : input.buttons()[button].release(kKey, time_s);
    input.add_mouse(static_cast<float>(random.below(1u << 30)) - 5e8f,
                    static_cast<float>(random.below(1u << 30)) - 5e8f);
    input.look({.time_s = time_s}, {});
    const net::Move move = input.take_move(time_s, {});
    ASSERT_TRUE(std::isfinite(move.angles_deg.x) && std::isfinite(move.angles_deg.y));
    ASSERT_LE(std::abs(move.angles_deg.y), 180);
  }
}

}  // namespace
}  // namespace temblor::client
