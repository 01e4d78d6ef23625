// Worlds full of entities that do everything at once: results are the same every time, nothing breaks
// whatever game code writes into them, and ticks allocate nothing once they have warmed up.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "server/game/game_random.h"
#include "server/test_world.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::server {
namespace {

using math::Vec3;
using vm::EntityIndex;

const std::string kScene =
    hall_text(test::box_text({-512, -512, 0}, {-300, 512, 16}, "wall") +
                  test::box_text({-300, 200, 0}, {512, 512, 60}, "*water"),
              door_text({100, -100, 0}, {200, 100, 32}) + door_text({-100, -400, 0}, {-60, -200, 128}));

// Two doors that move back and forth, a player who runs around, and a crowd of all move types.
class Chaos {
 public:
  explicit Chaos(std::uint64_t seed, int crowd = 120) : random_(seed) {
    touch_ = world_.calls.add([this](const FakeCalls::Call& call) { on_touch(call); });
    think_ = world_.calls.add([this](const FakeCalls::Call& call) { on_think(call); });
    turn_back_ = world_.calls.add([this](const FakeCalls::Call& call) {
      const Edict door = world_[call.self];
      door.set(field::kVelocity, -door[field::kVelocity]);
      door.set(field::kNextThink, door[field::kLocalTime] + 1.5f);
    });
    world_.calls.keeps_log = false;
    for (const int number : {1, 2}) {
      const Edict door = world_.spawn_pusher(number, number == 1 ? Vec3(0, 0, 60) : Vec3(70, 0, 0));
      door.set(field::kThink, turn_back_);
      door.set(field::kNextThink, 1.5f);
    }
    world_.player({0, 0, 40}).set(field::kTouch, touch_);
    for (int i = 0; i < crowd; ++i) fill(world_.spawn(place(), kNoBox, Solid::kNot, MoveType::kNone));
  }

  void tick() {
    const float yaw = static_cast<float>(random_.uniform(0, 360));
    move_player(world_.world, EntityIndex{1}, {.view_angles_deg = {0, yaw, 0}, .forward = 400});
    world_.tick();
    world_.world.sounds.clear();
  }
  TestWorld& world() { return world_; }
  test::Random& random() { return random_; }

 private:
  Vec3 place() { return random_.in_cube(480) * Vec3(1, 1, 0.45f) + Vec3(0, 0, 260); }

  void fill(const Edict& edict) {
    constexpr std::array kTypes = {MoveType::kNone,       MoveType::kWalk,   MoveType::kStep,
                                   MoveType::kFly,        MoveType::kToss,   MoveType::kNoClip,
                                   MoveType::kFlyMissile, MoveType::kBounce, MoveType::kFollow};
    constexpr std::array kSolids = {Solid::kNot, Solid::kTrigger, Solid::kBox, Solid::kSlideBox};
    constexpr std::array kBoxes = {kNoBox, kPlayerBox, kLargeBox};
    const math::Bounds& box = kBoxes[random_.below(kBoxes.size())];
    edict.set(field::kOrigin, place());
    edict.set(field::kMins, box.mins);
    edict.set(field::kMaxs, box.maxs);
    edict.set(field::kSize, box.maxs - box.mins);
    edict.set(field::kSolid, static_cast<float>(kSolids[random_.below(kSolids.size())]));
    edict.set(field::kMoveType, static_cast<float>(kTypes[random_.below(kTypes.size())]));
    edict.set(field::kVelocity, random_.in_cube(400));
    edict.set(field::kAngularVelocity, random_.in_cube(200));
    edict.set(field::kYawSpeed, 20);
    edict.set(field::kModelIndex, 1);
    edict.set(field::kAimEntity, EntityIndex{1});
    edict.set(field::kEnemy, EntityIndex{1});
    edict.set(field::kGoalEntity, EntityIndex{1});
    edict.set(field::kTouch, touch_);
    edict.set(field::kThink, think_);
    edict.set(field::kNextThink, static_cast<float>(world_.world.time_s + random_.uniform(0, 1)));
    CHECK(link(world_.world, edict.index(), TouchTriggers::kNo).ok());
  }

  void on_touch(const FakeCalls::Call& call) {
    const Edict self = world_[call.self];
    if (random_.chance(0.05)) {
      self.clear_flag(flag::kOnGround);
      self.set(field::kVelocity, random_.in_cube(600));
    } else if (random_.chance(0.02) && !world_.world.edicts.is_client(call.self)) {
      remove(world_.world, call.self);
    } else if (random_.chance(0.02)) {
      self.set(field::kOrigin, place());
      CHECK(link(world_.world, call.self, TouchTriggers::kNo).ok());
    }
  }
  void on_think(const FakeCalls::Call& call) {
    const Edict self = world_[call.self];
    self.set(field::kNextThink, static_cast<float>(world_.world.time_s + 0.1));
    if (self.move_type() == MoveType::kStep)
      CHECK(move_to_goal(world_.world, call.self, 8, dice_).ok());
    else if (random_.chance(0.01))
      remove(world_.world, call.self);
    else if (random_.chance(0.02) && world_.world.edicts.count() < 300)
      fill(world_[world_.world.edicts.spawn(world_.world.time_s).value()]);
  }

