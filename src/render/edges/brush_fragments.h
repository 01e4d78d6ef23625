// Faces of brush models are cut at the leaves of the world, so that every fragment takes the sort key of its
// leaf and fits into the world's front-to-back order. Fragments of several models in one leaf are then
// ordered by 1/z (surface_stack.h).
//
// Method: Michael Abrash, "Sorted Spans in Action" (Graphics Programming Black Book, chapter 67).
#pragma once

#include <cstdint>

#include "base/arena.h"
#include "render/edges/edge_emitter.h"

namespace temblor::render {

// A face of a brush model, and the placement of the model.
struct BrushFace {
  // The same as in ScreenSurface: 1 + the index into Scene::brush_models.
  std::uint32_t instance;
  world::FaceIndex number;
  const ModelView& model_view;
};

// Adds the fragments of the face that lie in visible leaves. Adds nothing if the face's back is visible.
// `io_scratch` is reset.
void add_brush_face(const world::Level& level, const ViewFrame& view, const VisibleFaces& visible,
                    const FaceOutlines& outlines, const BrushFace& face, base::Arena& io_scratch,
                    EdgeEmitter& io_emitter);

}  // namespace temblor::render
