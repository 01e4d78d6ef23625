// How solid faces are. What something shows through is left out of the edge list and drawn afterwards, one
// face at a time: a *late* face.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/scene.h"

namespace temblor::render {

struct FaceOpacity {
  float opacity = 1;       // 0 to 1; 0: the face is not drawn
  bool has_holes = false;  // texels of index 255 are clear
  bool is_late() const { return opacity < 1 || has_holes; }
};

// Of the world's faces, by texture: fences, and liquids that the scene makes translucent.
std::span<const FaceOpacity> world_opacities(const Scene& scene, base::Arena& arena);

// Of a face with that texture on a brush model. A model's own translucency is instead of its liquids', not
// on top of it. Sky is sky.
FaceOpacity opacity_on(std::span<const FaceOpacity> world_opacities, const world::Level& level,
                       world::TextureIndex texture, const BrushModelInstance& instance);

}  // namespace temblor::render
