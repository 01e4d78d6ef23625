// Traces among entities, compared with a separate trace of each entity by intervals along each axis.
#include "server/move_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "server/test_world.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::server {
namespace {

using math::Vec3;
using math::Vec3d;
using vm::EntityIndex;

constexpr math::Bounds kMoveTraceCube{{-8, -8, -8}, {8, 8, 8}};
constexpr math::Bounds kBigCube{{-32, -32, -32}, {32, 32, 32}};

EntityTrace trace(TestWorld& world, const Vec3& start, const Vec3& end, const math::Bounds& box = kNoBox,
                  MoveKind kind = MoveKind::kNormal, EntityIndex passing = EntityIndex{1}) {
  return trace_move(world.world, start, box.mins, box.maxs, end, kind, passing);
}

// The fraction of the path after which a box touches another; empty: never, or it starts inside.
std::optional<double> first_contact(const math::Bounds& box, const Vec3& start, const Vec3& end,
                                    const math::Bounds& other) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = double{other.mins[axis]} - box.maxs[axis],
                 high = double{other.maxs[axis]} - box.mins[axis];
    const double speed = double{end[axis]} - start[axis];
    if (speed == 0) {
      if (start[axis] <= low || start[axis] >= high) return std::nullopt;
      continue;
    }
    const double a = (low - start[axis]) / speed, b = (high - start[axis]) / speed;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter >= leave) return std::nullopt;
  return enter;
}

TEST(MoveTrace, StopsAtTheNearestOfManyBoxes) {
  test::Random random(41);
  int stopped = 0;
  for (int scene = 0; scene < test::effort(60, 10); ++scene) {
    TestWorld world(hall_text());
    std::vector<math::Bounds> boxes(2);  // by entity; the world and an unused player
    for (int i = 0; i < 40; ++i) {
      const Vec3 origin = random.in_cube(400) * Vec3(1, 1, 0.5f) + Vec3(0, 0, 256);
      const Vec3 half(static_cast<float>(random.uniform(4, 60)), static_cast<float>(random.uniform(4, 60)),
                      static_cast<float>(random.uniform(4, 60)));
      world.spawn(origin, {-half, half}, Solid::kBox, MoveType::kNone);
      boxes.push_back({origin - half, origin + half});
    }
    for (int i = 0; i < 60; ++i) {
      const math::Bounds mover = random.chance(0.5) ? kNoBox : kPlayerBox;
      const Vec3 start = random.in_cube(400) * Vec3(1, 1, 0.4f) + Vec3(0, 0, 256);
      const Vec3 end = random.in_cube(400) * Vec3(1, 1, 0.4f) + Vec3(0, 0, 256);
      bool starts_inside = false;
      double nearest = 1;
      std::size_t nearest_box = 0;
      for (std::size_t k = 2; k < boxes.size(); ++k) {
        const auto contact = first_contact(mover, start, end, boxes[k]);
        if (!contact) continue;
        starts_inside = starts_inside || *contact == 0;
        if (*contact < nearest) {
          nearest = *contact;
          nearest_box = k;
        }
      }
      const EntityTrace found = trace(world, start, end, mover);
      EXPECT_EQ(found.trace.start_solid, starts_inside);
      if (starts_inside) continue;
      if (nearest_box == 0) {
        EXPECT_EQ(found.entity, vm::kWorld);
        continue;
      }
      ++stopped;
      ASSERT_EQ(base::to_size(found.entity), nearest_box);
      EXPECT_TRUE(found.hit);
      // 1/32 along the axis that it met.
      const double gap = kGap / std::abs(glm::dot(found.trace.plane_normal, end - start));
      EXPECT_NEAR(found.trace.fraction, std::max(0.0, nearest - gap), 1e-5);
      const Vec3d at = Vec3d(start) + (Vec3d(end) - Vec3d(start)) * double{found.trace.fraction};
      EXPECT_LT(glm::distance(at, Vec3d(found.trace.end)), 0.01);
      const float gap_left = glm::dot(found.trace.plane_normal, found.trace.end) - found.trace.plane_distance;
      if (found.trace.fraction > 0) {
        EXPECT_NEAR(gap_left, kGap, 0.01);
      }
    }
  }
  EXPECT_GT(stopped, test::effort(300, 30));
}

