// Faces of brush models are cut at the world's leaves, so that every piece takes its leaf's place in the
// front-to-back order (Abrash, "The Big Picture").
#pragma once

#include <cstdint>

#include "base/arena.h"
#include "render/edges/edge_emitter.h"

namespace temblor::render {

// Adds what of the face lies in leaves that were visited; nothing when its back is turned to the eye.
// `io_scratch` is reset.
void add_brush_face(const Scene& scene, const ViewFrame& view, const VisibleFaces& visible,
                    const FaceOutlines& outlines, const ModelView& model_view, std::uint32_t instance,
                    world::FaceIndex face, base::Arena& io_scratch, EdgeEmitter& io_emitter);

}  // namespace temblor::render
