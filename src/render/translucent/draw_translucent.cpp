#include "render/translucent/draw_translucent.h"

#include <optional>

#include "render/alias/draw_translucent_alias.h"
#include "render/sprites/draw_sprites.h"
#include "render/translucent/merge_kernels.h"

namespace temblor::render {

namespace {

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

  void draw_faces(std::span<const DeferredFace> faces) {
    draw_deferred_faces(faces, target_, jobs_, arenas_, frame_);
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
      settings_.vector_kernels ? merge_blend_u8_simd(row) : merge_blend_u8_scalar(row);
    else
      settings_.vector_kernels ? merge_blend_u32_simd(row) : merge_blend_u32_scalar(row);
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

void draw_translucent(const Scene& scene, const Settings& settings, std::span<const TranslucentLayer> layers,
                      std::span<const DeferredFace> faces, const LateTarget& target, base::Jobs& jobs,
                      base::Arena& arena, std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame) {
  using Kind = TranslucentLayer::Kind;
  Translucent translucent(scene, settings, target, jobs, arena, io_arenas, io_frame);
  for (std::size_t i = 0; i < layers.size();) {
    const TranslucentLayer& layer = layers[i];
    std::size_t next = i + 1;
    switch (layer.kind) {
      case Kind::kFace:
        // Faces are in this order already: those with nothing between them are drawn together.
        next = i + leading_faces(layers.subspan(i));
        translucent.draw_faces(faces.subspan(layer.number, next - i));
        break;
      case Kind::kAlias:
        translucent.draw_alias(scene.alias_models[layer.number], AliasRole::kWorld);
        break;
      case Kind::kSprite:
        translucent.draw_sprite(scene.sprites[layer.number]);
        break;
      case Kind::kViewWeapon:
        translucent.draw_alias(*scene.view_weapon, AliasRole::kViewWeapon);
        break;
    }
    i = next;
  }
}

}  // namespace temblor::render
