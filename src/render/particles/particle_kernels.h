// Inner loops over particles, as vector code and as plain C++ with the same results, bit for bit. Only plain
// types here: the vector file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// Particles nearer than this along the view vanish, as in the original: units.
constexpr float kParticleNearest = 8.0f;

// How the world comes to the screen. Axes are unit vectors; pixel centers are at whole numbers.
struct ParticleProjection {
  float eye[3], right[3], up[3], forward[3];
  bool perspective;
  float pixels_per_unit;  // perspective: at distance 1
  float center_x, center_y;
  float width, height;          // pixels
  float side_at_one_unit;       // a square's side, in pixels, before the limits; perspective: at distance 1
  float least_side, most_side;  // pixels, at least 1
};

// Places of `count` particles, and what they become: the upper left pixel of a square (it may lie outside the
// picture in part), its side in pixels, and its depth as in FrameBuffer::depth. Side 0: not in view; the
// other numbers are then 0 too.
struct ParticleBatch {
  const float *x, *y, *z;  // world
  std::size_t count;
  std::int32_t *left, *top, *side;
  float* depth;
};

// A square, or what is left of it within the picture and a band of rows. Never empty.
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

// In order: wherever a rectangle is as near as what is there or nearer, it leaves its color and depth.
void draw_particles_u8_scalar(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);
void draw_particles_u32_scalar(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);
void draw_particles_u8_simd(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);
void draw_particles_u32_simd(const ParticleRect* rects, std::size_t count, const ParticleTarget& target);

}  // namespace temblor::render
