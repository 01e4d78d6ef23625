#include "render/view/face_opacity.h"

#include <string_view>

#include "base/text.h"

namespace temblor::render {

namespace {

// Clamps to 0 to 1; NaN becomes 0.
float bounded(float opacity) {
  return opacity > 0 ? (opacity < 1 ? opacity : 1.0f) : 0.0f;
}

// Texture names tell the kinds apart. Every liquid that is not lava, slime, or a teleporter counts as water.
float liquid_opacity(const LiquidAlpha& alpha, std::string_view texture_name) {
  const auto is = [&](std::string_view kind) {
    return base::equal_ignoring_case(texture_name.substr(0, kind.size()), kind);
  };
  return is("*lava") ? alpha.lava : is("*slime") ? alpha.slime : is("*tele") ? alpha.teleport : alpha.water;
}

}  // namespace

std::span<const FaceOpacity> world_opacities(const Scene& scene, base::Arena& arena) {
  const std::vector<world::Texture>& textures = scene.level->textures;
  const std::span<FaceOpacity> opacities = arena.allocate_filled(textures.size(), FaceOpacity{});
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (textures[i].kind == world::TextureKind::kLiquid)
      opacities[i].opacity = bounded(liquid_opacity(scene.liquid_alpha, textures[i].name));
    opacities[i].has_holes = textures[i].kind == world::TextureKind::kCutout;
  }
  return opacities;
}

FaceOpacity brush_face_opacity(std::span<const FaceOpacity> world_opacities, const world::Level& level,
                               world::TextureIndex texture, const BrushModelInstance& instance) {
  FaceOpacity opacity = world_opacities[base::to_size(texture)];
  if (level.texture(texture).kind == world::TextureKind::kSky) return opacity;
  if (instance.alpha < 1) opacity.opacity = bounded(instance.alpha);
  opacity.is_additive = instance.is_additive;
  opacity.color = instance.color;
  return opacity;
}

}  // namespace temblor::render
