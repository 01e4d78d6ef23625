// Bodies in rooms of a few brushes: their final places are computed from the brushes.
#include "movement/walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compiler/drafts.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::movement {
namespace {

using math::Vec3;

constexpr float kTick_s = 1.0f / 72;
constexpr float kGap = 1.0f / 32;
constexpr float kFeet = 24;  // the origin's height above the feet

// A player's box in a level without entities.
class LevelEnvironment : public WalkEnvironment {
 public:
  explicit LevelEnvironment(const std::string& map_text)
      : level_(test::make_level_of_brushes(test::parse_map(map_text))) {}

  Contact trace(const Vec3& start, const Vec3& end) override {
    const world::Trace trace =
        world::trace_line(*level_, world::ModelIndex{0}, world::Hull::kPlayer, start, end);
    return {trace, 7, trace.fraction < 1 || trace.start_solid, true};
  }
  Contact trace_push(const Vec3& start, const Vec3& end) override { return trace(start, end); }
  base::Result<bool> touch(const Contact& contact, Body&) override {
    touched.push_back(contact.trace.plane_normal);
    return touched.size() != remove_at_touch;
  }
  base::Result<bool> moved(Body&) override { return true; }
  bool may_climb(bool was_on_ground) override { return was_on_ground; }

  std::vector<Vec3> touched;
  std::size_t remove_at_touch = 0;  // counted from 1

 private:
  std::shared_ptr<const world::Level> level_;
};

// A room of 1024 by 1024 units with its floor at 0 and additional brushes.
std::string hall(const std::string& more = {}) {
  return test::entity_text("worldspawn", "",
                           test::walls_text({-512, -512, 0}, {512, 512, 512}, "wall") + more);
}

Body standing_at(float x, float y) {
  return {{x, y, kFeet + kGap}, {0, 0, 0}, true, 0};
}

// Plays ticks of gravity and walking, at a constant horizontal velocity.
void walk_for(int ticks, const Vec3& velocity, LevelEnvironment& environment, Body& io_body) {
  for (int tick = 0; tick < ticks; ++tick) {
    io_body.velocity.x = velocity.x;
    io_body.velocity.y = velocity.y;
    io_body.velocity.z -= 800 * kTick_s;
    ASSERT_TRUE(*walk(io_body, kTick_s, {0, 0, 1}, environment));
  }
}

TEST(ClipVelocity, RemovesThePartIntoThePlane) {
  test::Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 velocity = random.in_cube(500), normal = glm::normalize(random.in_cube(1));
    EXPECT_NEAR(glm::dot(clip_velocity(velocity, normal, 1), normal), 0, 0.2);
    EXPECT_NEAR(glm::dot(clip_velocity(velocity, normal, 1.5f), normal), -0.5 * glm::dot(velocity, normal),
                0.2);
  }
  EXPECT_EQ(clip_velocity({0.09f, 100, -0.09f}, {0, 0, 1}, 1), Vec3(0, 100, 0));
}

TEST(Slide, FallsByTheFormula) {
  LevelEnvironment environment(hall());
  Body body{{0, 0, 400}, {0, 0, 0}, false, 0};
  const int ticks = 36;
  for (int tick = 0; tick < ticks; ++tick) {
    body.velocity.z -= 800 * kTick_s;
    ASSERT_TRUE(slide(body, kTick_s, environment).ok());
  }
  // A tick's gravity is applied before its motion: g t t / 2, and half a tick's worth more.
  const double time_s = ticks / 72.0;
  EXPECT_NEAR(body.origin.z, 400 - (800 * time_s * time_s / 2 + 800 * time_s / 72 / 2), 0.05);
  EXPECT_FALSE(body.on_ground);
}

TEST(Slide, StopsOnTheFloorAndStands) {
  LevelEnvironment environment(hall());
  Body body{{0, 0, 60}, {100, 0, -2000}, false, 0};
  const auto result = slide(body, kTick_s * 4, environment);
  EXPECT_TRUE(result->met_floor);
  EXPECT_FALSE(result->met_wall);
  EXPECT_TRUE(body.on_ground);
  EXPECT_EQ(body.ground, 7u);
  EXPECT_NEAR(body.origin.z, kFeet + kGap, 0.01);
  EXPECT_EQ(body.velocity, Vec3(100, 0, 0));
  EXPECT_NEAR(body.origin.x, 100 * kTick_s * 4, 0.1);
}

