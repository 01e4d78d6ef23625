// Measures the server's physics on a LibreQuake level, or on the generated level if TEMBLOR_DATA is not set:
// box traces among 600 monsters, and ticks of 600 monsters that hunt a player. C++ replaces their QuakeC.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "artgen/small_level.h"
#include "base/check.h"
#include "formats/levels/bsp.h"
#include "server/test_world.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::bench {
namespace {

using math::Vec3;
using server::TestWorld;
using vm::EntityIndex;

constexpr int kMonsters = 600;

std::shared_ptr<const world::Level> level_named(const std::string& name) {
  const auto folder = test::data_folder();
  formats::Bsp bsp = folder
                         ? formats::read_bsp(test::read_file(*folder / "id1/maps" / (name + ".bsp"))).value()
                         : artgen::make_small_level();
  return world::make_level(std::move(bsp), name).value();
}

// Finds a position where a player's box fits.
Vec3 free_place(const world::Level& level, test::Random& io_random) {
  const math::Bounds& bounds = level.world().bounds;
  for (;;) {
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = static_cast<float>(io_random.uniform(bounds.mins[axis], bounds.maxs[axis]));
    const bool is_inside = world::hull_contents(level, world::ModelIndex{0}, world::Hull::kPoint, place) ==
                           world::Contents::kEmpty;
    if (is_inside && world::hull_contents(level, world::ModelIndex{0}, world::Hull::kPlayer, place) ==
                         world::Contents::kEmpty)
      return place;
  }
}

// Places monsters on floors all over the level. Each moves towards a player ten times per second.
class MonsterLevel {
 public:
  explicit MonsterLevel(const std::string& name) : world_(level_named(name)) {
    world_.calls.keeps_log = false;
    const Edict player = world_.player(free_place(*world_.world.level, random_));
    const vm::FunctionIndex think = world_.calls.add([this](const server::FakeCalls::Call& call) {
      world_[call.self].set(server::field::kNextThink, static_cast<float>(world_.world.time_s + 0.1));
      CHECK(move_to_goal(world_.world, call.self, 8, dice_).ok());
    });
    int standing = 0;
    while (standing < kMonsters) {
      const Edict monster = world_.spawn(free_place(*world_.world.level, random_), server::kPlayerBox,
                                         server::Solid::kSlideBox, server::MoveType::kStep);
      const EntityIndex index = monster.index();
      if (server::is_stuck(world_.world, index) || !*drop_to_floor(world_.world, index)) {
        remove(world_.world, index);
        continue;
      }
      ++standing;
      monster.set_flag(server::flag::kMonster);
      monster.set(server::field::kModelIndex, 1);
      monster.set(server::field::kGoalEntity, player.index());
      monster.set(server::field::kEnemy, player.index());
      monster.set(server::field::kYawSpeed, 20);
      monster.set(server::field::kThink, think);
      monster.set(server::field::kNextThink,
                  static_cast<float>(world_.world.time_s + random_.uniform(0, 0.1)));
    }
    world_.functions = {};
  }
  TestWorld& world() { return world_; }
  test::Random& random() { return random_; }

 private:
  using Edict = server::Edict;
  TestWorld world_;
  test::Random random_{1};
  server::GameRandom dice_;
};

struct Way {
  Vec3 start, end;
};
std::vector<Way> random_ways(const world::Level& level, float length, test::Random& io_random) {
  std::vector<Way> ways(1 << 14);
  for (Way& way : ways) {
    way.start = free_place(level, io_random);
    way.end = way.start + glm::normalize(io_random.in_cube(1)) * length;
  }
  return ways;
}

const char* const kLevels[] = {"lq_e1m2", "lq_e0m1", "start"};

void trace_level(benchmark::State& state, const std::string& name, float length) {
  const auto level = level_named(name);
  test::Random random(2);
  const std::vector<Way> ways = random_ways(*level, length, random);
  std::size_t i = 0;
  for (auto _ : state) {
    const Way& way = ways[i++ % ways.size()];
    benchmark::DoNotOptimize(
        world::trace_line(*level, world::ModelIndex{0}, world::Hull::kPlayer, way.start, way.end));
  }
  state.SetItemsProcessed(state.iterations());
}

void trace_among_monsters(benchmark::State& state, const std::string& name, float length) {
  MonsterLevel level(name);
  server::GameWorld& world = level.world().world;
  const std::vector<Way> ways = random_ways(*world.level, length, level.random());
  std::size_t i = 0;
  for (auto _ : state) {
    const Way& way = ways[i++ % ways.size()];
    benchmark::DoNotOptimize(trace_move(world, way.start, server::kPlayerBox.mins, server::kPlayerBox.maxs,
                                        way.end, server::MoveKind::kNormal, EntityIndex{1}));
  }
  state.SetItemsProcessed(state.iterations());
}

// "core" is the share of one core that 72 ticks per second take.
void tick_monsters(benchmark::State& state, const std::string& name) {
  MonsterLevel level(name);
  for (auto _ : state) {
    level.world().tick();
    level.world().world.sounds.clear();
  }
  state.counters["core"] = benchmark::Counter(static_cast<double>(state.iterations()) / 72,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const bool kRegistered = [] {
  for (const char* name : kLevels) {
    for (const int length : {16, 128, 1000}) {
      const std::string tail = std::string("/") + name + "/" + std::to_string(length);
      const auto units = static_cast<float>(length);
      benchmark::RegisterBenchmark(("trace/level" + tail).c_str(), trace_level, name, units);
      benchmark::RegisterBenchmark(("trace/among_600" + tail).c_str(), trace_among_monsters, name, units);
    }
    benchmark::RegisterBenchmark((std::string("tick/600_monsters/") + name).c_str(), tick_monsters, name);
  }
  return true;
}();

}  // namespace
}  // namespace temblor::bench

BENCHMARK_MAIN();
