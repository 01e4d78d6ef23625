// Prediction of the player's own moves, measured on real levels.
#include "client/prediction/prediction.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/prediction/near_solids.h"
#include "client/prediction/predicted_player.h"
#include "client_server/predicted_game.h"
#include "math/angles.h"
#include "movement/player.h"
#include "net/transport/loopback.h"
#include "server/move_trace.h"
#include "server/session/move_parameters.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3;
namespace field = server::field;

// A ping of 200 ms, and one packet in twenty lost in each direction.
constexpr NetworkConditions kFarAway{.loss = 0.05, .delay_s = 0.1, .jitter_s = 0.01};
constexpr float kMaxUnits = 2;
constexpr math::Bounds kBody{movement::kPlayerMins, movement::kPlayerMaxs};

#define SKIP_WITHOUT_GAME() \
  if (!std::filesystem::exists(TEMBLOR_GAME_PROGRAM)) GTEST_SKIP() << "the game's QuakeC is not compiled"

net::Move walking(float yaw_deg, std::int16_t speed = 400) {
  return {.angles_deg = {0, std::remainder(yaw_deg, 360.0f), 0}, .forward = speed};
}

float yaw_to(const Vec3& from, const Vec3& to) {
  return std::atan2(to.y - from.y, to.x - from.x) * 180 / std::numbers::pi_v<float>;
}

float distance_xy(const Vec3& a, const Vec3& b) {
  return glm::length(math::Vec2(a) - math::Vec2(b));
}

void print_report(std::string_view what, const client::PredictionReport& report) {
  fmt::print(
      "{}: largest correction {:.3f} units ({} of more than 0.01), largest step of it in a frame {:.3f}\n",
      what, report.largest_units, report.corrections, report.largest_jump_units);
}

// --- Standing, then walking.

TEST(Prediction, WalkingStartsInTheNextFrame) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  PredictedGame game(data, "lq_e1m2", kFarAway);
  ASSERT_TRUE(game.join());
  const Vec3 shown_before = game.shown()->origin_world, before = game.player()[field::kOrigin];
  EXPECT_LT(glm::distance(shown_before, before), 0.01f) << "at rest client and server agree";
  const net::Move keys = walking(game.player()[field::kAngles].y);
  game.frame(keys);
  const float first = distance_xy(game.shown()->origin_world, shown_before);
  game.frame(keys);
  const float second = distance_xy(game.shown()->origin_world, shown_before);
  fmt::print("walking: {:.3f} units in the frame of the key, {:.3f} with the next\n", first, second);
  EXPECT_GT(first, 0.1f);
  EXPECT_GT(second, 2 * first);
  EXPECT_EQ(game.player()[field::kOrigin], before) << "the server has not received the move yet";
}

// --- The client's ticks are the same as the server's.

// Random keys, each held for a moment.
class RandomKeys {
 public:
  explicit RandomKeys(std::uint64_t seed) : random_(seed) {}
  net::Move next() {
    if (left_ == 0) {
      left_ = 5 + random_.below(60);
      keys_.forward = static_cast<std::int16_t>(random_.chance(0.8) ? 400 : -200);
      keys_.side = static_cast<std::int16_t>(random_.chance(0.3) ? random_.uniform(-350, 350) : 0);
      keys_.up = static_cast<std::int16_t>(random_.chance(0.1) ? 200 : 0);
      keys_.buttons = random_.chance(0.2) ? 2 : 0;
      yaw_deg_ = static_cast<float>(random_.uniform(-180, 180));
      turn_deg_ = static_cast<float>(random_.uniform(-3, 3));
      keys_.angles_deg.x = static_cast<float>(random_.uniform(-60, 60));
    }
    --left_;
    yaw_deg_ = std::remainder(yaw_deg_ + turn_deg_, 360.0f);
    keys_.angles_deg.y = yaw_deg_;
    return keys_;
  }

 private:
  Random random_;
  net::Move keys_;
  std::size_t left_ = 0;
  float yaw_deg_ = 0, turn_deg_ = 0;
};

// Removes everything that acts on a player who walks into it.
void disarm_triggers(server::Game& io_game) {
  server::Edicts& edicts = io_game.world().edicts;
  for (std::uint32_t i = 0; i < edicts.count(); ++i) {
    const vm::EntityIndex index{i};
    if (!edicts.is_free(index) && !edicts.is_client(index)) edicts[index].set(field::kTouch, vm::kNoFunction);
  }
}

