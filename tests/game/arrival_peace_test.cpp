// The peace of an arrival: monsters leave a player alone for five seconds, until it fires or leaves its
// place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "game/room_level.h"

namespace temblor::test {
namespace {

namespace field = server::field;

// A hall in which a monster faces the player's start. `keys` are those of worldspawn.
std::string facing_text(const std::string& keys) {
  return entity_text("worldspawn", keys, walls_text({-400, -200, 0}, {400, 200, 200}, "wall")) +
         point_text("info_player_start", {-300, 0, 30}) +
         entity_text("monster_knight",
                     "\"origin\" \"100 0 30\"\n\"angle\" \"180\"\n\"targetname\" \"guard\"");
}

class Arrival {
 public:
  explicit Arrival(const std::string& keys = {})
      : data_(facing_text(keys)), game_(data_.path(), "room", kProgs) {
    game_.join(0);
    arrived_s_ = game_.time_s();
    knight_ = game_.of_class("monster_knight").at(0);
  }
  PlayedLevel& game() { return game_; }
  std::uint32_t knight() const { return knight_; }
  bool is_hunted() { return game_.edict(knight_)[field::kEnemy] == game_.player(0).index(); }
  // Seconds after the arrival until the knight hunts the player; nothing if it does not within ten.
  std::optional<double> find_noticed_s() {
    while (!is_hunted()) {
      if (game_.time_s() > arrived_s_ + 10) return std::nullopt;
      game_.tick();
    }
    return game_.time_s() - arrived_s_;
  }

 private:
  RoomData data_;
  PlayedLevel game_;
  double arrived_s_ = 0;
  std::uint32_t knight_ = 0;
};

// A monster looks around ten times per second.
constexpr double kBeat_s = 0.15;

TEST(ArrivalPeace, LastsFiveSeconds) {
  Arrival arrival;
  EXPECT_NEAR(arrival.find_noticed_s().value(), 5, kBeat_s);
  EXPECT_EQ(arrival.game().player(0)[field::kHealth], 100);
  EXPECT_THAT(arrival.game().errors(), ::testing::IsEmpty());
}

TEST(ArrivalPeace, LastsForTheTimeOfTheLevel) {
  EXPECT_NEAR(Arrival("\"peace\" \"2\"").find_noticed_s().value(), 2, kBeat_s);
  EXPECT_LT(Arrival("\"peace\" \"-1\"").find_noticed_s().value(), 1);
}

TEST(ArrivalPeace, EndsWhenThePlayerFires) {
  Arrival arrival;
  arrival.game().run(1);
  ASSERT_FALSE(arrival.is_hunted());
  arrival.game().input(0).buttons = kAttack;
  EXPECT_NEAR(arrival.find_noticed_s().value(), 1, kBeat_s);
}

TEST(ArrivalPeace, EndsWhenThePlayerLeaves) {
  Arrival arrival;
  arrival.game().run(1);
  arrival.game().put(arrival.game().player(0), {-300, 50, 24.03125f});  // still near its place
  arrival.game().run(1);
  EXPECT_FALSE(arrival.is_hunted());
  arrival.game().put(arrival.game().player(0), {-300, 80, 24.03125f});
  EXPECT_NEAR(arrival.find_noticed_s().value(), 2, kBeat_s);
}

// A monster that a trigger wakes comes at once, but does not strike yet.
TEST(ArrivalPeace, AlsoHoldsForMonstersThatAreWoken) {
  Arrival arrival;
  arrival.game().run(0.5);
  arrival.game().use(arrival.knight(), 1);
  EXPECT_TRUE(arrival.is_hunted());
  arrival.game().run(4.4);
  EXPECT_LT(glm::length(arrival.game().edict(arrival.knight())[field::kOrigin] -
                        arrival.game().player(0)[field::kOrigin]),
            100);
  EXPECT_EQ(arrival.game().player(0)[field::kHealth], 100);
  arrival.game().run(5);
  EXPECT_LT(arrival.game().player(0)[field::kHealth], 100);
}

// A monster cannot see the player, but another one that has noticed the player. Beyond 1000 units it does not
// react.
TEST(Alarms, ReachAsFarAsMonstersSee) {
  for (const bool is_near : {true, false}) {
    const double far_x = is_near ? 900 : 1300;
    // A wall hides the player from the second monster, and not the first one, which stands at its end.
    const std::string text =
        entity_text("worldspawn", "\"peace\" \"-1\"",
                    walls_text({-400, -400, 0}, {1400, 400, 200}, "wall") +
                        box_text({100, -400, 0}, {116, 100, 200}, "wall")) +
        point_text("info_player_start", {-300, -300, 30}) +
        entity_text("monster_knight", "\"origin\" \"60 300 30\"\n\"angle\" \"225\"") +
        entity_text("monster_ogre", fmt::format("\"origin\" \"{} 300 30\"\n\"angle\" \"180\"", far_x));
    const RoomData data(text);
    PlayedLevel game(data.path(), "room", kProgs);
    game.join(0);
    game.run(0.9);
    EXPECT_EQ(game.edict(game.of_class("monster_knight").at(0))[field::kEnemy], game.player(0).index());
    EXPECT_EQ(game.edict(game.of_class("monster_ogre").at(0))[field::kEnemy] == game.player(0).index(),
              is_near);
  }
}

}  // namespace
}  // namespace temblor::test
