#include "render/translucent/draw_translucent.h"

#include <algorithm>
#include <optional>

#include "render/models/draw_sprites.h"
#include "render/models/draw_translucent_alias.h"
#include "render/translucent/merge_kernels.h"
#include "world/visibility.h"

namespace temblor::render {

namespace {

bool is_translucent(float alpha) {
  return alpha > 0 && alpha < 1;
}

// One of the scene's translucent things, or a late face; faces are numbered as given.
struct Layer {
  enum class Kind : std::uint8_t { kFace, kAlias, kSprite, kViewWeapon };
  SortKey key;
  double depth;  // ViewFrame::depth, among equal keys
  Kind kind;
  std::uint32_t number;

  bool is_behind(const Layer& other) const {
    if (key != other.key) return key > other.key;
    if (depth != other.depth) return depth < other.depth;
    if (kind != other.kind) return kind < other.kind;
    return number < other.number;
  }
};

class Translucent {
 public:
  Translucent(const Scene& scene, const Settings& settings, const LateTarget& target, base::Jobs& jobs,
              base::Arena& arena, std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame)
      : scene_(scene),
        settings_(settings),
        target_(target),
        jobs_(jobs),
        arena_(arena),
        arenas_(io_arenas),
        frame_(io_frame) {}

  // Back to front. What is in no leaf that was visited is taken for nearest.
  std::span<const Layer> sort(std::span<const LateFace> faces, const VisibleFaces& visible) {
    base::ArenaVector<Layer> layers(arena_, faces.size() + 16);
    for (std::uint32_t i = 0; i < faces.size(); ++i)
      layers.push_back({faces[i].key, faces[i].depth, Layer::Kind::kFace, i});
    const auto add = [&](Layer::Kind kind, std::uint32_t number, const math::Vec3& origin) {
      const SortKey key = visible.leaf_keys[base::to_size(world::find_leaf(*scene_.level, origin))];
      const double z = target_.view.to_view(math::Vec3d(origin)).z;
      layers.push_back({key, target_.view.depth(std::max(z, target_.view.near_z)), kind, number});
    };
    for (std::uint32_t i = 0; i < scene_.alias_models.size(); ++i)
      if (is_translucent(scene_.alias_models[i].alpha))
        add(Layer::Kind::kAlias, i, scene_.alias_models[i].origin_world);
    for (std::uint32_t i = 0; i < scene_.sprites.size(); ++i)
      if (is_translucent(scene_.sprites[i].alpha))
        add(Layer::Kind::kSprite, i, scene_.sprites[i].origin_world);
    std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.is_behind(b); });
    if (scene_.view_weapon != nullptr && is_translucent(scene_.view_weapon->alpha))
      layers.push_back({kNotVisited, 0, Layer::Kind::kViewWeapon, 0});
    return layers.view();
  }

  void draw_alias(const AliasInstance& instance, AliasRole role) {
    const std::optional<AliasPicture> picture = draw_alias_alone(
        scene_, settings_, target_.view, instance, role, target_.tables, frame_.format(), arena_);
    if (!picture) return;
    for (int row = 0; row < picture->height; ++row) merge_row(*picture, row, instance.alpha);
  }

  void draw_sprite(const SpriteInstance& sprite) {
    const std::optional<SpriteQuad> quad = make_sprite_quad(target_.view, sprite);
    if (!quad) return;
    const SpriteBlend blend{blend_table(sprite.alpha), opacity_256(sprite.alpha),
                            target_.fog.is_on() ? &target_.fog : nullptr};
    draw_sprite_instance(*quad, blend, target_.tables, settings_.vector_kernels, {0, frame_.height()},
                         frame_);
  }

  void draw_faces(std::span<const LateFace> faces) {
    draw_late_faces(faces, target_, jobs_, arenas_, frame_);
  }

 private:
  // Null: none is needed.
  const std::uint8_t* blend_table(float alpha) const {
    return frame_.format() == PixelFormat::kIndexed ? target_.tables.blends.table_for(alpha) : nullptr;
  }

  void merge_row(const AliasPicture& picture, int number, float alpha) {
    const bool indexed = frame_.format() == PixelFormat::kIndexed;
    const std::size_t first = static_cast<std::size_t>(number) * picture.stride;
    std::byte* const texels = static_cast<std::byte*>(picture.pixels) +
                              first * (indexed ? sizeof(std::uint8_t) : sizeof(std::uint32_t));
    float* const depth = picture.depth + first;
    if (target_.fog.is_on()) target_.fog.apply(texels, {depth, static_cast<std::size_t>(picture.width)});
    const std::size_t pixel =
        static_cast<std::size_t>(picture.y + number) * static_cast<std::size_t>(frame_.width()) +
        static_cast<std::size_t>(picture.x);
    MergeRow row{};
    row.texels = texels;
    row.depth = depth;
    row.pixels = indexed ? static_cast<void*>(frame_.indexed().data() + pixel) : frame_.rgb().data() + pixel;
    row.z = frame_.depth().data() + pixel;
    row.count = picture.width;
    row.nearer = 1;
    row.table = blend_table(alpha);
    row.opacity_256 = opacity_256(alpha);
    if (indexed)
      settings_.vector_kernels ? merge_blend_u8_vector(row) : merge_blend_u8_plain(row);
    else
      settings_.vector_kernels ? merge_blend_u32_vector(row) : merge_blend_u32_plain(row);
  }

  const Scene& scene_;
  const Settings& settings_;
  const LateTarget& target_;
  base::Jobs& jobs_;
  base::Arena& arena_;
  std::vector<base::Arena>& arenas_;
  FrameBuffer& frame_;
};

}  // namespace

void draw_translucent(const Scene& scene, const Settings& settings, const VisibleFaces& visible,
                      std::span<const LateFace> faces, const LateTarget& target, base::Jobs& jobs,
                      base::Arena& arena, std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame) {
  Translucent translucent(scene, settings, target, jobs, arena, io_arenas, io_frame);
  const std::span<const Layer> layers = translucent.sort(faces, visible);
  for (std::size_t i = 0; i < layers.size();) {
    const Layer& layer = layers[i];
    std::size_t next = i + 1;
    switch (layer.kind) {
      case Layer::Kind::kFace:
        // Faces are in this order already: those with nothing between them are drawn together.
        while (next < layers.size() && layers[next].kind == Layer::Kind::kFace) ++next;
        translucent.draw_faces(faces.subspan(layer.number, next - i));
        break;
      case Layer::Kind::kAlias:
        translucent.draw_alias(scene.alias_models[layer.number], AliasRole::kWorld);
        break;
      case Layer::Kind::kSprite:
        translucent.draw_sprite(scene.sprites[layer.number]);
        break;
      case Layer::Kind::kViewWeapon:
        translucent.draw_alias(*scene.view_weapon, AliasRole::kViewWeapon);
        break;
    }
    i = next;
  }
}

}  // namespace temblor::render
