#include "client/view/scene_choices.h"

#include <gtest/gtest.h>

#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"
#include "world/visibility.h"

namespace temblor::client {
namespace {

const world::Level& small() {
  static const auto small = test::small_level().level;
  return *small;
}

// Any player in any place: the camera is in the open, within its distance, and the player's target is in the
// middle of the picture.
TEST(ChaseCamera, StaysInTheOpenAndLooksAtTheTarget) {
  int moved = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    PlayerView view;
    view.camera = test::random_camera(small(), random);
    view.camera.angles_deg.x = glm::clamp(view.camera.angles_deg.x, -70.0f, 70.0f);
    const render::Camera eyes = view.camera;
    chase_player(small(), {}, view);
    if (view.camera.origin_world == eyes.origin_world) continue;
    ++moved;
    EXPECT_FALSE(view.show_weapon);
    const auto contents = world::point_contents(small(), view.camera.origin_world);
    EXPECT_TRUE(contents != world::Contents::kSolid) << seed;
    EXPECT_LE(glm::distance(view.camera.origin_world, eyes.origin_world), 116.1f) << seed;
    EXPECT_EQ(view.camera.angles_deg.y, eyes.angles_deg.y);
    EXPECT_EQ(view.camera.angles_deg.z, 0);
  }
  EXPECT_GT(moved, 300);
}

TEST(SceneChoices, RemoveWhatIsNotWanted) {
  const float places[1] = {0};
  const std::uint8_t colors[1] = {1};
  const render::DynamicLight light;
  const render::AliasInstance monster;
  const render::BrushModelInstance door;
  const auto make_scene = [&] {
    render::Scene scene;
    scene.alias_models = {&monster, 1};
    scene.brush_models = {&door, 1};
    scene.view_weapon = &monster;
    scene.particles = {places, places, places, colors};
    scene.lights = {&light, 1};
    scene.underwater = true;
    return scene;
  };
  command::Variables variables;
  const SceneChoiceVariables choices(variables);
  render::Scene scene = make_scene();
  apply_choices(choices.read(variables), scene);
  EXPECT_EQ(scene.alias_models.size(), 1u);
  EXPECT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.particles.size(), 1u);
  EXPECT_TRUE(scene.underwater);
  for (const char* name : {"r_drawentities", "r_particles", "r_dynamic", "r_waterwarp"})
    ASSERT_TRUE(variables.set(name, "0").ok());
  apply_choices(choices.read(variables), scene);
  EXPECT_TRUE(scene.alias_models.empty() && scene.brush_models.empty() && scene.view_weapon == nullptr);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.particles.size(), 0u);
  EXPECT_FALSE(scene.underwater);
}

TEST(SceneChoices, Md5ModelsByVariable) {
  command::Variables variables;
  const SceneChoiceVariables choices(variables);
  EXPECT_TRUE(choices.read(variables).md5_models);
  ASSERT_TRUE(variables.set("r_md5", "0").ok());
  EXPECT_FALSE(choices.read(variables).md5_models);
}

TEST(SceneChoices, ChaseOnlyIfActive) {
  command::Variables variables;
  const SceneChoiceVariables choices(variables);
  EXPECT_FALSE(choices.read(variables).chase);
  ASSERT_TRUE(variables.set("chase_active", "1").ok());
  ASSERT_TRUE(variables.set("chase_back", "64").ok());
  EXPECT_EQ(choices.read(variables).chase->back, 64);
}

}  // namespace
}  // namespace temblor::client
