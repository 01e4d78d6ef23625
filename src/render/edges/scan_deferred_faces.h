// Scans deferred faces one at a time, each as if nothing else were on the screen. A face covers exactly the
// pixels that the edge scan would give it.
#pragma once

#include <span>

#include "render/edges/scan_band.h"

namespace temblor::render {

// Returns `spans`, the opaque spans of a band, followed by the spans of each deferred surface from top to
// bottom and left to right.
std::span<const DrawSpan> add_deferred_faces(std::span<const DrawSpan> spans, const EdgeTable& table,
                                             RowRange rows, int width, base::Arena& arena);

}  // namespace temblor::render