TEST(MoveTrace, BoxesAreHalfOpenAndFlatOnesStopNothing) {
  const math::Bounds box{{0, 0, 0}, {10, 10, 10}};
  EXPECT_TRUE(trace_box(box, {0, 5, 5}, {5, 5, 5}).all_solid);
  EXPECT_FALSE(trace_box(box, {10, 5, 5}, {20, 5, 5}).start_solid);
  EXPECT_EQ(trace_box(box, {10, 5, 5}, {5, 5, 5}).fraction, 0);
  const world::Trace out = trace_box(box, {5, 5, 5}, {50, 5, 5});
  EXPECT_TRUE(out.start_solid);
  EXPECT_FALSE(out.all_solid);
  EXPECT_EQ(out.fraction, 1);
  const world::Trace along = trace_box(box, {-10, 10, 5}, {20, 10, 5});
  EXPECT_EQ(along.fraction, 1);
  EXPECT_EQ(trace_box({{0, 0, 0}, {0, 10, 10}}, {-5, 5, 5}, {5, 5, 5}).fraction, 1);
  EXPECT_EQ(trace_box({{9, 9, 9}, {0, 0, 0}}, {-5, 5, 5}, {5, 5, 5}).fraction, 1);
  const world::Trace from_above = trace_box(box, {5, 5, 30}, {5, 5, 0});
  EXPECT_EQ(from_above.plane_normal, Vec3(0, 0, 1));
  EXPECT_EQ(from_above.plane_distance, 10);
  EXPECT_FLOAT_EQ(from_above.end.z, 10 + kGap);
  const world::Trace from_below = trace_box(box, {5, 5, -30}, {5, 5, 5});
  EXPECT_EQ(from_below.plane_normal, Vec3(0, 0, -1));
  EXPECT_FLOAT_EQ(from_below.end.z, -kGap);
}

TEST(MoveTrace, NanStopsNothingAndCrashesNothing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  TestWorld world(hall_text());
  world.spawn({0, 0, 100}, kBigCube, Solid::kBox, MoveType::kNone);
  const float values[] = {kNan, kInfinity, -kInfinity, 3e38f, 0, 5};
  for (const float a : values)
    for (const float b : values)
      for (const float c : values) {
        const math::Bounds boxes[] = {kNoBox, kPlayerBox, {{b, a, c}, {c, b, a}}};
        for (const math::Bounds& box : boxes) {
          const EntityTrace found = trace(world, {a, b, 100}, {c, a, b}, box);
          EXPECT_FALSE(found.trace.fraction > 1 || found.trace.fraction < 0);
        }
      }
}

class WhoMeetsWhom : public ::testing::Test {
 protected:
  float fraction(const math::Bounds& box = kMoveTraceCube, MoveKind kind = MoveKind::kNormal) {
    return trace(world_, {-100, 0, 100}, {100, 0, 100}, box, kind, mover_).trace.fraction;
  }

  TestWorld world_{hall_text({}, door_text({-8, 100, 60}, {8, 200, 140}))};
  EntityIndex mover_ = world_.spawn({-100, 0, 100}, kMoveTraceCube, Solid::kBox, MoveType::kFly).index();
  EntityIndex target_ = world_.spawn({0, 0, 100}, kMoveTraceCube, Solid::kBox, MoveType::kNone).index();
};

TEST_F(WhoMeetsWhom, SolidsStopAndTriggersDoNot) {
  for (const Solid solid : {Solid::kBox, Solid::kSlideBox}) {
    world_[target_].set(field::kSolid, static_cast<float>(solid));
    ASSERT_TRUE(link(world_.world, target_, TouchTriggers::kNo).ok());
    EXPECT_NEAR(fraction(), (100 - 16) / 200.0, 0.001);
  }
  for (const Solid solid : {Solid::kNot, Solid::kTrigger}) {
    world_[target_].set(field::kSolid, static_cast<float>(solid));
    ASSERT_TRUE(link(world_.world, target_, TouchTriggers::kNo).ok());
    EXPECT_EQ(fraction(), 1);
  }
}

TEST_F(WhoMeetsWhom, OwnersAndOwnedPassEachOther) {
  world_[target_].set(field::kOwner, mover_);
  EXPECT_EQ(fraction(), 1);
  world_[target_].set(field::kOwner, vm::kWorld);
  world_[mover_].set(field::kOwner, target_);
  EXPECT_EQ(fraction(), 1);
  world_[mover_].set(field::kOwner, EntityIndex{0xffffffff});
  EXPECT_LT(fraction(), 1);
  // The world as passing entity owns every entity without an owner, as in stock Quake.
  EXPECT_EQ(trace(world_, {-80, 0, 100}, {100, 0, 100}, kNoBox, MoveKind::kNormal, vm::kWorld).trace.fraction,
            1);
}

TEST_F(WhoMeetsWhom, ThinEntitiesStopOnlyThinMovers) {
  world_[target_].set(field::kSize, {0, 16, 16});
  EXPECT_EQ(fraction(), 1);
  world_[mover_].set(field::kSize, {0, 0, 0});
  EXPECT_LT(fraction(), 1);
}

