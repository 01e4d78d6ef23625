// Bots come and go as the variables say, and play.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <set>

#include "game/room_level.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace field = server::field;

constexpr std::uint32_t kPlaces = 8;

int bots_in(const PlayedLevel& game) {
  int count = 0;
  for (std::uint32_t slot = 0; slot < kPlaces; ++slot) count += game.is_bot(slot);
  return count;
}

// Whether a living player has stayed within a small cube for suspiciously long.
class Watcher {
 public:
  explicit Watcher(PlayedLevel& io_game) : game_(io_game) {}

  // Called once per second.
  void look() {
    for (std::uint32_t slot = 0; slot < kPlaces; ++slot) {
      std::deque<math::Vec3>& places = places_[slot];
      const server::Edict player = game_.player(slot);
      if (!game_.is_bot(slot) || !(player[field::kHealth] > 0)) {
        places.clear();
        continue;
      }
      places.push_back(player[field::kOrigin]);
      if (places.size() > kLongest_s) places.pop_front();
      if (places.size() < kLongest_s) continue;
      math::Vec3 low = places[0], high = places[0];
      for (const math::Vec3& place : places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
      }
      if (glm::length(high - low) < kSmall) {
        const math::Vec3 at = places[0];
        stuck.push_back(fmt::format("slot {} at {:.0f} {:.0f} {:.0f} until {:.1f} s", slot, at.x, at.y, at.z,
                                    game_.time_s()));
        places.clear();
      }
    }
  }

  std::vector<std::string> stuck;

 private:
  static constexpr std::size_t kLongest_s = 10;
  static constexpr float kSmall = 48;
  PlayedLevel& game_;
  std::array<std::deque<math::Vec3>, kPlaces> places_;
};

struct Arena {
  const char* level;
  int minutes;
};

class Arenas : public ::testing::TestWithParam<Arena> {};

int times_said(const PlayedLevel& game, std::string_view what) {
  int times = 0;
  for (auto at = game.said().find(what); at != std::string::npos; at = game.said().find(what, at + 1))
    ++times;
  return times;
}

struct Played {
  float frags = 0;
  int accidents = 0;  // deaths caused by the level
};

Played play_arena(const std::filesystem::path& data, const Arena& arena) {
  PlayedLevel game(data, arena.level, kProgs, {.kind = server::GameKind::kDeathmatch, .players = kPlaces});
  game.set("bot_fill", "8");
  game.run(20);
  EXPECT_EQ(bots_in(game), 8);
  Watcher watcher(game);
  const int seconds = effort(60 * arena.minutes, 40);
  for (int second = 0; second < seconds; ++second) {
    game.run(1);
    watcher.look();
  }
  EXPECT_THAT(game.errors(), IsEmpty());
  EXPECT_THAT(watcher.stuck, IsEmpty());
  float frags = 0;
  for (std::uint32_t slot = 0; slot < kPlaces; ++slot) frags += game.player(slot)[field::kFrags];
  EXPECT_GT(frags, 8 * seconds / 60);
  return Played{frags, times_said(game, " went into the lava") + times_said(game, " was crushed") +
                           times_said(game, " forgot about gravity")};
}

TEST_P(Arenas, EightBotsPlayAndNobodyIsStuck) {
  DATA_FOLDER_OR_SKIP(data);
  play_arena(data, GetParam());
}

// Our levels, if they have been built.
class ShippedArenas : public ::testing::TestWithParam<std::string> {};

// The Anvil has lava and a hammer in its middle, with the best items under it.
TEST_P(ShippedArenas, EightBotsPlayUnstuckAndAvoidHazards) {
  const std::filesystem::path data = TEMBLOR_GAMES;
  if (!std::filesystem::exists(data / "id1/maps" / (GetParam() + ".bsp")))
    GTEST_SKIP() << "the level has not been built (target game_maps)";
  const Played played = play_arena(data, {GetParam().c_str(), 10});
  EXPECT_LT(static_cast<float>(played.accidents), 3 + played.frags / 8);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedArenas, ::testing::Values("tdm1", "tdm2", "tdm3", "tdm4"),
                         [](const auto& arena) { return arena.param; });

