// Particles: squares that face the eye, sized by distance, tested against depth.
//
// At 320 x 240 with a field of view of 90 degrees a particle's side is 128 / z pixels, from 1 to 4: the
// original's rule. That is 0.8 units as the projection shows them; the limits grow with the picture. Pixels
// whose centres lie in the square are drawn where it is as near as what is there, or nearer; among particles
// equally near the later one stays.
#pragma once

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/colour/colour_tables.h"
#include "render/frame.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Needs the depth of everything opaque, and leaves its own there.
void draw_particles(const Scene& scene, const Settings& settings, const ViewFrame& view,
                    const ColourTables& tables, base::Jobs& jobs, base::Arena& arena, FrameBuffer& io_frame);

}  // namespace temblor::render