std::vector<client::SolidModel> exact_solids(server::Game& io_game) {
  std::vector<client::SolidModel> solids;
  const server::GameWorld& world = io_game.world();
  for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
    const vm::EntityIndex index{i};
    if (world.edicts.is_free(index)) continue;
    const server::Edict edict = io_game.world().edicts[index];
    const server::ServerModel* model = world.find_model(edict);
    if (edict.solid() == server::Solid::kBsp && model != nullptr && model->brush_model)
      solids.push_back({i, *model->brush_model, edict[field::kOrigin]});
  }
  return solids;
}

struct Agreement {
  int ticks = 0, differing = 0;
  int climbed = 0, in_water = 0, in_air = 0;
};

Agreement compare_tick_by_tick(PredictedGame& io_game, std::uint64_t seed, int ticks) {
  Agreement result;
  RandomKeys keys(seed);
  io_game.frame_s = 1.0 / 72;
  disarm_triggers(io_game.game());
  net::MoveAcknowledgment before{};
  for (int tick = 0; tick < ticks; ++tick) {
    io_game.frame(keys.next());
    const std::uint32_t number = io_game.server().clients[0].moves.last_played();
    const net::MoveAcknowledgment after = server::make_acknowledgment(io_game.game(), 0, number);
    const std::vector<client::SolidModel> solids = exact_solids(io_game.game());
    if (tick > 0 && after.number == before.number + 1) {
      const client::PredictionWorld world{io_game.level(), solids,
                                          io_game.client().move_parameters()->physics};
      client::PredictedPlayer predicted = client::make_predicted_player(before);
      predicted.eyes_z = io_game.player()[field::kViewOffset].z;
      for (const client::NumberedMove& sent : io_game.client().sent_moves())
        if (sent.number == after.number)
          client::step(predicted, sent.move, io_game.client().move_parameters()->world_tick_s, world);
      const movement::Body& body = predicted.player.body;
      ++result.ticks;
      result.differing += body.origin != after.origin || body.velocity != after.velocity ||
                          body.on_ground != after.on_ground ||
                          predicted.player.water_level != after.water_level;
      const float rise = after.origin.z - before.origin.z;
      result.climbed += before.on_ground && rise > 4 && rise <= 18.1f;
      result.in_water += after.water_level >= 2;
      result.in_air += !after.on_ground;
    }
    before = after;
  }
  return result;
}

TEST(Prediction, AStepIsTheServersOwnTickForTick) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  int climbed = 0, in_water = 0;
  for (const char* map : {"lq_e0m1", "lq_e1m2", "lqdm1", "lqdm11", "start"}) {
    PredictedGame game(data, map, {});
    ASSERT_TRUE(game.join()) << map;
    const Agreement result = compare_tick_by_tick(game, 11, effort(4000, 400));
    fmt::print("{}: {} ticks, {} differ; {} steps climbed, {} ticks under water, {} in the air\n", map,
               result.ticks, result.differing, result.climbed, result.in_water, result.in_air);
    EXPECT_GT(result.ticks, effort(3800, 350)) << map;
    EXPECT_EQ(result.differing, 0) << map;
    climbed += result.climbed;
    in_water += result.in_water;
  }
  EXPECT_GT(climbed, effort(20, 0)) << "else stairs were not tested";
  EXPECT_GE(in_water, effort(100, 0)) << "else swimming was not tested";
}

// --- Stairs and lifts.

struct Lift {
  vm::EntityIndex entity{};
  Vec3 center{0.0f};           // of its upper side, where its model is drawn
  Vec3 low{0.0f}, high{0.0f};  // its origin at either end
  float speed = 0;
};