TEST(Slide, ContinuesAlongAWall) {
  LevelEnvironment environment(hall());
  Body body{{480, 0, 100}, {200, 100, 0}, false, 0};
  const auto result = slide(body, 0.5f, environment);
  EXPECT_TRUE(result->met_wall);
  ASSERT_TRUE(result->wall);
  EXPECT_EQ(result->wall->plane_normal, Vec3(-1, 0, 0));
  EXPECT_EQ(body.velocity, Vec3(0, 100, 0));
  EXPECT_NEAR(body.origin.x, 512 - 16 - kGap, 0.01);
  EXPECT_NEAR(body.origin.y, 50, 0.5);
}

TEST(Slide, StopsDeadInACorner) {
  LevelEnvironment environment(hall());
  Body body{{480, 480, 100}, {200, 200, 0}, false, 0};
  ASSERT_TRUE(slide(body, 0.5f, environment).ok());
  EXPECT_EQ(body.velocity, Vec3(0, 0, 0));
  EXPECT_NEAR(body.origin.x, 512 - 16 - kGap, 0.05);
  EXPECT_NEAR(body.origin.y, 512 - 16 - kGap, 0.05);
}

TEST(Slide, EndsWhereTheBodyIsRemoved) {
  LevelEnvironment environment(hall());
  environment.remove_at_touch = 1;
  Body body{{480, 0, 100}, {200, 100, 0}, false, 0};
  EXPECT_TRUE(slide(body, 0.5f, environment)->is_gone);
  EXPECT_EQ(environment.touched.size(), 1u);
}

TEST(Slide, StaysAndStopsInSolid) {
  LevelEnvironment environment(hall());
  Body body{{520, 0, 100}, {0, 100, 0}, false, 0};
  const auto result = slide(body, kTick_s, environment);
  EXPECT_TRUE(result->met_wall);
  EXPECT_FALSE(result->wall);
  EXPECT_EQ(body.velocity, Vec3(0, 0, 0));
  EXPECT_EQ(body.origin, Vec3(520, 0, 100));
}

class Steps : public ::testing::TestWithParam<int> {};
TEST_P(Steps, AreClimbedUpToEighteenUnits) {
  const int height = GetParam();
  LevelEnvironment environment(
      hall(test::box_text({100, -512, 0}, {512, 512, static_cast<double>(height)}, "wall")));
  Body body = standing_at(0, 0);
  walk_for(72, {320, 0, 0}, environment, body);
  if (height <= 18) {
    EXPECT_NEAR(body.origin.z, height + double{kFeet}, 0.2) << height;
    EXPECT_GT(body.origin.x, 250);
  } else {
    EXPECT_NEAR(body.origin.z, kFeet, 0.2) << height;
    EXPECT_NEAR(body.origin.x, 100 - 16, 0.2);
  }
}
INSTANTIATE_TEST_SUITE_P(Heights, Steps, ::testing::Values(1, 8, 16, 18, 19, 24, 40));

TEST(Walk, ClimbsAFlightOfStairs) {
  std::string steps;
  for (int i = 0; i < 8; ++i)
    steps += test::box_text({100.0 + 32 * i, -512, 0}, {512, 512, 16.0 * (i + 1)}, "wall");
  LevelEnvironment environment(hall(steps));
  Body body = standing_at(0, 0);
  walk_for(90, {320, 0, 0}, environment, body);
  EXPECT_NEAR(body.origin.z, 16 * 8 + kFeet, 0.2);
}

TEST(Walk, InTheAirDoesNotClimb) {
  LevelEnvironment environment(hall(test::box_text({100, -512, 0}, {512, 512, 60}, "wall")));
  Body body{{80, 0, 50 + kFeet}, {320, 0, 0}, false, 0};
  ASSERT_TRUE(*walk(body, kTick_s, {0, 0, 1}, environment));
  EXPECT_LT(body.origin.x, 100 - 16);
}

