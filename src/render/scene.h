// Everything that a frame depends on, passed in by the caller. The renderer keeps no reference to it after
// the frame, so the caller owns all memory that the spans and pointers refer to.
//
// Space: world units, x forward, y left, z up at zero angles. Angles are in degrees: pitch, yaw, roll.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "formats/images/image.h"
#include "formats/images/palette.h"
#include "formats/models/spr.h"
#include "math/vec.h"
#include "render/alias_model.h"
#include "render/marks.h"
#include "render/tint.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::render {

enum class Projection { kPerspective, kOrthographic };

struct Camera {
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch (down positive), yaw, roll
  // Horizontal field of view of a 4:3 picture, clamped to 10 to 170. Wider pictures show more at the sides,
  // narrower ones show more above and below.
  float fov_deg = 90;
  Projection projection = Projection::kPerspective;
  float units_per_pixel = 0;  // orthographic only; 0: the level fits the picture
};

// A brush model (a door, lift, or button) with a position and rotation of its own.
struct BrushModelInstance {
  world::ModelIndex model{};
  // Where the model's own origin (0, 0, 0) is now. Brush models are compiled in world space, so a mover that
  // has not moved has 0 here.
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};
  // Not 0: animated textures show their alternate sequence, as a pressed button does.
  int frame = 0;
  float alpha = 1;  // 0 to 1
  // Adds the model's colors times alpha to the picture, instead of blending them.
  bool is_additive = false;
  // Shown instead of the textures and their light; holes stay.
  std::optional<formats::Rgb> color{};
};

// A player's own colors, which replace the skin's shirt and pants colors.
struct PlayerColors {
  std::uint8_t shirt = 0, pants = 0;  // rows of the palette, 0 to 15
};

// An alias model (monster, item, projectile) with a position and an animation state.
struct AliasInstance {
  const AliasModel* model = nullptr;
  math::Vec3 origin_world{0.0f};
  // Pitch is positive upward here, unlike everywhere else: game code uses this sign for alias models.
  math::Vec3 angles_deg{0.0f};
  float scale = 1;
  // From pose_at(). The drawn pose is from_pose * (1 - blend) + to_pose * blend. Stock Quake does not
  // interpolate.
  PoseIndex from_pose{}, to_pose{};
  // 0 to 1.
  float blend = 0;
  // From skin_at().
  std::uint32_t skin = 0;
  std::optional<PlayerColors> colors{};
  float alpha = 1;  // 0 to 1
  // 0 to 255: the least light that the model is drawn with, so that pickups and players stay visible in the
  // dark.
  float min_light = 0;
  bool full_bright = false;
};

// A flat picture (SPR file) at a point: explosions, bubbles, torches of some mods.
struct SpriteInstance {
  const formats::Spr* sprite = nullptr;
  // The frame of `sprite` to draw.
  const formats::SprPicture* picture = nullptr;
  math::Vec3 origin_world{0.0f};
  // Used by sprites of orientation kOriented; kParallelOriented uses only the roll.
  math::Vec3 angles_deg{0.0f};
  float scale = 1;
  float alpha = 1;
};

// Small squares that face the eye, as four arrays of equal length (CHECKed): positions, and palette indices.
struct ParticleCloud {
  std::span<const float> x, y, z;  // world
  std::span<const std::uint8_t> color;
  std::size_t size() const { return x.size(); }
};

// Light that is not in the light maps, such as a muzzle flash. Light is 0 to 255, like light map samples. At
// distance d from the light, `radius - d` is added to each sample that is nearer than `radius - least`.
struct DynamicLight {
  math::Vec3 origin_world{0.0f};
  // Units, and also the light at distance 0. Not positive: no light.
  float radius = 0;
  // Light below this is omitted, which shrinks the area that must be rebuilt.
  float least = 0;
  // Factors for red, green, and blue.
  math::Vec3 color{1.0f};
};

// All light that changes from frame to frame. Light maps and faces are part of the level.
struct SceneLight {
  std::span<const DynamicLight> lights{};
  world::LightStyleValues light_styles = world::make_stored_light_styles();
};

struct Fog {
  float density = 0;       // 0: none. Light is scaled by exp(-(density * z / 64)^2)
  math::Vec3 color{0.0f};  // 0 to 1
};

// An object whose address tells skyboxes apart, as LevelIdentity does for levels.
struct SkyboxIdentity {};

// Six true-color pictures that replace the sky's texture. The renderer caches a converted copy by `identity`,
// so the sides must not change after the skybox was drawn: to change them, make another skybox.
struct Skybox {
  // In the order of the file names' suffixes, seen from inside the cube: right (+x), back (+y), left (-x),
  // front (-y), up (its lower edge touches the right side's upper edge), down (its upper edge touches the
  // right side's lower edge). Empty sides show the fog's color, or black.
  std::array<formats::Image, 6> sides;
  std::shared_ptr<const SkyboxIdentity> identity = std::make_shared<const SkyboxIdentity>();
};

// A line of one pixel's width over the finished view, for debugging.
struct Line {
  math::Vec3 from_world{0.0f}, to_world{0.0f};
  formats::Rgb color{255, 255, 255};
  bool is_depth_tested = false;  // hidden by opaque faces, models, sprites, and particles in front of it
};

// Opacities of liquids by kind, 0 to 1. Texture names decide the kind (view/face_opacity.h).
struct LiquidAlpha {
  float water = 1, slime = 1, lava = 1, teleport = 1;
};

struct Scene {
  const world::Level* level = nullptr;
  Camera camera{};
  std::span<const BrushModelInstance> brush_models{};
  std::span<const AliasInstance> alias_models{};
  // The view model. Drawn over all other models with a field of view of its own, and never hidden by
  // anything. origin_world and angles_deg are in world space. Null: none.
  const AliasInstance* view_weapon = nullptr;
  // The view model's field of view, as in Camera; 0: the camera's.
  float weapon_fov_deg = 90;
  std::span<const SpriteInstance> sprites{};
  ParticleCloud particles{};
  std::span<const Line> lines{};
  std::span<const DynamicLight> lights{};
  const MarkSet* marks = nullptr;  // null: none
  const Skybox* skybox = nullptr;  // null: the sky's texture
  Fog fog{};
  LiquidAlpha liquid_alpha{};
  // Draws what can be seen from this leaf instead of the eye's; none: the eye's.
  std::optional<world::LeafIndex> pvs_leaf{};
  // True: faces whose front is sky or solid space are left out. From above they would hide the rooms, because
  // some compilers keep the outside of sky brushes.
  bool is_overview = false;
  // True: the finished view is warped.
  bool underwater = false;
  Tint tint{};
  double time_s = 0;
  world::LightStyleValues light_styles = world::make_stored_light_styles();
  // For Settings::relight_alternate: this frame's number, and the light of the previous frame. Null: there
  // was no previous frame, so every face shows the current light.
  std::uint32_t frame_number = 0;
  const SceneLight* light_before = nullptr;
};

inline bool has_marks(const Scene& scene) {
  return scene.marks != nullptr && scene.marks->size() > 0;
}

}  // namespace temblor::render
