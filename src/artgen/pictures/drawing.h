// Draws the lines of a drawing onto a canvas, in their order.
#pragma once

#include <span>

#include "artgen/pictures/canvas.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen::pictures {

// Besides shapes with their ink (drawing_settings.h), drawings contain
//
//   group at=X,Y turn=DEG scale=N     transforms the lines below it
//   usual SHAPE SETTINGS              defaults for later shapes of this kind in this group
//   write "text" X,Y color=...        in the glyphs that are defined among the same lines
//   tint 0.5 color=RAMP:TONE rim=yes, shade 0.6, weather 0.2 lump=8
//                                     change everything painted so far
//
// `placement` transforms the whole drawing. Fails at the first line with a problem; the canvas is then
// incomplete.
base::Status draw(std::span<const ScriptLine> lines, const Placement& placement, Canvas& io_canvas);

}  // namespace temblor::artgen::pictures
