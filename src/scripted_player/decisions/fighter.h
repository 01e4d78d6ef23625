// Whom a player fights, with what, and how he moves meanwhile.
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "scripted_player/decisions/dice.h"
#include "scripted_player/decisions/senses.h"
#include "scripted_player/navigation/level_facts.h"

namespace temblor::player {

struct FightPlan {
  vm::EntityIndex enemy{};
  math::Vec3 aim_at{0.0f};
  math::Vec3 velocity{0.0f};  // wished
  bool fires = false;         // if the view is on the target by then
  float tolerance_deg = 3;
  int impulse = 0;                // changes the weapon
  bool stands_and_fights = true;  // false: goes on, and shoots on the way
};

// Of the item bits the one of that class; 0: it is no weapon that he knows.
int weapon_bit_of(std::string_view classname);

class Fighter {
 public:
  Fighter(Dice& io_dice, bool fights_players) : dice_(&io_dice), fights_players_(fights_players) {}

  // One tick; nothing: there is nobody to fight.
  std::optional<FightPlan> fight(server::Game& io_game, const Self& self, double now_s);
  // As of the last tick in which he fought.
  bool has_enemy() const { return enemy_.has_value(); }
  // A weapon for something that does not fight back; 0: the one in hand will do.
  static int impulse_for_target(const Self& self, float distance);
  // How far that gets, with what he has left.
  static float reach_for_target(const Self& self);

 private:
  struct Grudge {
    double since_s = 0, hit_s = 0, ignored_until_s = 0;
    float health = 0;
    math::Vec3 seen_at{0.0f}, velocity{0.0f};  // monsters walk without having a velocity
    double seen_s = 0;
  };
  static void note_motion(const math::Vec3& at, double now_s, Grudge& io_grudge);
  std::optional<vm::EntityIndex> choose(server::Game& io_game, const Self& self, double now_s);
  math::Vec3 choose_way(server::Game& io_game, const Self& self, const math::Vec3& enemy, bool is_melee,
                        double now_s);

  bool is_foe(server::Game& io_game, const Self& self, const server::Edict& edict) const;
  bool can_roll(const Self& self, const server::Edict& enemy, double now_s);
  bool is_shot_safe(server::Game& io_game, const Self& self, const math::Vec3& to) const;

  Dice* dice_;
  bool fights_players_;
  bool rolls_ = false;  // has a mind to use the weapon whose shots roll along the floor
  double minded_until_s_ = 0;
  std::map<std::uint32_t, Grudge> grudges_;
  std::optional<vm::EntityIndex> enemy_;
  double chosen_s_ = 0;
  float side_ = 1;
  double side_until_s_ = 0;
  double changed_weapon_s_ = 0;
};

}  // namespace temblor::player
