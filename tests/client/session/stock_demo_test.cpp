// The stock demos, played from the first message to the last.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <ostream>
#include <string>

#include "client/demo/demo_player.h"
#include "net/protocol/dem_packets.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using client::ClientSettings;
using client::DemoPlayer;
using client::InterpolatedEntity;

// From a listing of the demo's messages: the times of the first and last packet, and how the last message of
// each kind leaves the 15 stats that games use.
struct StockDemo {
  const char* name;
  const char* level;
  const char* title;
  std::size_t packets;
  float first_time_s, last_time_s;
  std::array<std::int32_t, 15> stats;
};

void PrintTo(const StockDemo& demo, std::ostream* out) {
  *out << demo.name;
}

class StockDemos : public ::testing::TestWithParam<StockDemo> {
 protected:
  static base::ByteVector read(const std::filesystem::path& folder) {
    return read_file(folder / "id1" / GetParam().name);
  }
};

TEST_P(StockDemos, HaveTheLengthOfTheirMessages) {
  DATA_FOLDER_OR_SKIP(folder);
  const auto length = DemoPlayer::scan(read(folder), GetParam().name).value();
  EXPECT_EQ(length.packets, GetParam().packets);
  EXPECT_EQ(length.first_time_s, static_cast<double>(GetParam().first_time_s));
  EXPECT_EQ(length.last_time_s, static_cast<double>(GetParam().last_time_s));
  EXPECT_EQ(length.levels, std::vector<std::string>{GetParam().level});
  EXPECT_FALSE(length.is_truncated);
  EXPECT_FALSE(length.damage) << length.damage->message();
}

void expect_end(const client::Game& game, const StockDemo& demo) {
  for (std::size_t stat = 0; stat < demo.stats.size(); ++stat)
    EXPECT_EQ(game.stats[stat], demo.stats[stat]) << "stat " << stat;
  EXPECT_EQ(game.level_name, demo.title);
  ASSERT_EQ(game.players.size(), 1u);
  EXPECT_EQ(game.players[0].name, "player");
  // A message that holds from a second after the start on, as these demos show views of the level.
  EXPECT_EQ(game.ending, client::Ending::kCutScene);
  EXPECT_EQ(game.ending_text, "");
}

// Frames in between must not change the end.
TEST_P(StockDemos, EndInTheSameState) {
  DATA_FOLDER_OR_SKIP(folder);
  const base::ByteVector bytes = read(folder);
  for (const double frames_a_second : {5.0, 72.0, 250.0}) {
    DemoPlayer player = DemoPlayer::open(bytes, GetParam().name).value();
    int frame = 0;
    const auto next_time_s = [&] {
      return static_cast<double>(GetParam().first_time_s) + frame++ / frames_a_second;
    };
    double before_s = 0;
    while (player.advance_to(next_time_s()).value()) {
      EXPECT_GE(player.server_time_s(), before_s);
      before_s = player.server_time_s();
      const auto entities = player.state().interpolate_entities(player.server_time_s(), {});
      EXPECT_FALSE(entities.empty());
      player.state().events().clear();
    }
    expect_end(player.state().game(), GetParam());
    EXPECT_EQ(player.server_time_s(), static_cast<double>(GetParam().last_time_s));
  }
}

// Baselines, and updates relative to them, as the protocol's description says. Entities without a model are
// not shown, except for the view entity (1).
class NaiveEntities {
 public:
  struct Entity {
    net::Baseline now;
    std::uint8_t effects = 0;
  };

  void read(const net::ServerMessage& message) {
    if (const auto* baseline = std::get_if<net::SpawnBaseline>(&message))
      baselines_[baseline->number] = baseline->entity;
    if (std::holds_alternative<net::Time>(message)) shown_.clear();
    if (const auto* update = std::get_if<net::EntityUpdate>(&message)) read_update(*update);
  }
  const std::map<std::uint16_t, Entity>& shown() const { return shown_; }

