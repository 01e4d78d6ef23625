#include "client/debris/shots.h"

#include "client/effects/effect_random.h"

namespace temblor::client {

namespace {

// Stock frames of progs/player.mdl.
constexpr std::uint16_t kNailFrames[] = {103, 104}, kRocketFrames[] = {107, 112}, kShotFrames[] = {113, 118};

bool is_between(std::uint16_t frame, const std::uint16_t (&ends)[2]) {
  return ends[0] <= frame && frame <= ends[1];
}

}  // namespace

Gun find_gun_in_hand(std::string_view model_name) {
  if (model_name == "progs/v_shot.mdl") return Gun::kShotgun;
  if (model_name == "progs/v_shot2.mdl") return Gun::kSuperShotgun;
  if (model_name == "progs/v_nail.mdl" || model_name == "progs/v_nail2.mdl") return Gun::kNailgun;
  if (model_name == "progs/v_rock.mdl" || model_name == "progs/v_rock2.mdl") return Gun::kLauncher;
  return Gun::kNone;
}

Gun find_gun_of_body(std::string_view model_name, std::uint16_t frame) {
  if (model_name == "progs/soldier.mdl") return Gun::kShotgun;
  if (model_name != "progs/player.mdl") return Gun::kNone;
  if (is_between(frame, kNailFrames)) return Gun::kNailgun;
  if (is_between(frame, kRocketFrames)) return Gun::kLauncher;
  return is_between(frame, kShotFrames) ? Gun::kShotgun : Gun::kNone;
}

HeldGun place_gun_of_body(Gun gun, const math::Vec3& origin_world, const math::Vec3& angles_deg) {
  HeldGun held{.gun = gun, .axes = math::basis_from_angles(angles_deg)};
  const math::Vec3 chest = origin_world + math::Vec3(0, 0, 8);
  held.muzzle_world = chest + math::Vec3(held.axes.forward * 28.0 + held.axes.right * 5.0);
  held.breech_world = chest + math::Vec3(held.axes.forward * 14.0 + held.axes.right * 7.0);
  return held;
}

// To the right and up, out of the shooter's view.
void eject_casings(const world::Level& level, const Shot& shot, Casings& io_casings) {
  const Gun gun = shot.held.gun;
  if (gun == Gun::kNone || gun == Gun::kLauncher) return;
  const int count = gun == Gun::kSuperShotgun ? 2 : 1;
  EffectRandom random(shot.seed);
  const math::Vec3 right(shot.held.axes.right), up(shot.held.axes.up), forward(shot.held.axes.forward);
  for (int i = 0; i < count; ++i) {
    const math::Vec3 velocity =
        right * random.uniform(60, 110) + up * random.uniform(90, 150) + forward * random.uniform(-25, 15);
    io_casings.throw_casing(level, {gun == Gun::kNailgun ? CasingModel::kBrass : CasingModel::kShell,
                                    shot.held.breech_world, shot.velocity + velocity, shot.time_s,
                                    base::hash_with(shot.seed, static_cast<std::uint64_t>(i))});
  }
}

// Nails leave little smoke, as they are fast.
void smoke_barrel(const Shot& shot, Puffs& io_puffs) {
  if (shot.held.gun == Gun::kNone) return;
  const bool is_thin = shot.held.gun == Gun::kNailgun;
  EffectRandom random(base::hash_with(shot.seed, 1));
  for (int i = 0; i < (is_thin ? 1 : 4); ++i) {
    PuffSpawn puff{.picture = PuffPicture::kSmoke, .origin_world = shot.held.muzzle_world};
    puff.velocity = shot.velocity + math::Vec3(shot.held.axes.forward) * random.uniform(20, 110) +
                    random.uniform_in_cube(10);
    puff.rise = random.uniform(6, 14);
    puff.born_s = shot.time_s;
    puff.life_s = double{random.uniform(0.5f, 1.0f)};
    puff.first_scale = 0.06f;
    puff.last_scale = is_thin ? 0.2f : random.uniform(0.2f, 0.4f);
    puff.opacity = is_thin ? 0.25f : 0.4f;
    io_puffs.add(puff);
  }
}

void smoke_blast(const math::Vec3& origin_world, double time_s, std::uint64_t seed, Puffs& io_puffs) {
  EffectRandom random(seed);
  for (int i = 0; i < 6; ++i) {
    PuffSpawn puff{.picture = PuffPicture::kSmoke, .origin_world = origin_world};
    puff.velocity = random.uniform_in_cube(90);
    puff.rise = random.uniform(12, 28);
    puff.born_s = time_s + 0.2;
    puff.life_s = double{random.uniform(1.2f, 2.2f)};
    puff.first_scale = 0.5f;
    puff.last_scale = random.uniform(1.1f, 1.8f);
    puff.opacity = 0.5f;
    io_puffs.add(puff);
  }
}

}  // namespace temblor::client