// A small level, one with lava, and shorter games in large ones, which tell sanitizers nothing new.
std::vector<Arena> list_arenas() {
  std::vector<Arena> arenas = {{"lqdm1", 10}, {"lqdm12", 10}};
  if (!kQuick) arenas.insert(arenas.end(), {{"lqdm3", 4}, {"lqdm5", 4}, {"lqdm11", 4}});
  return arenas;
}

INSTANTIATE_TEST_SUITE_P(All, Arenas, ::testing::ValuesIn(list_arenas()),
                         [](const auto& arena) { return std::string(arena.param.level); });

class Company : public ::testing::Test {
 protected:
  Company() : data_(hall_text({0, -400, 0}, {1200, 400, 256}, {}, starts())) {}

  // Six more starts than the hall's two: nobody has to spawn inside somebody else.
  static std::string starts() {
    std::string text;
    for (int i = 0; i < 6; ++i)
      text += point_text("info_player_deathmatch", {200.0 + 150 * i, i % 2 == 0 ? -300.0 : 300.0, 40});
    return text;
  }

  PlayedLevel begin(server::GameKind kind) {
    return PlayedLevel(data_.path(), "room", kProgs, {.kind = kind, .players = kPlaces});
  }

  RoomData data_;
};

TEST_F(Company, FillUpToTheVariableIncludingPeople) {
  PlayedLevel game = begin(server::GameKind::kDeathmatch);
  game.run(10);
  EXPECT_EQ(bots_in(game), 0);
  game.set("bot_fill", "4");
  game.run(10);
  EXPECT_EQ(bots_in(game), 4);
  EXPECT_THAT(game.said(), HasSubstr("Basalt"));
  game.join(0);
  game.run(3);
  EXPECT_EQ(bots_in(game), 3);
  game.set("bot_fill", "16");
  game.run(10);
  EXPECT_EQ(bots_in(game), 7);  // no more slots
  game.set("bot_fill", "0");
  game.run(10);
  EXPECT_EQ(bots_in(game), 0);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST_F(Company, HaveDistinctNames) {
  PlayedLevel game = begin(server::GameKind::kDeathmatch);
  game.set("bot_fill", "8");
  game.run(15);
  std::set<std::string> names;
  for (std::uint32_t slot = 0; slot < kPlaces; ++slot)
    names.insert(game.text(game.player(slot)[field::kNetName]));
  EXPECT_EQ(names.size(), 8u);
}

TEST_F(Company, JoinOnlyDeathmatches) {
  PlayedLevel game = begin(server::GameKind::kCooperative);
  game.set("bot_fill", "8");
  game.run(10);
  EXPECT_EQ(bots_in(game), 0);
}

TEST_F(Company, MoreSkilledOnesKillMore) {
  float frags[2] = {};
  for (const int skill : {0, 3}) {
    PlayedLevel game = begin(server::GameKind::kDeathmatch);
    game.set("bot_fill", "4");
    game.set("bot_skill", std::to_string(skill));
    game.run(120);
    for (std::uint32_t slot = 0; slot < kPlaces; ++slot) frags[skill / 3] += game.player(slot)[field::kFrags];
    EXPECT_THAT(game.errors(), IsEmpty());
  }
  EXPECT_GT(frags[0], 4);
  EXPECT_GT(frags[1], 2 * frags[0]);
}

TEST_F(Company, UseTheTremor) {
  PlayedLevel game = begin(server::GameKind::kDeathmatch);
  game.set("bot_fill", "2");
  game.run(8);
  for (int second = 0; second < 60; ++second) {
    for (std::uint32_t slot = 0; slot < kPlaces; ++slot) {
      game.player(slot).set(field::kItems, 128 + 4096);
      game.player(slot).set(field::kAmmoCells, 100);
    }
    game.run(1);
  }
  EXPECT_THAT(game.said(), HasSubstr("was shaken apart by "));
  EXPECT_THAT(game.errors(), IsEmpty());
}

// A person joins and stands still: bots find and kill it.
TEST_F(Company, HuntPeople) {
  PlayedLevel game = begin(server::GameKind::kDeathmatch);
  game.set("bot_fill", "3");
  game.join(0);
  game.run(60);
  float deaths = 0;
  for (std::uint32_t slot = 1; slot < kPlaces; ++slot) deaths += game.player(slot)[field::kFrags];
  EXPECT_GE(deaths, 1);
  EXPECT_LE(game.player(0)[field::kHealth], 100);
}

}  // namespace
}  // namespace temblor::test