std::vector<Lift> list_lifts(PredictedGame& io_game) {
  std::vector<Lift> lifts;
  server::Game& game = io_game.game();
  const server::Edicts& edicts = game.world().edicts;
  const vm::Program& program = game.machine().program();
  // A vector field starts with its first component.
  const auto field_named = [&](const char* name) {
    return server::Field<Vec3>{server::float_field(program, fmt::format("{}_x", name)).value().word};
  };
  const auto place_open = field_named("place_open"), place_closed = field_named("place_closed");
  const server::Field<float> speed = server::float_field(program, "speed").value();
  for (std::uint32_t i = 1; i < edicts.count(); ++i) {
    const server::Edict edict = game.world().edicts[vm::EntityIndex{i}];
    if (edicts.is_free(vm::EntityIndex{i}) || game.machine().text(edict[field::kClassName]) != "func_plat")
      continue;
    const Vec3 mins = edict[field::kMins], maxs = edict[field::kMaxs];
    lifts.push_back({vm::EntityIndex{i},
                     {(mins.x + maxs.x) / 2, (mins.y + maxs.y) / 2, maxs.z},
                     edict[place_closed],
                     edict[place_open],
                     edict[speed]});
  }
  return lifts;
}

// A place at this height with a straight path to the middle of the lift.
std::optional<Vec3> place_beside(PredictedGame& io_game, const Lift& lift, const Vec3& lift_origin) {
  const auto trace = [&](const Vec3& from, const Vec3& to) {
    return server::trace_move(io_game.game().world(), from, kBody.mins, kBody.maxs, to,
                              server::MoveKind::kNormal, io_game.player().index())
        .trace;
  };
  const Vec3 middle = lift.center + lift_origin + Vec3(0, 0, 40);
  for (const float distance : {72.0f, 84.0f, 96.0f, 112.0f, 128.0f, 160.0f, 200.0f})
    for (int turn = 0; turn < 24; ++turn) {
      const float angle = static_cast<float>(turn) * std::numbers::pi_v<float> / 12;
      const Vec3 above = middle + Vec3(std::cos(angle) * distance, std::sin(angle) * distance, 0);
      const world::Trace down = trace(above, above - Vec3(0, 0, 32));
      if (down.start_solid || down.fraction == 1) continue;
      const world::Trace way = trace(above, middle);
      if (!way.start_solid && way.fraction == 1) return down.end;
    }
  return std::nullopt;
}

bool has_arrived(PredictedGame& io_game, const Lift& lift, const Vec3& where) {
  const client::InterpolatedEntity* seen =
      client::find_entity(io_game.drawn(), static_cast<std::uint32_t>(lift.entity));
  return seen != nullptr && glm::distance(seen->origin_world, where) < 0.2f;
}

// Onto the lift, up, and off it: as soon as the player sees it arrive, or walking ahead all the time.
bool ride(PredictedGame& io_game, const Lift& lift, bool pushes) {
  io_game.run(12);  // until it is down again
  const auto below = place_beside(io_game, lift, lift.low);
  const auto above = place_beside(io_game, lift, lift.high);
  if (!below || !above) return false;
  io_game.put_player(*below + Vec3(0, 0, 1));
  io_game.prediction().reset_report();
  const auto shown = [&] { return io_game.shown()->origin_world; };
  const auto walk_to = [&](const Vec3& goal, float near, double limit_s) {
    for (const double until_s = io_game.now_s() + limit_s;
         io_game.now_s() < until_s && distance_xy(shown(), goal) > near;)
      io_game.frame(walking(yaw_to(shown(), goal)));
  };
  walk_to(lift.center + lift.low, 12, 4);
  if (!pushes)
    for (const double until_s = io_game.now_s() + 12;
         io_game.now_s() < until_s && !has_arrived(io_game, lift, lift.high);)
      io_game.frame({});
  walk_to(*above, 16, 12);
  io_game.run(0.5);
  return std::abs(shown().z - above->z) < 24;
}

void ride_all(const std::filesystem::path& data, const NetworkConditions& conditions,
              std::string_view network) {
  int ridden = 0;
  for (const char* map : {"lq_e1m2", "lqdm11", "lq_e0m2"}) {
    PredictedGame game(data, map, conditions);
    ASSERT_TRUE(game.join()) << map;
    for (const Lift& lift : list_lifts(game))
      for (const bool pushes : {false, true}) {
        if (!ride(game, lift, pushes)) continue;
        ++ridden;
        const client::PredictionReport& report = game.prediction().report();
        print_report(fmt::format("{}, lift of {} units a second in {}, {}", network, lift.speed, map,
                                 pushes ? "pushing ahead" : "waiting"),
                     report);
        // The start of a lift cannot be predicted: the error is its motion until the client learns of it.
        EXPECT_LT(report.largest_units, std::max(kMaxUnits, lift.speed / 72));
        if (!pushes) {
          EXPECT_LT(report.largest_jump_units, kMaxUnits);
        }
      }
  }
  EXPECT_GE(ridden, 4);
}

