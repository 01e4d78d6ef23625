// The scalar reference: it defines the results of the particle kernels.
#include <algorithm>
#include <cmath>

#include "render/particles/particle_kernels.h"

namespace temblor::render {

namespace {

float along(const float (&axis)[3], float x, float y, float z) {
  return x * axis[0] + y * axis[1] + z * axis[2];
}

template <typename Pixel>
void draw_rects(const ParticleRect* rects, std::size_t count, const ParticleTarget& target) {
  for (std::size_t i = 0; i < count; ++i) {
    const ParticleRect& rect = rects[i];
    const Pixel color = static_cast<Pixel>(rect.color);
    for (std::size_t row = 0; row < rect.height; ++row) {
      const std::size_t first = (rect.y + row) * target.width + rect.x;
      Pixel* const pixels = static_cast<Pixel*>(target.pixels) + first;
      float* const depth = target.depth + first;
      for (std::size_t column = 0; column < rect.width; ++column) {
        const bool nearer = depth[column] <= rect.depth;
        pixels[column] = nearer ? color : pixels[column];
        depth[column] = nearer ? rect.depth : depth[column];
      }
    }
  }
}

}  // namespace

void project_particles_scalar(const ParticleProjection& projection, const ParticleBatch& batch) {
  const ParticleProjection& p = projection;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const float dx = batch.x[i] - p.eye[0], dy = batch.y[i] - p.eye[1], dz = batch.z[i] - p.eye[2];
    const float distance = along(p.forward, dx, dy, dz);
    const float nearness = p.perspective ? 1.0f / distance : 1.0f;
    const float scale = p.pixels_per_unit * nearness;
    const float center_x = p.center_x + along(p.right, dx, dy, dz) * scale;
    const float center_y = p.center_y - along(p.up, dx, dy, dz) * scale;
    const float side =
        std::floor(std::min(std::max(p.side_at_one_unit * nearness, p.min_side), p.max_side) + 0.5f);
    const float left = std::ceil(center_x - side * 0.5f), top = std::ceil(center_y - side * 0.5f);
    // No comparison with NaN is true, so particles with bad positions are not visible.
    const bool in_view =
        distance >= kMinParticleDistance && left > -side && left < p.width && top > -side && top < p.height;
    batch.left[i] = in_view ? static_cast<std::int32_t>(left) : 0;
    batch.top[i] = in_view ? static_cast<std::int32_t>(top) : 0;
    batch.side[i] = in_view ? static_cast<std::int32_t>(side) : 0;
    batch.depth[i] = in_view ? (p.perspective ? nearness : -distance) : 0.0f;
  }
}

void draw_particles_u8_scalar(const ParticleRect* rects, std::size_t count, const ParticleTarget& target) {
  draw_rects<std::uint8_t>(rects, count, target);
}
void draw_particles_u32_scalar(const ParticleRect* rects, std::size_t count, const ParticleTarget& target) {
  draw_rects<std::uint32_t>(rects, count, target);
}

}  // namespace temblor::render
