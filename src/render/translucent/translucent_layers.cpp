#include "render/translucent/translucent_layers.h"

#include <algorithm>

#include "world/visibility.h"

namespace temblor::render {

namespace {

bool is_translucent(float alpha) {
  return alpha > 0 && alpha < 1;
}

// A total order, so that pixels do not depend on the sorting algorithm.
bool is_behind(const TranslucentLayer& a, const TranslucentLayer& b) {
  if (a.key != b.key) return a.key > b.key;
  if (a.depth != b.depth) return a.depth < b.depth;
  if (a.kind != b.kind) return a.kind < b.kind;
  return a.number < b.number;
}

}  // namespace

TranslucentOrder sort_translucent(const FrameContext& context, const WorldPicture& world,
                                  const VisibleFaces& visible) {
  using Kind = TranslucentLayer::Kind;
  const Scene& scene = context.scene;
  const ViewFrame& view = world.view;
  const DeferredFaces sorted = sort_deferred_faces(context, world, visible);
  const std::span<const DeferredFace> faces = sorted.translucent;
  base::ArenaVector<TranslucentLayer> layers(context.arena(), faces.size() + 16);
  for (std::uint32_t i = 0; i < faces.size(); ++i)
    layers.push_back({faces[i].key, faces[i].depth, Kind::kFace, i});
  const auto add = [&](Kind kind, std::size_t number, const math::Vec3& origin) {
    const SortKey key = visible.leaf_keys[base::to_size(world::find_leaf(*scene.level, origin))];
    const double z = view.to_view(math::Vec3d(origin)).z;
    layers.push_back({key, view.depth(std::max(z, view.near_z)), kind, static_cast<std::uint32_t>(number)});
  };
  base::ArenaVector<SpriteQuad> quads(context.arena(), scene.sprites.size());
  if (world.sources.fill_depth) {
    for (std::size_t i = 0; i < scene.alias_models.size(); ++i)
      if (is_translucent(scene.alias_models[i].alpha))
        add(Kind::kAlias, i, scene.alias_models[i].origin_world);
    for (const SpriteInstance& sprite : scene.sprites) {
      if (!is_translucent(sprite.alpha)) continue;
      const std::optional<SpriteQuad> quad = make_sprite_quad(view, sprite);
      if (!quad) continue;
      add(Kind::kSprite, quads.size(), sprite.origin_world);
      quads.push_back(*quad);
    }
  }
  std::sort(layers.begin(), layers.end(), is_behind);
  if (world.sources.fill_depth && scene.view_weapon != nullptr && is_translucent(scene.view_weapon->alpha))
    layers.push_back({kNotVisited, 0, Kind::kViewWeapon, 0});
  return {sorted, quads.view(), layers.view(), count_banded_layers(layers.view())};
}

std::size_t count_banded_layers(std::span<const TranslucentLayer> layers) {
  using Kind = TranslucentLayer::Kind;
  const auto model = std::ranges::find_if(layers, [](const TranslucentLayer& layer) {
    return layer.kind == Kind::kAlias || layer.kind == Kind::kViewWeapon;
  });
  return static_cast<std::size_t>(model - layers.begin());
}

}  // namespace temblor::render
