// What to draw: everything a frame depends on, given from outside. The renderer keeps nothing of it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "formats/images/image.h"
#include "formats/models/spr.h"
#include "math/vec.h"
#include "render/alias_model.h"
#include "render/marks.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::render {

enum class Projection { kPerspective, kOrthographic };

struct Camera {
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch (down positive), yaw, roll
  // Horizontal field of view of a 4:3 picture, 10 to 170. Wider pictures see more at the sides, narrower ones
  // more above and below.
  float fov_deg = 90;
  Projection projection = Projection::kPerspective;
  float units_per_pixel = 0;  // orthographic only; 0: the level fits the picture
};

// A door, a lift, a button: one of the level's brush models at a place of its own.
struct BrushModelInstance {
  world::ModelIndex model{};
  math::Vec3 origin_world{0.0f};  // where the model's own origin (0,0,0) has moved to
  math::Vec3 angles_deg{0.0f};
  int frame = 0;    // not 0: alternate texture animation
  float alpha = 1;  // 0 to 1
};

struct PlayerColors {
  std::uint8_t shirt = 0, pants = 0;  // rows of the palette, 0 to 15
};

struct AliasInstance {
  const AliasModel* model = nullptr;
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch is positive upwards here, as the game has it for these models
  float scale = 1;
  PoseIndex from_pose{}, to_pose{};
  float blend = 0;         // 0: from_pose, 1: to_pose
  std::uint32_t skin = 0;  // skin_at()
  std::optional<PlayerColors> colors{};
  float alpha = 1;      // 0 to 1
  float min_light = 0;  // 0 to 255
  bool full_bright = false;
};

struct SpriteInstance {
  const formats::Spr* sprite = nullptr;
  const formats::SprPicture* picture = nullptr;  // of the sprite
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // kOriented; roll of kParallelOriented
  float scale = 1;
  float alpha = 1;
};

// Squares that face the eye. Four arrays of equal length.
struct ParticleCloud {
  std::span<const float> x, y, z;  // world
  std::span<const std::uint8_t> color;
  std::size_t size() const { return x.size(); }
};

// Light that is not in the light maps. At distance d, radius - d is added to the light of samples (0 to 255,
// like theirs) that are nearer than radius - least.
struct DynamicLight {
  math::Vec3 origin_world{0.0f};
  float radius = 0;        // units; not positive: no light
  float least = 0;         // light below this is left out
  math::Vec3 color{1.0f};  // factors, rgb only
};

// All that may fall on a lit face, but for what is in the level.
struct SceneLight {
  std::span<const DynamicLight> lights{};
  world::LightStyleValues light_styles = world::light_as_stored();
};

struct Fog {
  float density = 0;       // 0: none. Light is scaled by exp(-(density * z / 64)^2)
  math::Vec3 color{0.0f};  // 0 to 1
};

// Tells skyboxes apart, as LevelIdentity does levels.
struct SkyboxIdentity {};

// Six true-color pictures in place of the sky's texture. Sides do not change once it has been drawn: whoever
// wants others makes another skybox.
struct Skybox {
  // By the names of their files right (+x), back (+y), left (-x), front (-y), up (its lower edge at the right
  // side's upper one), down (its upper edge at the right side's lower one); seen from inside. Empty ones show
  // the fog's color or black.
  std::array<formats::Image, 6> sides;
  std::shared_ptr<const SkyboxIdentity> identity = std::make_shared<const SkyboxIdentity>();
};

// Color laid over the finished view.
struct Tint {
  math::Vec3 color{0.0f};  // 0 to 255
  float opacity = 0;       // 0 to 1
};

// Opacities of liquids by kind, 0 to 1.
struct LiquidAlpha {
  float water = 1, slime = 1, lava = 1, teleport = 1;
};

struct Scene {
  const world::Level* level = nullptr;
  Camera camera{};
  std::span<const BrushModelInstance> brush_models{};
  std::span<const AliasInstance> alias_models{};
  // Drawn over all other models, with a field of view of its own; nothing pokes into it. Space: the view's,
  // origin_world and angles_deg are in the world all the same.
  const AliasInstance* view_weapon = nullptr;
  std::span<const SpriteInstance> sprites{};
  ParticleCloud particles{};
  std::span<const DynamicLight> lights{};
  const MarkSet* marks = nullptr;  // null: none
  const Skybox* skybox = nullptr;  // null: the sky's texture
  Fog fog{};
  LiquidAlpha liquid_alpha{};
  bool underwater = false;  // the whole view sways
  Tint tint{};
  double time_s = 0;
  world::LightStyleValues light_styles = world::light_as_stored();
  // For Settings::relight_alternate: this frame's number, and the light of the frame before it. Null: there
  // was none, and every face shows today's light.
  std::uint32_t frame_number = 0;
  const SceneLight* light_before = nullptr;
};

inline bool has_marks(const Scene& scene) {
  return scene.marks != nullptr && scene.marks->size() > 0;
}

}  // namespace temblor::render