  TestWorld world_{kScene};
  test::Random random_;
  GameRandom dice_;
  vm::FunctionIndex touch_{}, think_{}, turn_back_{};
};

TEST(Chaos, IsTheSameEveryTime) {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    Chaos chaos(51);
    for (int tick = 0; tick < test::effort(10000, 300); ++tick) chaos.tick();
    hash = compute_hash(chaos.world().world);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  Chaos other(52);
  for (int tick = 0; tick < 100; ++tick) other.tick();
  EXPECT_NE(compute_hash(other.world().world), hashes[0]);
}

TEST(Chaos, KeepsAllNumbersFinite) {
  Chaos chaos(53);
  for (int tick = 0; tick < test::effort(2000, 200); ++tick) {
    chaos.tick();
    GameWorld& world = chaos.world().world;
    ASSERT_TRUE(world.scratch.found.empty());
    ASSERT_TRUE(world.scratch.moved.empty());
    for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
      const Vec3 origin = world.edicts[EntityIndex{i}][field::kOrigin];
      ASSERT_TRUE(std::isfinite(origin.x + origin.y + origin.z));
    }
    // The player never gets through the walls.
    const Vec3 player = world.edicts[EntityIndex{1}][field::kOrigin];
    ASSERT_LT(std::max(std::abs(player.x), std::abs(player.y)), 512);
    ASSERT_GT(player.z, 0);
  }
}

// Random words in random fields.
TEST(Chaos, SurvivesRandomWords) {
  const std::array kFloats = {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(),
                              3e38f,
                              -3e38f,
                              1e-40f,
                              -1.0f,
                              0.0f,
                              7.0f,
                              1e9f};
  for (std::uint64_t seed = 60; seed < 64; ++seed) {
    Chaos chaos(seed, 60);
    GameWorld& world = chaos.world().world;
    test::Random& random = chaos.random();
    for (int tick = 0; tick < test::effort(1000, 100); ++tick) {
      for (int k = 0; k < 4; ++k) {
        const EntityIndex index{static_cast<std::uint32_t>(random.below(world.edicts.count()))};
        const std::size_t word = random.below(kSystemFieldWords);
        // The machine checks functions; the fake has only its own.
        const bool is_function = word >= field::kTouch.word && word <= field::kBlocked.word;
        const auto value = random.chance(0.8)
                               ? std::bit_cast<std::uint32_t>(kFloats[random.below(kFloats.size())])
                               : static_cast<std::uint32_t>(random.bits());
        if (!is_function) world.edicts[index].words()[word] = value;
      }
      chaos.tick();
      const EntityIndex any{static_cast<std::uint32_t>(random.below(world.edicts.count()))};
      if (world.edicts.is_free(any)) continue;
      check_bottom(world, any);
      change_yaw(world, any);
      ASSERT_TRUE(drop_to_floor(world, any).ok());
      ASSERT_TRUE(link(world, any, TouchTriggers::kYes).ok());
    }
  }
}

TEST(Chaos, AllocatesNothingOnceWarm) {
  TestWorld world(kScene);
  world.calls.keeps_log = false;
  world.world.sounds.reserve(1000);
  GameRandom dice;
  const Edict player = world.player({0, 0, 40});
  const vm::FunctionIndex touch = world.calls.add([](const FakeCalls::Call&) {});
  const vm::FunctionIndex think = world.calls.add([&](const FakeCalls::Call& call) {
    world[call.self].set(field::kNextThink, static_cast<float>(world.world.time_s + 0.1));
    CHECK(move_to_goal(world.world, call.self, 8, dice).ok());
  });
  world.spawn_pusher(1, {0, 0, 5});
  for (int i = 0; i < 40; ++i) {
    const float along = static_cast<float>(i) * 20 - 400;
    const Edict monster = world.spawn({along, -450, 40}, kPlayerBox, Solid::kSlideBox, MoveType::kStep);
    monster.set(field::kModelIndex, 1);
    monster.set(field::kGoalEntity, player.index());
    monster.set(field::kYawSpeed, 20);
    monster.set(field::kThink, think);
    monster.set(field::kNextThink, 10.1f);
    world.spawn({along, 0, 40}, kPlayerBox, Solid::kTrigger, MoveType::kNone).set(field::kTouch, touch);
  }
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      world.command_and_tick({.forward = 400});
      world.world.sounds.clear();
    }
  };
  run(300);
  const std::size_t before = test::allocation_count();
  run(300);
  EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace temblor::server
