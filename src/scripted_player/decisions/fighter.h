// Combat: chooses an enemy, a weapon, where to aim, and how to move meanwhile.
//
// The enemy is the nearest visible one, with a bonus for the current one and a penalty for monsters that have
// not noticed the player. An enemy that loses no health for a while is ignored for some seconds. Aim leads
// moving targets by the flight time of the missile.
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "scripted_player/decisions/random.h"
#include "scripted_player/decisions/senses.h"
#include "scripted_player/navigation/level_facts.h"

namespace temblor::player {

// The decisions for this tick.
struct FightPlan {
  vm::EntityIndex enemy{};
  math::Vec3 aim_at{0.0f};
  // Wanted velocity in units/s.
  math::Vec3 velocity{0.0f};
  // Fires once the view is within tolerance_deg of aim_at.
  bool fires = false;
  float tolerance_deg = 3;
  // Changes the weapon; 0: keeps it.
  int impulse = 0;
  // Stays and fights; otherwise the player continues on its way and shoots meanwhile.
  bool stands_ground = true;
};

// Returns the bit in `items` of a weapon's class name; 0 if it is not a known weapon.
int find_weapon_bit(std::string_view classname);

class Fighter {
 public:
  // `io_dice` must outlive it.
  Fighter(Random& io_dice, bool fights_players) : dice_(&io_dice), fights_players_(fights_players) {}

  // Plans one tick; nothing if there is no enemy.
  std::optional<FightPlan> fight(server::Game& io_game, const Self& self, double now_s);
  // Returns whether the last call of fight() had an enemy.
  bool has_enemy() const { return enemy_.has_value(); }
  // Returns the impulse for a weapon against a target that does not fight back, such as a button; 0 if the
  // current one is right.
  static int impulse_for_target(const Self& self, float distance);
  // Returns the range of the farthest such weapon that the player has ammunition for.
  static float reach_for_target(const Self& self);

 private:
  struct EnemyRecord {
    // When the fight began, when the enemy last lost health, and until when it is ignored.
    double since_s = 0, hit_s = 0, ignored_until_s = 0;
    float health = 0;
    // The velocity is measured, because the velocity field of walking monsters is 0.
    math::Vec3 seen_at{0.0f}, velocity{0.0f};
    double seen_s = 0;
  };
  static void update_velocity(const math::Vec3& at, double now_s, EnemyRecord& io_record);
  std::optional<vm::EntityIndex> choose(server::Game& io_game, const Self& self, double now_s);
  math::Vec3 choose_velocity(server::Game& io_game, const Self& self, const math::Vec3& enemy, bool is_melee,
                             double now_s);

  bool is_foe(server::Game& io_game, const Self& self, const server::Edict& edict) const;
  bool can_roll(const Self& self, const server::Edict& enemy, double now_s);
  bool is_shot_safe(server::Game& io_game, const Self& self, const math::Vec3& to) const;

  Random* dice_;
  bool fights_players_;
  // Currently willing to use the weapon whose shots roll along the floor (weapon_tremor).
  bool rolls_ = false;
  double rolls_until_s_ = 0;
  // By entity.
  std::map<std::uint32_t, EnemyRecord> enemies_;
  std::optional<vm::EntityIndex> enemy_;
  double chosen_s_ = 0;
  // Direction in which it circles the enemy: 1 or -1.
  float side_ = 1;
  double side_until_s_ = 0;
  double changed_weapon_s_ = 0;
};

}  // namespace temblor::player
