// Stage 9. Everything that is translucent, in the order in which it is drawn.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/scene.h"
#include "render/translucent/deferred_faces.h"

namespace temblor::render {

// One of the scene's translucent things, or a late face; faces are numbered as given.
struct TranslucentLayer {
  enum class Kind : std::uint8_t { kFace, kAlias, kSprite, kViewWeapon };
  SortKey key;
  double depth;  // ViewFrame::depth, among equal keys
  Kind kind;
  std::uint32_t number;
};

// Back to front. A model or sprite takes the place of the leaf that its origin lies in, as brush models do;
// in a leaf that was not visited it is taken for nearest, and the view weapon is nearer than all. `faces` are
// back to front, and come in this order.
std::span<const TranslucentLayer> sort_translucent(const Scene& scene, const ViewFrame& view,
                                                   const VisibleFaces& visible,
                                                   std::span<const DeferredFace> faces, base::Arena& arena);

// So many faces lie behind everything else that is translucent.
std::size_t leading_faces(std::span<const TranslucentLayer> layers);

}  // namespace temblor::render
