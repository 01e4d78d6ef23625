// How monsters fight: they announce attacks, turn smoothly, and never stand idle in sight of their enemy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <set>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

constexpr std::uint32_t kPlayer = 1;

struct Conduct {
  int attacks = 0;
  double shortest_warning_s = 1e9;  // from the begin of an attack until it does damage or a missile flies
  double longest_idle_s = 0;        // in sight of the player, without moving, attacking, or doing damage
  float fastest_turn_deg = 0;       // within a tenth of a second
  int swings = 0;                   // between left and right from one tenth of a second to the next
};

// Watches one monster that fights the first player.
class ConductWatch {
 public:
  ConductWatch(PlayedLevel& io_game, std::uint32_t monster)
      : game_(io_game),
        monster_(monster),
        place_(io_game.edict(monster)[field::kOrigin]),
        damage_(io_game.player(0)[field::kDamageTaken]),
        idle_since_s_(io_game.time_s()) {}

  // Call after each tick.
  void look() {
    const double now_s = game_.time_s();
    const bool acts = game_.edict_function(monster_, "seq_end") != "play_again";
    const float frame = game_.edict(monster_)[field::kFrame];
    if (acts && (frame < frame_ || !acts_)) {
      attack_since_s_ = now_s;
      ++conduct_.attacks;
    }
    acts_ = acts;
    frame_ = frame;
    const bool hits = notice_hits();
    if (hits && attack_since_s_) {
      conduct_.shortest_warning_s = std::min(conduct_.shortest_warning_s, now_s - *attack_since_s_);
      attack_since_s_.reset();
    }
    const math::Vec3 at = game_.edict(monster_)[field::kOrigin];
    if (acts || hits || glm::length(at - place_) > 6 || !game_.sees(monster_, kPlayer)) {
      place_ = at;
      idle_since_s_ = now_s;
    }
    conduct_.longest_idle_s = std::max(conduct_.longest_idle_s, now_s - idle_since_s_);
    notice_swings();
    yaws_.push_back({now_s, game_.edict(monster_)[field::kAngles].y});
    while (yaws_.front().first < now_s - 0.095) yaws_.pop_front();
    conduct_.fastest_turn_deg =
        std::max(conduct_.fastest_turn_deg,
                 std::abs(std::remainder(yaws_.back().second - yaws_.front().second, 360.0f)));
  }

  const Conduct& conduct() const { return conduct_; }

 private:
  void notice_swings() {
    const float yaw = game_.edict(monster_)[field::kAngles].y;
    const float turn = std::remainder(yaw - std::exchange(yaw_, yaw), 360.0f);
    if (std::abs(turn) < 5) return;
    conduct_.swings += turn * std::exchange(turn_, turn) < 0;
  }

  // A new missile of the monster, or damage that it does itself.
  bool notice_hits() {
    std::set<std::uint32_t> missiles;
    bool is_new = false;
    for (std::uint32_t i = 1; i < game_.edict_count(); ++i) {
      if (game_.is_free(i) || game_.edict(i)[field::kOwner] != game_.edict(monster_).index()) continue;
      missiles.insert(i);
      is_new |= !missiles_.contains(i);
    }
    missiles_ = missiles;
    const float damage = game_.player(0)[field::kDamageTaken];
    const bool hurt = damage > std::exchange(damage_, damage) &&
                      game_.player(0)[field::kDamageInflictor] == game_.edict(monster_).index();
    return is_new || hurt;
  }

  PlayedLevel& game_;
  std::uint32_t monster_;
  Conduct conduct_;
  math::Vec3 place_;
  float damage_ = 0, frame_ = 0;
  float yaw_ = 0, turn_ = 0;
  bool acts_ = false;
  double idle_since_s_ = 0;
  std::optional<double> attack_since_s_;
  std::set<std::uint32_t> missiles_;
  std::deque<std::pair<double, float>> yaws_;  // by time
};

class MonsterConduct : public ::testing::TestWithParam<std::string> {
 protected:
  // A player who cannot be hurt, in a hall; after the peace of its arrival, it is put at `place`.
  void begin(const std::string& brushes, int skill, const math::Vec3& place) {
    data_ = std::make_unique<RoomData>(hall_text({-700, -700, 0}, {700, 700, 400}, brushes));
    game_ = std::make_unique<PlayedLevel>(data_->path(), "room", kProgs, PlayedSettings{.skill = skill});
    game_->set("skill", std::to_string(skill));
    game_->join(0);
    game_->run(6);
    game_->player(0).set_flag(server::flag::kGodMode);
    game_->put(game_->player(0), place);
    game_->run(0.5);
  }

