// Signs that a gun was fired, beside its flash: a casing flies out of the breech, smoke leaves the barrel.
// Messages do not name guns, so the model in the hand or the shooter's body decides, by its stock name.
#pragma once

#include <cstdint>
#include <string_view>

#include "client/debris/casings.h"
#include "client/debris/puffs.h"
#include "math/angles.h"
#include "world/level.h"

namespace temblor::client {

enum class Gun : std::uint8_t {
  kNone,  // nothing that smokes: the axe, lightning
  kShotgun,
  kSuperShotgun,
  kNailgun,
  kLauncher  // of grenades and rockets: smoke, but no casing
};

// The gun of a view model, such as progs/v_shot.mdl.
Gun find_gun_in_hand(std::string_view model_name);
// The gun of a body that shoots: a soldier, or a player by the frame that shows the shot.
Gun find_gun_of_body(std::string_view model_name, std::uint16_t frame);

// The gun in the player's hand, where the picture shows it.
struct HeldGun {
  Gun gun{};
  math::Vec3 muzzle_world{0.0f}, breech_world{0.0f};
  math::Basis axes;
};

// A shot. `velocity` is the shooter's, units per second.
struct Shot {
  HeldGun held;
  math::Vec3 velocity{0.0f};
  double time_s = 0;
  std::uint64_t seed = 0;
};

// The gun of a body: in front of it, at the height of its chest.
HeldGun place_gun_of_body(Gun gun, const math::Vec3& origin_world, const math::Vec3& angles_deg);

void eject_casings(const world::Level& level, const Shot& shot, Casings& io_casings);
void smoke_barrel(const Shot& shot, Puffs& io_puffs);
// Smoke that stays where a missile burst, after its fire.
void smoke_blast(const math::Vec3& origin_world, double time_s, std::uint64_t seed, Puffs& io_puffs);

}  // namespace temblor::client
