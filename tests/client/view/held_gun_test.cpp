// Where effects see the barrel, against a projection written here.
#include "client/view/held_gun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/session/placeholder_model.h"
#include "formats/models/mdl.h"
#include "support/programs/small_game.h"

namespace temblor::client {
namespace {

class HeldGunTest : public ::testing::Test {
 protected:
  void SetUp() override {
    files_.folder().write("id1/progs/v_shot.mdl", formats::write_mdl(make_placeholder_model()));
    game_.models = {"", "maps/small.bsp", "progs/v_shot.mdl"};
    game_.stats[static_cast<std::size_t>(Stat::kWeaponModel)] = 2;
    view_.camera.origin_world = {10, 20, 30};
    view_.camera.angles_deg = {-3, 40, 1};
    view_.weapon_origin_world = {11, 20, 28};
    view_.weapon_angles_deg = {2, 41, 0};
  }
  ModelTable load() {
    const assets::Library library(vfs::FileSystem::open(files_.path()).value());
    return ModelTable::load(library, game_.models, {}, notes_).value();
  }

  test::SmallGame files_;
  std::vector<std::string> notes_;
  Game game_;
  PlayerView view_;
};

// The place in the picture, in halves of its width, from straight ahead: to the right, up.
math::Vec2d project(const render::Camera& camera, const math::Vec3d& point, double fov_deg) {
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  const math::Vec3d away = point - math::Vec3d(camera.origin_world);
  const double scale = glm::dot(away, axes.forward) * std::tan(fov_deg / 2 * std::numbers::pi / 180);
  return {glm::dot(away, axes.right) / scale, glm::dot(away, axes.up) / scale};
}

// The weapon is drawn with 90 degrees, the world with the camera's field of view.
TEST_F(HeldGunTest, TheBarrelIsAtTheSamePixelWithAnyFieldOfView) {
  const ModelTable models = load();
  // The foremost points of the file itself.
  const formats::Mdl mdl = make_placeholder_model();
  std::vector<math::Vec3d> points;
  for (const auto& vertex : mdl.frames.at(0).poses.at(0).vertices)
    points.emplace_back(math::Vec3(vertex.position[0], vertex.position[1], vertex.position[2]) * mdl.scale +
                        mdl.origin);
  const double front = std::max_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
                         return a.x < b.x;
                       })->x;
  std::erase_if(points, [&](const math::Vec3d& point) { return point.x < front - 1; });
  math::Vec3d tip(0.0);
  for (const math::Vec3d& point : points) tip += point / static_cast<double>(points.size());

  const math::Basis hand = math::basis_from_angles({-2, 41, 0});
  const math::Vec3d drawn =
      math::Vec3d(view_.weapon_origin_world) + hand.forward * tip.x - hand.right * tip.y + hand.up * tip.z;
  for (const float fov_deg : {60.0f, 90.0f, 120.0f}) {
    view_.camera.fov_deg = fov_deg;
    const std::optional<HeldGun> held = find_held_gun(game_, models, view_, 90, false);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->gun, Gun::kShotgun);
    const math::Vec2d shown = project(view_.camera, math::Vec3d(held->muzzle_world), double{fov_deg});
    const math::Vec2d expected = project(view_.camera, drawn, 90);
    EXPECT_NEAR(shown.x, expected.x, 1e-4);
    EXPECT_NEAR(shown.y, expected.y, 1e-4);
  }
}

TEST_F(HeldGunTest, NoGunIsHeldThatIsNotDrawn) {
  const ModelTable models = load();
  EXPECT_TRUE(find_held_gun(game_, models, view_, 90, false));
  view_.show_weapon = false;
  EXPECT_FALSE(find_held_gun(game_, models, view_, 90, false));
  view_.show_weapon = true;
  for (const std::int32_t number : {0, -1, 1, 77}) {
    game_.stats[static_cast<std::size_t>(Stat::kWeaponModel)] = number;
    EXPECT_FALSE(find_held_gun(game_, models, view_, 90, false)) << number;
  }
}

}  // namespace
}  // namespace temblor::client
