// Whom a player fights, with what, and how he moves meanwhile.
#pragma once

#include <map>
#include <optional>

#include "game/player/dice.h"
#include "game/player/level_facts.h"
#include "game/player/senses.h"

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

class Fighter {
 public:
  explicit Fighter(Dice& io_dice) : dice_(&io_dice) {}

  // One tick; nothing: there is nobody to fight.
  std::optional<FightPlan> fight(server::Game& io_game, const Self& self, double now_s);
  // A weapon for something that does not fight back; 0: the one in hand will do.
  static int impulse_for_target(const Self& self, float distance);

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

  Dice* dice_;
  std::map<std::uint32_t, Grudge> grudges_;
  std::optional<vm::EntityIndex> enemy_;
  double chosen_s_ = 0;
  float side_ = 1;
  double side_until_s_ = 0;
  double changed_weapon_s_ = 0;
};

}  // namespace temblor::player
