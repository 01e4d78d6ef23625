// Stage 9, first part. Sorts everything translucent into drawing order, back to front.
#pragma once

#include <cstdint>
#include <span>

#include "render/sprites/sprite_quad.h"
#include "render/translucent/deferred_faces.h"

namespace temblor::render {

// A translucent model, sprite, or deferred face.
struct TranslucentLayer {
  enum class Kind : std::uint8_t { kFace, kAlias, kSprite, kViewWeapon };
  SortKey key;
  double depth;  // ViewFrame::depth; decides between equal keys
  Kind kind;
  std::uint32_t number;  // in faces.translucent, Scene::alias_models, or TranslucentOrder::sprites
};

struct TranslucentOrder {
  DeferredFaces faces;
  std::span<const SpriteQuad> sprites;
  // Back to front. Layers of kind kFace number faces.translucent, which is in the same order.
  std::span<const TranslucentLayer> layers;
  // The first `banded` layers are faces and sprites: no translucent model is behind them, so they are drawn
  // with the opaque picture, band by band.
  std::size_t banded = 0;
};

// A model or sprite has the sort key of the leaf that contains its origin, like brush models. In a leaf that
// is not visible it counts as nearest. The view model is nearer than everything. Faces keep the order of
// sort_deferred_faces. Without depth to test against there are only faces.
TranslucentOrder sort_translucent(const FrameContext& context, const WorldPicture& world,
                                  const VisibleFaces& visible);

// The number of layers before the first model.
std::size_t count_banded_layers(std::span<const TranslucentLayer> layers);

}  // namespace temblor::render
