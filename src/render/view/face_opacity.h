// How opaque faces are.
//
// Faces that something shows through (liquids with alpha, brush models with alpha, fences) are left out of
// the edge table: it finds only the front surface of each pixel. They are drawn afterwards, one face at a
// time, and are called *deferred* faces (translucent/deferred_faces.h). Stock Quake draws all faces opaque.
#pragma once

#include <optional>
#include <span>

#include "base/arena.h"
#include "render/scene.h"

namespace temblor::render {

// The default is an ordinary opaque face.
struct FaceOpacity {
  float opacity = 1;       // 0 to 1; 0: the face is not drawn
  bool has_holes = false;  // alpha-tested: texels of index 255 are clear
  bool is_additive = false;
  std::optional<formats::Rgb> color{};  // replaces the texels
  bool is_translucent() const { return opacity < 1 || is_additive; }
  bool is_deferred() const { return is_translucent() || has_holes || color; }
};

// Opacities of the world's faces, by texture index. Only fences and liquids that the scene makes translucent
// differ from the default. Lives in `arena`.
std::span<const FaceOpacity> world_opacities(const Scene& scene, base::Arena& arena);

// The opacity of a face with texture `texture` on a brush model. An instance's alpha below 1 replaces the
// texture's opacity; the two are not multiplied. Sky is always opaque and keeps its colors.
FaceOpacity brush_face_opacity(std::span<const FaceOpacity> world_opacities, const world::Level& level,
                               world::TextureIndex texture, const BrushModelInstance& instance);

}  // namespace temblor::render