TEST(Prediction, LiftsAreRiddenFarFromTheServer) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  ride_all(data, kFarAway, "200 ms");
}

TEST(Prediction, LiftsAreRiddenNearTheServer) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  ride_all(data, {}, "0 ms");
}

void walk_about(const std::filesystem::path& data, const NetworkConditions& conditions,
                std::string_view network) {
  int climbed = 0;
  for (const char* map : {"lq_e1m2", "lqdm1", "lq_e0m1"}) {
    PredictedGame game(data, map, conditions);
    ASSERT_TRUE(game.join()) << map;
    disarm_triggers(game.game());
    game.run(1);
    game.prediction().reset_report();
    RandomKeys keys(5);
    Vec3 before = game.shown()->origin_world;
    float way = 0;
    for (int frame = 0; frame < effort(60 * 60, 5 * 60); ++frame) {
      const bool was_on_ground = game.shown()->on_ground;
      game.frame(keys.next());
      const Vec3 now = game.shown()->origin_world;
      climbed += was_on_ground && now.z - before.z > 6 && now.z - before.z <= 18.1f;
      way += distance_xy(now, before);
      before = now;
    }
    print_report(fmt::format("{}, {:.0f} units of {}", network, way, map), game.prediction().report());
    EXPECT_GT(way, effort(3000, 100)) << map;
    EXPECT_LT(game.prediction().report().largest_units, kMaxUnits) << map;
    EXPECT_LT(game.prediction().report().largest_jump_units, kMaxUnits) << map;
    EXPECT_EQ(game.prediction().report().teleport_units, 0) << map;
  }
  EXPECT_GT(climbed, effort(20, 0)) << "else stairs were not tested";
}

TEST(Prediction, LevelsWithStairsAreWalkedFarFromTheServer) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  walk_about(data, kFarAway, "200 ms");
}

TEST(Prediction, LevelsWithStairsAreWalkedNearTheServer) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  walk_about(data, {}, "0 ms");
}

// The frame rates of a slow and a fast machine.
TEST(Prediction, FrameRatesDoNotMatter) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  for (const double rate : {20.0, 144.0, 500.0}) {
    PredictedGame game(data, "lqdm1", kFarAway);
    ASSERT_TRUE(game.join());
    disarm_triggers(game.game());
    game.run(1);
    game.frame_s = 1 / rate;
    game.run(0.5);
    game.prediction().reset_report();
    const std::uint64_t sent_before = game.moves_sent();
    RandomKeys keys(6);
    for (int i = 0; i < 10 * 72; ++i) game.run(1.0 / 72, keys.next());
    print_report(fmt::format("200 ms, {} frames a second", rate), game.prediction().report());
    EXPECT_LT(game.prediction().report().largest_units, kMaxUnits) << rate;
    EXPECT_NEAR(static_cast<double>(game.moves_sent() - sent_before) / 720, rate == 20 ? 3.6 : 1, 0.1);
  }
}

// A blow cannot be predicted. It shows up a round trip later, and is corrected smoothly.
TEST(Prediction, ABlowIsCorrectedSmoothly) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  PredictedGame game(data, "lqdm1", kFarAway);
  ASSERT_TRUE(game.join());
  game.prediction().reset_report();
  game.player().set(field::kVelocity, Vec3(0, 0, 300));
  Vec3 before = game.shown()->origin_world;
  float fastest = 0;
  for (int frame = 0; frame < 120; ++frame) {
    game.frame({});
    fastest = std::max(fastest, glm::distance(game.shown()->origin_world, before));
    before = game.shown()->origin_world;
  }
  print_report("200 ms, a blow of 300 units a second", game.prediction().report());
  EXPECT_GT(game.prediction().report().largest_units, 10);
  EXPECT_LT(fastest, game.prediction().report().largest_units / 2) << "no sudden jump";
  EXPECT_LT(glm::distance(game.shown()->origin_world, game.player()[field::kOrigin]), 0.05f);
}

// --- Servers that would make a client compute for seconds.