 private:
  void read_update(const net::EntityUpdate& update) {
    Entity& entity = shown_[update.number];
    entity = {.now = baselines_[update.number], .effects = update.effects.value_or(std::uint8_t{0})};
    if (update.model) entity.now.model = *update.model;
    if (update.frame) entity.now.frame = *update.frame;
    if (update.skin) entity.now.skin = *update.skin;
    if (update.alpha) entity.now.alpha = *update.alpha;
    for (int axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<std::size_t>(axis);
      if (update.origin[component]) entity.now.origin[axis] = *update.origin[component];
      if (update.angles_deg[component]) entity.now.angles_deg[axis] = *update.angles_deg[component];
    }
    if (entity.now.model == 0 && update.number != 1) shown_.erase(update.number);
  }
  std::map<std::uint16_t, net::Baseline> baselines_;
  std::map<std::uint16_t, Entity> shown_;
};

void expect_same(const InterpolatedEntity& seen, const NaiveEntities::Entity& expected) {
  EXPECT_EQ(seen.model, expected.now.model);
  EXPECT_EQ(seen.from_frame, expected.now.frame);
  EXPECT_EQ(seen.to_frame, expected.now.frame);
  EXPECT_EQ(seen.skin, expected.now.skin);
  EXPECT_EQ(seen.effects, expected.effects);
  EXPECT_EQ(seen.alpha, expected.now.alpha);
  EXPECT_EQ(seen.origin_world, expected.now.origin);
  EXPECT_EQ(seen.angles_deg, expected.now.angles_deg);
}

TEST_P(StockDemos, ShowTheEntitiesOfTheirPackets) {
  DATA_FOLDER_OR_SKIP(folder);
  const base::ByteVector bytes = read(folder);
  net::MessageReader reader;
  client::ClientState state;
  NaiveEntities naive;
  const ClientSettings snap = {.interpolate = false, .no_lerp_models = {}};
  std::size_t compared = 0;
  for (const DemPacket& packet : dem_packets(bytes)) {
    reader.begin(packet.bytes, packet.offset);
    while (const auto message = reader.next().value()) {
      ASSERT_TRUE(state.apply(*message).ok());
      naive.read(*message);
    }
    state.end_packet();
    state.events().clear();
    auto expected = naive.shown().begin();
    for (const InterpolatedEntity& seen : state.interpolate_entities(state.time_s(), snap)) {
      if (seen.number >= InterpolatedEntity::kFirstStatic) break;
      ASSERT_NE(expected, naive.shown().end());
      ASSERT_EQ(seen.number, expected->first);
      expect_same(seen, expected->second);
      ++expected, ++compared;
    }
    ASSERT_EQ(expected, naive.shown().end());
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, GetParam().packets) << "the player and other entities";
}

INSTANTIATE_TEST_SUITE_P(All, StockDemos,
                         ::testing::Values(StockDemo{"demo1_lite.dem",
                                                     "maps/lq_e0m1.bsp",
                                                     "Baseless Base Banter",
                                                     4529,
                                                     91.2315903f,
                                                     151.511276f,
                                                     {100, 0, 34, 23, 0, 0, 23, 0, 0, 0, 1, 3, 54, 0, 1}},
                                           StockDemo{"demo2_lite.dem",
                                                     "maps/lq_e0m2.bsp",
                                                     "Cruel Cave Conundrum",
                                                     4572,
                                                     185.022858f,
                                                     245.469986f,
                                                     {100, 0, 119, 25, 0, 0, 25, 0, 0, 0, 1, 3, 81, 0, 0}},
                                           StockDemo{"demo3_lite.dem",
                                                     "maps/lq_e0m3.bsp",
                                                     "Mountainous Mining Menace",
                                                     3239,
                                                     228.242798f,
                                                     288.549347f,
                                                     {71, 0, 25, 0, 0, 0, 91, 200, 100, 100, 0, 2, 63, 0, 1}},
                                           StockDemo{
                                               "demo3.dem",
                                               "maps/lqdm3.bsp",
                                               "Hyperborea",
                                               1234,
                                               416.466125f,
                                               446.693787f,
                                               {93, 0, 23, 94, 28, 0, 98, 194, 94, 100, 32, 0, 0, 0, 0}}),
                         [](const auto& demo) {
                           const std::string name = demo.param.name;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace temblor::test
