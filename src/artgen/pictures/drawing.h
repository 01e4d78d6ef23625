// The lines of a drawing, painted in their order.
#pragma once

#include <span>

#include "artgen/pictures/canvas.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen::pictures {

// Shapes with their ink (words.h), and
//   group at=X,Y turn=DEG scale=N     what is below it is placed so
//   usual SHAPE settings              what later lines of that shape have if they do not say it
//   write "text" X,Y color=...       in the glyphs that stand in the drawing
//   tint RAMP:TONE by=0.5 rim=yes, shade 0.6, weather 0.2 lump=8    change all that was painted before
base::Status draw(std::span<const ScriptLine> lines, const Placement& placement, Canvas& io_canvas);

}  // namespace temblor::artgen::pictures