TEST_F(WhoMeetsWhom, NoMonstersMeansOnlyBrushModelsStop) {
  EXPECT_EQ(fraction(kMoveTraceCube, MoveKind::kNoMonsters), 1);
  const Edict door = world_.spawn_pusher(1);
  door.set(field::kOrigin, {0, -150, 0});
  ASSERT_TRUE(link(world_.world, door.index(), TouchTriggers::kNo).ok());
  EXPECT_NEAR(fraction(kNoBox, MoveKind::kNoMonsters), (100 - 8) / 200.0, 0.001);
}

TEST_F(WhoMeetsWhom, MissilesMeetMonstersWithABiggerBox) {
  world_[target_].set(field::kOrigin, {0, 20, 100});
  ASSERT_TRUE(link(world_.world, target_, TouchTriggers::kNo).ok());
  EXPECT_EQ(fraction(kNoBox, MoveKind::kMissile), 1);
  world_[target_].set_flag(flag::kMonster);
  EXPECT_EQ(fraction(kNoBox, MoveKind::kNormal), 1);
  EXPECT_NEAR(fraction(kNoBox, MoveKind::kMissile), (100 - 8 - 15) / 200.0, 0.001);
}

TEST_F(WhoMeetsWhom, ABrushModelIsTracedThroughTheHullOfTheSize) {
  remove(world_.world, target_);
  const Edict door = world_.spawn_pusher(1);
  for (const Vec3 place : {Vec3(0, 0, 0), Vec3(30, -20, 10)}) {
    door.set(field::kOrigin, place);
    ASSERT_TRUE(link(world_.world, door.index(), TouchTriggers::kNo).ok());
    for (const auto& [box, half] : {std::pair{kNoBox, 0}, {kPlayerBox, 16}, {kLargeBox, 32}}) {
      const Vec3 start = place + Vec3(-100, 150, 100);
      const EntityTrace found = trace(world_, start, start + Vec3(200, 0, 0), box);
      EXPECT_EQ(found.entity, door.index());
      EXPECT_NEAR(found.trace.end.x, start.x + 100 - 8 - static_cast<float>(half) - kGap, 0.001);
      EXPECT_EQ(found.trace.plane_normal, Vec3(-1, 0, 0));
    }
  }
}

TEST_F(WhoMeetsWhom, ASolidBspWithoutABrushModelIsItsBox) {
  world_[target_].set(field::kSolid, static_cast<float>(Solid::kBsp));
  for (const float model : {0.0f, 77.0f, -4.0f, std::numeric_limits<float>::quiet_NaN()}) {
    world_[target_].set(field::kModelIndex, model);
    ASSERT_TRUE(link(world_.world, target_, TouchTriggers::kNo).ok());
    EXPECT_NEAR(fraction(), (100 - 16) / 200.0, 0.001);
  }
}

TEST_F(WhoMeetsWhom, FromInsideAnEntityTheWallStillStops) {
  const EntityTrace found =
      trace(world_, {0, 0, 100}, {2000, 0, 100}, kMoveTraceCube, MoveKind::kNormal, mover_);
  EXPECT_TRUE(found.trace.start_solid);
  EXPECT_NEAR(found.trace.end.x, 512 - 16, 8.1);
  world_[mover_].set(field::kOrigin, {4, 0, 100});
  EXPECT_TRUE(is_stuck(world_.world, mover_));
  world_[mover_].set(field::kOrigin, {100, 0, 100});
  EXPECT_FALSE(is_stuck(world_.world, mover_));
  world_[mover_].set(field::kOrigin, {512, 0, 100});
  EXPECT_TRUE(is_stuck(world_.world, mover_));
}

TEST(PointContents, IncludeOnlyTheWorld) {
  TestWorld world(flooded_hall_text(100));
  world.spawn({0, 0, 200}, kBigCube, Solid::kBox, MoveType::kNone);
  EXPECT_EQ(point_contents(world.world, {0, 0, 50}), world::Contents::kWater);
  EXPECT_EQ(point_contents(world.world, {0, 0, 200}), world::Contents::kEmpty);
  EXPECT_EQ(point_contents(world.world, {0, 0, -8}), world::Contents::kSolid);
}

TEST(PointContents, CurrentsAreWater) {
  auto level = std::make_shared<world::Level>(*TestWorld(flooded_hall_text(100)).world.level);
  for (world::Leaf& leaf : level->leaves)
    if (leaf.contents == world::Contents::kWater) leaf.contents = world::Contents::kCurrent180;
  TestWorld world(level);
  EXPECT_EQ(point_contents(world.world, {0, 0, 50}), world::Contents::kWater);
}

}  // namespace
}  // namespace temblor::server