float distance_to_box(const Vec3& place, const math::Bounds& bounds) {
  float squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float outside = std::max({bounds.mins[axis] - place[axis], place[axis] - bounds.maxs[axis], 0.0f});
    squared += outside * outside;
  }
  return std::sqrt(squared);
}

TEST(Prediction, OnlyTheNearestModelsAreSolid) {
  world::Level level;
  Random random(3);
  for (int i = 0; i < 8; ++i) {
    const Vec3 size(random.uniform(1, 200), random.uniform(1, 200), random.uniform(1, 200));
    level.models.emplace_back();
    level.models.back().bounds = {-size, size};
  }
  const auto somewhere = [&] {
    return Vec3(random.uniform(-2000, 2000), random.uniform(-2000, 2000), random.uniform(-2000, 2000));
  };
  std::vector<client::SolidModel> all;
  for (std::uint32_t i = 1; i <= 3000; ++i)
    all.push_back({i, world::ModelIndex{static_cast<std::uint32_t>(random.below(8))}, somewhere()});
  all[7].origin.x = std::nanf("");
  const Vec3 place = somewhere();
  const auto distance = [&](const client::SolidModel& solid) {
    const math::Bounds& bounds = level.models[base::to_size(solid.model)].bounds;
    return distance_to_box(place, {bounds.mins + solid.origin, bounds.maxs + solid.origin});
  };
  std::vector<client::SolidModel> kept = all;
  client::keep_nearest(kept, level, place, 100);
  ASSERT_EQ(kept.size(), 100u);
  float farthest = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    farthest = std::max(farthest, distance(kept[i]));
    EXPECT_NE(kept[i].entity, 8u);
    EXPECT_TRUE(i == 0 || kept[i - 1].entity < kept[i].entity);
  }
  const auto nearer = std::count_if(all.begin(), all.end(), [&](const client::SolidModel& solid) {
    return solid.entity != 8 && distance(solid) < farthest - 0.01f;
  });
  EXPECT_LT(nearer, 100);
  client::keep_nearest(kept, level, place, 200);
  EXPECT_EQ(kept.size(), 100u);
}

// A heap of models wherever the player goes, and a high ping.
TEST(Prediction, PredictionPausesForAHeapOfModels) {
  SKIP_WITHOUT_GAME();
  DATA_FOLDER_OR_SKIP(data);
  PredictedGame game(data, "lq_e1m2", {.delay_s = 0.15});
  ASSERT_TRUE(game.join());
  game.run(0.5, walking(0));
  ASSERT_TRUE(game.shown());
  ASSERT_EQ(game.prediction().report().abandoned_frames, 0u);
  client::ClientState& state = game.client().state();
  const std::vector<std::string>& models = state.game().models;
  const auto model =
      static_cast<std::uint16_t>(std::find(models.begin(), models.end(), "*1") - models.begin());
  ASSERT_LT(model, models.size());
  const math::Bounds& bounds = game.level().models[1].bounds;
  const Vec3 origin = Vec3(game.player()[field::kOrigin]) - (bounds.mins + bounds.maxs) / 2.0f;
  ASSERT_TRUE(state.apply(net::Time{static_cast<float>(state.time_s() + 0.01)}).ok());
  for (std::uint16_t i = 1000; i < 9000; ++i) {
    const net::EntityUpdate update{.number = i, .model = model, .origin = {origin.x, origin.y, origin.z}};
    ASSERT_TRUE(state.apply(update).ok());
  }
  state.end_packet();
  client::Prediction prediction;
  prediction.begin_frame(game.client(), walking(0), game.now_s());
  EXPECT_FALSE(prediction.advance(state, game.level(), {}));
  EXPECT_EQ(prediction.report().abandoned_frames, 1u);
  // It resumes when they are gone.
  game.run(0.1, walking(0));
  prediction.begin_frame(game.client(), walking(0), game.now_s());
  EXPECT_TRUE(prediction.advance(state, game.level(), {}));
}

// --- Without prediction.

TEST(Prediction, ServersWithoutNumberedMovesGetNone) {
  client::Prediction prediction;
  const client::Connection connection(net::LoopbackNetwork().open(), {});
  prediction.begin_frame(connection, {}, 1);
  EXPECT_FALSE(prediction.advance(connection.state(), world::Level{}, {}));
}

}  // namespace
}  // namespace temblor::test
