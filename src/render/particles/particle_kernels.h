// Inner loops over particles, as SIMD and as the scalar reference with the same results, bit for bit. This
// header has plain types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// Units along the view. Nearer particles are not drawn, as in stock Quake.
constexpr float kMinParticleDistance = 8.0f;

// The projection from world space to the screen. Axes are unit vectors; pixel centers are at whole numbers.
struct ParticleProjection {
  float eye[3], right[3], up[3], forward[3];
  bool perspective;
  float pixels_per_unit;  // perspective: at distance 1
  float center_x, center_y;
  float width, height;       // pixels
  float side_at_one_unit;    // a square's side, in pixels, before the limits; perspective: at distance 1
  float min_side, max_side;  // pixels, at least 1
};

// Input: the positions of `count` particles. Output: the upper left pixel of each square (it may lie partly
// outside the picture), its side in pixels, and its depth as in FrameBuffer::depth. Side 0: not visible; the
// other outputs are then 0 too.
struct ParticleBatch {
  const float *x, *y, *z;  // world
  std::size_t count;
  std::int32_t *left, *top, *side;
  float* depth;
};

// A square, clipped to the picture and to a band of rows. Never empty.
struct ParticleRect {
  float depth;
  std::uint16_t x, y, width, height;  // pixels
  std::uint32_t color;                // as stored: a palette index, or 0xffRRGGBB
};

// Rows are `width` apart.
struct ParticleTarget {
  void* pixels;  // bytes or 32-bit colors
  float* depth;
  std::size_t width;
};

void project_particles_scalar(const ParticleProjection& projection, const ParticleBatch& batch);
void project_particles_simd(const ParticleProjection& projection, const ParticleBatch& batch);

// Draw rectangles in order. Where a rectangle is at least as near as what is there, its color and depth are
// written.
void draw_particles_u8_scalar(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);
void draw_particles_u32_scalar(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);
void draw_particles_u8_simd(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);
void draw_particles_u32_simd(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);

}  // namespace temblor::render