  std::unique_ptr<RoomData> data_;
  std::unique_ptr<PlayedLevel> game_;
};

TEST_P(MonsterConduct, AttacksAreAnnouncedAndNoTimeIsWasted) {
  const bool swims = GetParam() == "monster_fish";
  for (const int skill : {1, 3}) {
    begin(swims ? box_text({-700, -700, 0}, {700, 700, 250}, "*water") : "", skill,
          {-200, 0, swims ? 120.0f : 24.1f});
    const std::uint32_t monster = game_->spawn(GetParam(), {300, 0, swims ? 120.0f : 30.0f}, 180);
    ConductWatch watch(*game_, monster);
    for (int tick = 0; tick < 40 * 72; ++tick) {
      game_->input(0).command.view_angles_deg = {0, static_cast<float>(tick % 1440) * 0.25f, 0};
      game_->input(0).command.forward = 150;
      game_->tick();
      watch.look();
    }
    const Conduct& conduct = watch.conduct();
    EXPECT_GE(conduct.attacks, 5);
    EXPECT_GE(conduct.shortest_warning_s, 0.28);
    EXPECT_LE(conduct.longest_idle_s, 1);
    EXPECT_LE(conduct.fastest_turn_deg, 60);
    EXPECT_THAT(game_->errors(), IsEmpty());
  }
}

TEST_P(MonsterConduct, ThoseThatCannotReachTheirEnemyKeepMoving) {
  if (GetParam() == "monster_fish") return;  // baffled_test.cpp
  begin(box_text({-40, -40, 0}, {40, 40, 160}, "wall"), 1, {0, 0, 184.1f});
  const std::uint32_t monster = game_->spawn(GetParam(), {300, 0, 30}, 180);
  ConductWatch watch(*game_, monster);
  for (int tick = 0; tick < 40 * 72; ++tick) {
    game_->tick();
    watch.look();
  }
  EXPECT_LE(watch.conduct().longest_idle_s, 1);
  EXPECT_LE(watch.conduct().fastest_turn_deg, 60);
  EXPECT_THAT(game_->errors(), IsEmpty());
}

// On the top of a pillar, from which it does not see the player below.
class MonsterOnAPillar : public ::testing::TestWithParam<std::string> {
 protected:
  static Conduct pace(float half_width) {
    const RoomData data(
        hall_text({-700, -700, 0}, {700, 700, 400},
                  box_text({-half_width, -half_width, 0}, {half_width, half_width, 160}, "wall")));
    PlayedLevel game(data.path(), "room", kProgs, PlayedSettings{.skill = 3});
    game.join(0);
    game.run(6);
    game.player(0).set_flag(server::flag::kGodMode);
    game.put(game.player(0), {half_width + 30, 10, 24.1f});
    const std::uint32_t monster = game.spawn(GetParam(), {0, 0, 190}, 0);
    game.run(0.5);
    game.hurt(monster, kPlayer, 1);
    EXPECT_EQ(game.edict(monster)[field::kEnemy], game.player(0).index());
    ConductWatch watch(game, monster);
    for (int tick = 0; tick < 20 * 72; ++tick) {
      game.tick();
      watch.look();
    }
    EXPECT_THAT(game.errors(), IsEmpty());
    return watch.conduct();
  }
};

TEST_P(MonsterOnAPillar, KeepsItsDirectionWhileItTurns) {
  EXPECT_LE(pace(80).swings, 20);
}

TEST_P(MonsterOnAPillar, StandsCalmlyWhereItCannotTakeAStep) {
  EXPECT_LE(pace(GetParam() == "monster_ogre" ? 40 : 20).swings, 2);
}

INSTANTIATE_TEST_SUITE_P(All, MonsterOnAPillar,
                         ::testing::Values("monster_army", "monster_knight", "monster_enforcer",
                                           "monster_ogre"),
                         [](const auto& kind) { return kind.param; });

INSTANTIATE_TEST_SUITE_P(All, MonsterConduct,
                         ::testing::Values("monster_army", "monster_dog", "monster_knight", "monster_ogre",
                                           "monster_wizard", "monster_enforcer", "monster_demon1",
                                           "monster_shambler", "monster_zombie", "monster_hell_knight",
                                           "monster_shalrath", "monster_tarbaby", "monster_fish"),
                         [](const auto& kind) { return kind.param; });

}  // namespace
}  // namespace temblor::test
