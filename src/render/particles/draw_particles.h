// Particles: squares that face the eye, sized by distance, tested against depth.
//
// At 320 x 240 with a field of view of 90 degrees a particle's side is 128 / z pixels, from 1 to 4: the
// original's rule. That is 0.8 units as the projection shows them; the limits grow with the picture. Pixels
// whose centers lie in the square are drawn where it is as near as what is there, or nearer; among particles
// equally near the later one stays.
#pragma once

#include <cstddef>
#include <span>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/color/color_tables.h"
#include "render/frame.h"
#include "render/particles/particle_kernels.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Those in view, dealt out to bands of rows in the scene's order; what lies in two is cut.
struct ParticleBands {
  std::span<const std::span<ParticleRect>> rects;
};

ParticleBands place_particles(const Scene& scene, const Settings& settings, const ViewFrame& view,
                              int band_rows, const ColorTables& tables, PixelFormat format, base::Jobs& jobs,
                              base::Arena& arena);

// Needs the depth of everything opaque, and leaves its own there.
void draw_particles(const ParticleBands& particles, std::size_t band, bool vector_kernels,
                    FrameBuffer& io_frame);

}  // namespace temblor::render
