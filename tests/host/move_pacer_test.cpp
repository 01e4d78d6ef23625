// MovePacer: the rate of moves at several frame rates, and how long a key waits.
#include "host/session/move_pacer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random.h"

namespace temblor::host {
namespace {

constexpr net::Move kStands{}, kWalks{.forward = 400};

// Moves per second over ten seconds, with frames that begin up to 1 ms late.
double measure_rate_hz(double frames_per_second) {
  test::Random random(1);
  MovePacer pacer;
  int sent = 0;
  constexpr double kSeconds = 10;
  for (int frame = 0; frame < static_cast<int>(kSeconds * frames_per_second); ++frame) {
    const double now_s = 100 + frame / frames_per_second + random.uniform(0, 0.001);
    if (!pacer.is_due(kStands, now_s)) continue;
    pacer.note_sent(kStands, now_s);
    ++sent;
  }
  return sent / kSeconds;
}

TEST(MovePacer, SendsOneMovePerFrameBut72PerSecond) {
  EXPECT_NEAR(measure_rate_hz(30), 30, 0.2);
  EXPECT_NEAR(measure_rate_hz(60), 60, 0.2);
  EXPECT_NEAR(measure_rate_hz(72), 72, 1);
  EXPECT_NEAR(measure_rate_hz(144), 72, 1);
  EXPECT_NEAR(measure_rate_hz(500), 72, 1);
}

TEST(MovePacer, AnotherActionLeavesAtOnce) {
  MovePacer pacer;
  pacer.note_sent(kStands, 100);
  EXPECT_FALSE(pacer.is_due(kStands, 100.001));
  EXPECT_FALSE(pacer.is_due({.angles_deg = {1, 2, 0}}, 100.001));
  EXPECT_TRUE(pacer.is_due(kWalks, 100.001));
  EXPECT_TRUE(pacer.is_due({.buttons = 1}, 100.001));
  EXPECT_TRUE(pacer.is_due({.impulse = 7}, 100.001));
  pacer.note_sent(kWalks, 100.001);
  EXPECT_FALSE(pacer.is_due(kWalks, 100.002));
  EXPECT_FALSE(pacer.is_due({.forward = 200}, 100.002));
  EXPECT_TRUE(pacer.is_due({.forward = -400}, 100.002));
  EXPECT_TRUE(pacer.is_due({.forward = 400, .side = 350}, 100.002));
  EXPECT_TRUE(pacer.is_due(kStands, 100.002));
  EXPECT_TRUE(pacer.is_due(kWalks, 100.015));
}

}  // namespace
}  // namespace temblor::host