TEST(Walk, DownStairsFallsToEachStep) {
  LevelEnvironment environment(hall(test::box_text({-512, -512, 0}, {0, 512, 16}, "wall")));
  Body body = standing_at(-50, 0);
  body.origin.z += 16;
  walk_for(40, {320, 0, 0}, environment, body);
  EXPECT_NEAR(body.origin.z, kFeet, 0.2);
  EXPECT_TRUE(body.on_ground);
}

// A slope along x through the hall, which rises by `rise` per 100 units.
std::string slope(int rise) {
  const std::string wall = " wall 0 0 0 1 1\n";
  std::string text = "{\n";
  text += "( -100 -512 0 ) ( -100 512 0 ) ( -100 -512 16 )" + wall;
  text += "( 400 -512 0 ) ( 400 -512 16 ) ( 400 512 0 )" + wall;
  text += "( -100 -512 0 ) ( -100 -512 16 ) ( 400 -512 0 )" + wall;
  text += "( -100 512 0 ) ( 400 512 0 ) ( -100 512 16 )" + wall;
  text += "( -100 -512 -8 ) ( 400 -512 -8 ) ( -100 512 -8 )" + wall;
  text += fmt::format("( 0 -512 0 ) ( 0 512 0 ) ( 100 -512 {} )", rise) + wall;
  return text + "}\n";
}

TEST(Walk, GoesUpARampThatIsAFloor) {
  // The z of its normal is 0.8: it rises by 75 per 100 units.
  LevelEnvironment environment(hall(slope(75)));
  Body body = standing_at(-60, 0);
  walk_for(60, {200, 0, 0}, environment, body);
  EXPECT_GT(body.origin.x, 60);
  EXPECT_TRUE(body.on_ground);
  // The box stands on its front lower edge.
  EXPECT_NEAR(body.origin.z, (body.origin.x + 16) * 0.75 + kFeet, 2);
}

TEST(Walk, DoesNotStandOnASteepSlope) {
  // The z of its normal is 0.55.
  LevelEnvironment environment(hall(slope(150)));
  Body body{{60, 0, 250}, {0, 0, 0}, false, 0};
  for (int tick = 0; tick < 144; ++tick) {
    body.velocity.z -= 800 * kTick_s;
    ASSERT_TRUE(*walk(body, kTick_s, {0, 0, 1}, environment));
  }
  EXPECT_LT(body.origin.x, -10);
  EXPECT_NEAR(body.origin.z, kFeet, 0.5);
}

TEST(Walk, LookingStraightAtAWallSlowsMotionAlongIt) {
  LevelEnvironment environment(hall());
  for (const bool looks_at_it : {false, true}) {
    Body body = standing_at(512 - 16 - kGap, 0);
    body.velocity = {200, 200, -10};
    ASSERT_TRUE(*walk(body, kTick_s, looks_at_it ? Vec3(1, 0, 0) : Vec3(0, 1, 0), environment));
    // By (1 + d), d = normal . forward + 0.5; only if the climbed path counts.
    EXPECT_NEAR(body.velocity.y, looks_at_it ? 100 : 200, 1);
  }
}

TEST(Walk, NeverLeavesTheHall) {
  test::Random random(11);
  LevelEnvironment environment(hall(slope(60) + test::box_text({-300, -300, 0}, {-200, -200, 17}, "wall") +
                                    test::box_text({-280, -280, 17}, {-220, -220, 90}, "wall")));
  for (int run = 0; run < 40; ++run) {
    Body body = standing_at(static_cast<float>(random.uniform(-180, -150)), 300);
    for (int turn = 0; turn < 20; ++turn) {
      const Vec3 velocity = random.in_cube(900);
      walk_for(20, {velocity.x, velocity.y, 0}, environment, body);
      ASSERT_FALSE(environment.trace(body.origin, body.origin).trace.start_solid);
      ASSERT_LT(std::abs(body.origin.x), 512 - 15.9f);
      ASSERT_GT(body.origin.z, kFeet - 0.1f);
    }
  }
}

}  // namespace
}  // namespace temblor::movement
