#include "scripted_player/decisions/fighter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "server/move_trace.h"

namespace temblor::player {
namespace {

namespace field = server::field;

// Enemies farther away are ignored. Monsters that have not noticed the player are left alone unless they are
// near.
constexpr float kMaxEnemy_units = 900, kMaxUnawareEnemy_units = 500;
constexpr double kChooseEvery_s = 0.15;
// An enemy that loses no health for kMaxWithoutHit_s is ignored for kIgnore_s.
constexpr double kMaxWithoutHit_s = 7, kIgnore_s = 12;
constexpr float kStrafeSpeed = 320, kAxeFight_units = 110;
// The floor is checked this far ahead before the player strafes there.
constexpr float kProbe_units = 56;
// Distances at which the player backs off, and at which it closes in.
constexpr float kTooClose_units = 190, kFarForShot_units = 480;
constexpr double kWeaponPause_s = 0.5, kMotion_s = 0.2;
// The shock wave needs an enemy whose feet are at most this far above or below the player's.
constexpr float kShockWaveHeight_units = 48;

struct Weapon {
  // Bit of the `items` and `weapon` fields, and the impulse that selects it.
  int bit = 0, impulse = 0;
  float Self::*ammunition = nullptr;
  float needs = 0;
  // Range in units.
  float nearest = 0, farthest = 0;
  // In units/s; 0: hits at once.
  float missile_speed = 0;
  // Explodes, so it hurts the player at close range.
  bool bursts = false;
  // Its shots roll along the floor.
  bool rolls = false;
};

// In order of preference: tremor, lightning, super nailgun, rocket launcher, super shotgun, nailgun, shotgun,
// grenade launcher, axe. Columns: item bit, impulse, ammunition, rounds needed, range, missile speed, bursts,
// rolls.
constexpr std::array<Weapon, 9> kWeapons = {{
    {128, 13, &Self::cells, 5, 90, 420, 640, false, true},
    {64, 8, &Self::cells, 4, 0, 560, 0, false},
    {8, 5, &Self::nails, 8, 0, 900, 1000, false},
    {32, 7, &Self::rockets, 1, 190, 1200, 1000, true},
    {2, 3, &Self::shells, 2, 0, 300, 0, false},
    {4, 4, &Self::nails, 4, 0, 900, 1000, false},
    {1, 2, &Self::shells, 1, 0, 700, 0, false},
    {16, 6, &Self::rockets, 1, 180, 420, 600, true},
    {4096, 1, nullptr, 0, 0, 1200, 0, false},
}};

// Item bits of weapons for targets that do not fight back, in order of preference: shotgun, nailgun, super
// nailgun, super shotgun, lightning. Explosives are not used, because such targets may be close.
constexpr std::array<int, 5> kTargetWeapons = {1, 4, 8, 2, 64};
constexpr float kAxeReach_units = 52;

bool can_use(const Self& self, const Weapon& weapon) {
  if ((self.items & weapon.bit) == 0) return false;
  // Lightning discharges in water and kills the player.
  if (weapon.bit == 64 && self.water_level > 1) return false;
  return weapon.ammunition == nullptr || self.*weapon.ammunition >= weapon.needs;
}

// Returns the best weapon for the distance; if there is none, the best one that is safe at any distance.
const Weapon& choose_weapon(const Self& self, float distance, bool only_bursts, bool can_roll) {
  for (const Weapon& weapon : kWeapons)
    if (can_use(self, weapon) && distance >= weapon.nearest && distance <= weapon.farthest &&
        (!only_bursts || weapon.bursts) && (!weapon.rolls || can_roll))
      return weapon;
  for (const Weapon& weapon : kWeapons)
    if (can_use(self, weapon) && !weapon.bursts && !weapon.rolls) return weapon;
  return kWeapons.back();
}

bool has_bursting_weapon(const Self& self) {
  return std::any_of(kWeapons.begin(), kWeapons.end(),
                     [&](const Weapon& weapon) { return weapon.bursts && can_use(self, weapon); });
}

bool has_gun(const Self& self) {
  return std::any_of(kWeapons.begin(), kWeapons.end(), [&](const Weapon& weapon) {
    return weapon.ammunition != nullptr && can_use(self, weapon);
  });
}

const Weapon& in_hand(const Self& self) {
  for (const Weapon& weapon : kWeapons)
    if (weapon.bit == self.weapon) return weapon;
  return kWeapons.back();
}

math::Vec3 middle(const server::Edict& edict) {
  return edict[field::kOrigin] + (edict[field::kMins] + edict[field::kMaxs]) * 0.5f;
}

// Monsters that attack only at close range: keep away from them.
bool is_melee_class(std::string_view name) {
  static constexpr std::array<std::string_view, 5> kNames = {
      "monster_dog", "monster_knight", "monster_demon1", "monster_fish", "monster_tarbaby"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

// Explosive boxes nearer than this would hurt the player.
constexpr float kBlast_units = 190;

bool is_explosive(server::Game& io_game, const server::Edict& edict) {
  return edict[field::kTakeDamage] != 0 && class_name(io_game, edict.index()).starts_with("misc_explobox");
}

// Sums up the directions away from explosive boxes nearby; 0 if there are none.
math::Vec3 away_from_explosives(server::Game& io_game, const Self& self) {
  server::GameWorld& world = io_game.world();
  math::Vec3 away(0.0f);
  for (std::uint32_t i = 1 + world.edicts.client_count(); i < world.edicts.count(); ++i) {
    if (world.edicts.is_free(vm::EntityIndex{i})) continue;
    const server::Edict edict = world.edicts[vm::EntityIndex{i}];
    const math::Vec3 offset = self.origin - middle(edict);
    if (glm::length(offset) < kBlast_units && is_explosive(io_game, edict))
      away += math::Vec3(offset.x, offset.y, 0) / std::max(glm::length(math::Vec2(offset)), 1.0f);
  }
  return away;
}

math::Vec3 turned(const math::Vec3& v, float radians) {
  return {v.x * std::cos(radians) - v.y * std::sin(radians),
          v.x * std::sin(radians) + v.y * std::cos(radians), 0};
}

}  // namespace

int find_weapon_bit(std::string_view classname) {
  static constexpr std::array<std::pair<std::string_view, int>, 7> kBits = {{{"weapon_supershotgun", 2},
                                                                             {"weapon_nailgun", 4},
                                                                             {"weapon_supernailgun", 8},
                                                                             {"weapon_grenadelauncher", 16},
                                                                             {"weapon_rocketlauncher", 32},
                                                                             {"weapon_lightning", 64},
                                                                             {"weapon_tremor", 128}}};
  for (const auto& [weapon, bit] : kBits)
    if (weapon == classname) return bit;
  return 0;
}

// Returns whether a shot hits neither a fellow player nor an explosive box near the player.
bool Fighter::is_shot_safe(server::Game& io_game, const Self& self, const math::Vec3& to) const {
  const server::EntityTrace trace = server::trace_move(io_game.world(), self.eye(), {0, 0, 0}, {0, 0, 0}, to,
                                                       server::MoveKind::kNormal, self.entity);
  if (!trace.hit || trace.entity == vm::kWorld) return true;
  if (io_game.world().edicts.is_client(trace.entity)) return fights_players_;
  const server::Edict edict = io_game.world().edicts[trace.entity];
  return !is_explosive(io_game, edict) || glm::distance(middle(edict), self.origin) > kBlast_units;
}

bool Fighter::is_foe(server::Game& io_game, const Self& self, const server::Edict& edict) const {
  if (edict[field::kHealth] <= 0 || edict[field::kTakeDamage] == 0) return false;
  if (io_game.world().edicts.is_client(edict.index())) return fights_players_ && edict.index() != self.entity;
  return edict.has_flag(server::flag::kMonster);
}

// A shock wave reaches enemies that stand on the same floor. The player uses it only half of the time, for
// variety.
bool Fighter::can_roll(const Self& self, const server::Edict& enemy, double now_s) {
  if (now_s > rolls_until_s_) {
    rolls_until_s_ = now_s + dice_->between(2, 4);
    rolls_ = dice_->unit() < 0.5f;
  }
  return rolls_ && self.on_ground && enemy.has_flag(server::flag::kOnGround) &&
         std::abs(enemy[field::kOrigin].z + enemy[field::kMins].z - self.origin.z + 24) <
             kShockWaveHeight_units;
}

float Fighter::reach_for_target(const Self& self) {
  float reach = kAxeReach_units;
  for (const int bit : kTargetWeapons)
    for (const Weapon& weapon : kWeapons)
      if (weapon.bit == bit && can_use(self, weapon)) reach = std::max(reach, weapon.farthest);
  return reach;
}

int Fighter::impulse_for_target(const Self& self, float distance) {
  if (distance < 60 && (self.items & 4096) != 0) return self.weapon == 4096 ? 0 : 1;
  for (const int bit : kTargetWeapons)
    for (const Weapon& weapon : kWeapons)
      if (weapon.bit == bit && can_use(self, weapon)) return self.weapon == bit ? 0 : weapon.impulse;
  return self.weapon == 4096 ? 0 : 1;
}

// Returns the enemy with the least value: its distance, plus or minus some units for what makes it less or
// more urgent. A bonus for the current enemy keeps the player from switching back and forth.
std::optional<vm::EntityIndex> Fighter::choose(server::Game& io_game, const Self& self, double now_s) {
  server::GameWorld& world = io_game.world();
  std::optional<vm::EntityIndex> best;
  float best_value = 1e9f;
  for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (world.edicts.is_free(entity)) continue;
    const server::Edict edict = world.edicts[entity];
    if (!is_foe(io_game, self, edict)) continue;
    if (const auto record = enemies_.find(i);
        record != enemies_.end() && record->second.ignored_until_s > now_s)
      continue;
    const math::Vec3 at = middle(edict);
    float value = glm::distance(at, self.eye());
    const bool is_awake = world.edicts.is_client(edict[field::kEnemy]) || world.edicts.is_client(entity);
    if (value > (is_awake ? kMaxEnemy_units : kMaxUnawareEnemy_units)) continue;
    if (!can_see(world, self.entity, self.eye(), at)) continue;
    if (edict.has_flag(server::flag::kSwim) && self.water_level == 0) continue;  // stays in its water
    if (!is_awake) value += 300;
    if (enemy_ == entity) value -= 120;
    if (value >= best_value) continue;
    best_value = value;
    best = entity;
  }
  return best;
}

// Away from explosive boxes if there are any, otherwise around the enemy. Changes sides at random and at
// obstacles. Each direction is probed first, so that the player does not step off an edge; 0 if no direction
// is safe.
math::Vec3 Fighter::choose_velocity(server::Game& io_game, const Self& self, const math::Vec3& enemy,
                                    bool is_melee, double now_s) {
  if (now_s > side_until_s_) {
    side_ = dice_->unit() < 0.5f ? -1.0f : 1.0f;
    side_until_s_ = now_s + dice_->between(0.5f, 1.4f);
  }
  const math::Vec3 offset = enemy - self.origin;
  const float distance = glm::length(math::Vec2(offset));
  const math::Vec3 ahead =
      distance > 1 ? math::Vec3(offset.x / distance, offset.y / distance, 0) : math::Vec3(1, 0, 0);
  if (const math::Vec3 away = away_from_explosives(io_game, self); away != math::Vec3(0.0f))
    for (const float angle : {0.0f, 0.7f, -0.7f, 1.4f, -1.4f}) {
      const math::Vec3 direction = turned(glm::normalize(away), angle);
      if (can_walk(io_game.world(), self.entity, self.origin, self.origin + direction * kProbe_units))
        return direction * kStrafeSpeed;
    }
  // Strafe: an angle of 1.5 (radians) circles the enemy, more moves away from it, less moves closer.
  float lean = 1.5f;
  if (distance < (is_melee ? 260 : kTooClose_units)) lean = 2.4f;
  if (distance > kFarForShot_units) lean = 0.9f;
  for (const float side : {side_, -side_})
    for (const float angle : {lean, 1.5f, 2.8f, 0.8f}) {
      const math::Vec3 direction = turned(ahead, angle * side);
      if (!can_walk(io_game.world(), self.entity, self.origin, self.origin + direction * kProbe_units))
        continue;
      if (side != side_) {
        side_ = side;
        side_until_s_ = now_s + dice_->between(0.5f, 1.2f);
      }
      return direction * kStrafeSpeed;
    }
  return math::Vec3(0.0f);
}

// Measures the velocity over a fifth of a second, because monsters move in steps of a tenth.
void Fighter::update_velocity(const math::Vec3& at, double now_s, EnemyRecord& io_record) {
  const double passed_s = now_s - io_record.seen_s;
  if (passed_s < kMotion_s) return;
  io_record.velocity =
      passed_s < 3 * kMotion_s ? (at - io_record.seen_at) / static_cast<float>(passed_s) : math::Vec3(0.0f);
  io_record.seen_at = at;
  io_record.seen_s = now_s;
}

std::optional<FightPlan> Fighter::fight(server::Game& io_game, const Self& self, double now_s) {
  server::GameWorld& world = io_game.world();
  if (now_s - chosen_s_ > kChooseEvery_s) {
    chosen_s_ = now_s;
    enemy_ = choose(io_game, self, now_s);
  }
  if (!enemy_ || !server::is_there(world, *enemy_)) return std::nullopt;
  const server::Edict edict = world.edicts[*enemy_];
  if (edict[field::kHealth] <= 0) {
    enemy_.reset();
    return std::nullopt;
  }
  // After a while without a hit: ignore an enemy that has not lost health, or start over with one that has. A
  // fight that began long ago belongs to an earlier meeting, so it starts over, too.
  EnemyRecord& record = enemies_[static_cast<std::uint32_t>(*enemy_)];
  if (now_s - record.hit_s > kMaxWithoutHit_s && now_s - record.since_s > kMaxWithoutHit_s &&
      record.since_s > 0) {
    if (record.health <= edict[field::kHealth] && now_s - record.since_s < 3 * kMaxWithoutHit_s) {
      record = EnemyRecord();
      record.ignored_until_s = now_s + kIgnore_s;
      enemy_.reset();
      return std::nullopt;
    }
    record.since_s = 0;
  }
  if (record.since_s == 0) record.since_s = record.hit_s = now_s;
  if (edict[field::kHealth] < record.health) record.hit_s = now_s;
  record.health = edict[field::kHealth];
  update_velocity(edict[field::kOrigin], now_s, record);

  const std::string name = class_name(io_game, *enemy_);
  FightPlan plan{.enemy = *enemy_};
  plan.aim_at = middle(edict);
  const float distance = glm::distance(plan.aim_at, self.eye());
  // Zombies die only in explosions; without an explosive weapon, shoot them down and walk past.
  plan.stands_ground = (name != "monster_zombie" || has_bursting_weapon(self)) && self.water_level == 0 &&
                       (has_gun(self) || distance < kAxeFight_units);
  const Weapon& wanted =
      choose_weapon(self, distance, name == "monster_zombie", can_roll(self, edict, now_s));
  if (wanted.bit != self.weapon && now_s - changed_weapon_s_ > kWeaponPause_s) {
    plan.impulse = wanted.impulse;
    changed_weapon_s_ = now_s;
  }
  const Weapon& weapon = in_hand(self);
  if (weapon.missile_speed > 0) {
    // Lead the target. Grenades (16) drop, so aim higher; rockets (32) explode on the floor beside a missed
    // enemy, so aim at its feet.
    const float flight_s = distance / weapon.missile_speed;
    plan.aim_at += math::Vec3(record.velocity.x, record.velocity.y, 0) * flight_s;
    if (weapon.bit == 16) plan.aim_at.z += distance * 0.12f;
    if (weapon.bit == 32 && distance > 250) plan.aim_at.z -= 16;
  }
  // The target's half width, about 14 units, as an angle.
  plan.tolerance_deg = std::max(1.5f, std::atan2(14.0f, distance) * 57.3f);
  const bool is_axe = weapon.bit == 4096;
  plan.fires = distance < (is_axe ? 80.0f : weapon.farthest + 60) && !(weapon.bursts && distance < 120) &&
               can_see(world, self.entity, self.eye(), plan.aim_at) &&
               is_shot_safe(io_game, self, plan.aim_at);
  // With the axe, run straight at the enemy, unless the way there is not safe.
  if (is_axe) {
    const math::Vec3 offset = plan.aim_at - self.origin;
    const float level = std::max(glm::length(math::Vec2(offset)), 1.0f);
    plan.velocity = distance > 60 ? math::Vec3(offset.x, offset.y, 0) * (400 / level) : math::Vec3(0.0f);
    if (!can_walk(world, self.entity, self.origin,
                  self.origin + math::Vec3(offset.x, offset.y, 0) * (std::min(level, 48.0f) / level)))
      plan.velocity = math::Vec3(0.0f);
  } else {
    plan.velocity = choose_velocity(io_game, self, plan.aim_at, is_melee_class(name), now_s);
  }
  return plan;
}

}  // namespace temblor::player
