#include "world/spawn_rules.h"

namespace temblor::world {
namespace {

// Bits of spawnflags. Nightmare uses that of hard.
constexpr int kNotEasy = 256, kNotMedium = 512, kNotHard = 1024, kNotDeathmatch = 2048;

}  // namespace

bool is_excluded(int spawn_flags, const SpawnRules& rules) {
  if (rules.deathmatch) return (spawn_flags & kNotDeathmatch) != 0;
  const int flag = rules.skill <= 0 ? kNotEasy : rules.skill == 1 ? kNotMedium : kNotHard;
  return (spawn_flags & flag) != 0;
}

int spawn_flags(const formats::Entity& entity) {
  const float flags = entity.find_number("spawnflags").value_or(0);
  constexpr float kMax = 1 << 24;  // all whole numbers up to here are floats
  return flags >= 0 && flags <= kMax ? static_cast<int>(flags) : 0;
}

bool is_excluded(const formats::Entity& entity, const SpawnRules& rules) {
  return is_excluded(spawn_flags(entity), rules);
}

}  // namespace temblor::world
