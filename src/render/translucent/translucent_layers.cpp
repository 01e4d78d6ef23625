#include "render/translucent/translucent_layers.h"

#include <algorithm>

#include "world/visibility.h"

namespace temblor::render {

namespace {

bool is_translucent(float alpha) {
  return alpha > 0 && alpha < 1;
}

bool is_behind(const TranslucentLayer& a, const TranslucentLayer& b) {
  if (a.key != b.key) return a.key > b.key;
  if (a.depth != b.depth) return a.depth < b.depth;
  if (a.kind != b.kind) return a.kind < b.kind;
  return a.number < b.number;
}

}  // namespace

std::span<const TranslucentLayer> sort_translucent(const Scene& scene, const ViewFrame& view,
                                                   const VisibleFaces& visible,
                                                   std::span<const DeferredFace> faces, base::Arena& arena) {
  using Kind = TranslucentLayer::Kind;
  base::ArenaVector<TranslucentLayer> layers(arena, faces.size() + 16);
  for (std::uint32_t i = 0; i < faces.size(); ++i)
    layers.push_back({faces[i].key, faces[i].depth, Kind::kFace, i});
  const auto add = [&](Kind kind, std::uint32_t number, const math::Vec3& origin) {
    const SortKey key = visible.leaf_keys[base::to_size(world::find_leaf(*scene.level, origin))];
    const double z = view.to_view(math::Vec3d(origin)).z;
    layers.push_back({key, view.depth(std::max(z, view.near_z)), kind, number});
  };
  for (std::uint32_t i = 0; i < scene.alias_models.size(); ++i)
    if (is_translucent(scene.alias_models[i].alpha)) add(Kind::kAlias, i, scene.alias_models[i].origin_world);
  for (std::uint32_t i = 0; i < scene.sprites.size(); ++i)
    if (is_translucent(scene.sprites[i].alpha)) add(Kind::kSprite, i, scene.sprites[i].origin_world);
  std::sort(layers.begin(), layers.end(), is_behind);
  if (scene.view_weapon != nullptr && is_translucent(scene.view_weapon->alpha))
    layers.push_back({kNotVisited, 0, Kind::kViewWeapon, 0});
  return layers.view();
}

std::size_t leading_faces(std::span<const TranslucentLayer> layers) {
  const auto other = std::ranges::find_if(
      layers, [](const TranslucentLayer& layer) { return layer.kind != TranslucentLayer::Kind::kFace; });
  return static_cast<std::size_t>(other - layers.begin());
}

}  // namespace temblor::render
