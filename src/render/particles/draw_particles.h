// Particles: squares that face the eye, sized by distance and tested against depth.
//
// At 320 x 240 with a field of view of 90 degrees, a particle's side is 128 / z pixels, clamped to 1 to 4, as
// in stock Quake. That is 0.8 units in world space; the limits grow with the picture. A pixel whose center is
// in the square is drawn if the square is at least as near as what is there; among particles of equal depth
// the later one stays. (Abrash, "Quake's 3-D Engine: The Big Picture", describes them as clouds of z-buffered
// squares.)
#pragma once

#include <cstddef>
#include <span>

#include "render/particles/particle_kernels.h"
#include "render/view/frame_context.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// The visible particles, distributed to bands of rows in the scene's order. A square in two bands is cut.
struct ParticleBands {
  // By band; empty if there are no particles.
  std::span<const std::span<ParticleRect>> rects;
};

// Bands have Settings::band_rows rows. The result lives in the frame's arena.
ParticleBands place_particles(const FrameContext& context, const ViewFrame& view);

// Requires the depth of everything opaque, and writes the particles' own depth.
void draw_particles(const ParticleBands& particles, std::size_t band, bool simd_kernels,
                    FrameBuffer& io_frame);

}  // namespace temblor::render
