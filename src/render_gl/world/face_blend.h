// How translucent faces of indexed frames are blended: the tables, and the part of the picture that a face
// covers.
#pragma once

#include <optional>

#include "render_gl/world/face_queue.h"
#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

// The tables of the CPU (render/translucent/deferred_faces.cpp).
IndexBlend choose_blend(const render::ColorTables& colors, const render::FaceOpacity& opacity);

// Contains all pixels of a translucent face on the card. They are those of the CPU's spans, or next to them.
// Nothing if there are no spans.
std::optional<PixelRect> find_face_rect(const FrameInput& input, const QueuedFace& face);

}  // namespace temblor::render_gl
