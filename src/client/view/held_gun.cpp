#include "client/view/held_gun.h"

#include <cmath>
#include <numbers>

namespace temblor::client {

namespace {

double half_width(float fov_deg) {
  return std::tan(double{fov_deg} / 2 * std::numbers::pi / 180);
}

}  // namespace

std::optional<HeldGun> find_held_gun(const Game& game, const ModelTable& models, const PlayerView& view,
                                     float weapon_fov_deg, bool prefers_md5) {
  // The breech is halfway along the barrel, on its right and upper side. Units.
  constexpr double kBreechShare = 0.5, kBreechRight = 2.5, kBreechUp = 1.5;
  const std::int32_t number = game.stat(Stat::kWeaponModel);
  if (!view.show_weapon || game.ending != Ending::kNone || number <= 0) return std::nullopt;
  const auto index = static_cast<std::size_t>(number);
  const render::AliasModel* model = models.alias_model(index, prefers_md5);
  if (model == nullptr || index >= game.models.size()) return std::nullopt;

  const math::Vec3& angles = view.weapon_angles_deg;
  const math::Basis hand = math::basis_from_angles({-angles.x, angles.y, angles.z});
  const math::Basis eye = math::basis_from_angles(view.camera.angles_deg);
  const double spread =
      weapon_fov_deg > 0 ? half_width(view.camera.fov_deg) / half_width(weapon_fov_deg) : 1.0;
  const auto to_world = [&](const math::Vec3d& point) {
    const math::Vec3d drawn = math::Vec3d(view.weapon_origin_world - view.camera.origin_world) +
                              hand.forward * point.x - hand.right * point.y + hand.up * point.z;
    const math::Vec3d ahead = eye.forward * glm::dot(drawn, eye.forward);
    return view.camera.origin_world + math::Vec3(ahead + (drawn - ahead) * spread);
  };
  const math::Vec3d muzzle(render::find_foremost_point(*model));
  const math::Vec3d breech(muzzle.x * kBreechShare, muzzle.y - kBreechRight, muzzle.z + kBreechUp);
  return HeldGun{find_gun_in_hand(game.models[index]), to_world(muzzle), to_world(breech), hand};
}

}  // namespace temblor::client
