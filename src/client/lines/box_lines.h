// Boxes as the lines of their edges (r_showbboxes).
#pragma once

#include <span>
#include <vector>

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

// Replaces `out_lines` by the twelve edges of each box. A box without size becomes a cross, 16 units wide.
void make_box_lines(std::span<const math::Bounds> boxes, std::vector<render::Line>& out_lines);

}  // namespace temblor::client
