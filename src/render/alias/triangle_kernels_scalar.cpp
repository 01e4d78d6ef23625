// The scalar reference: it defines the results of the triangle kernels.
#include "render/alias/affine_triangle.h"

namespace temblor::render {

namespace {

// At equal depth, a triangle draws over what is there, so of two triangles the later one stays.
template <typename Pixel>
void draw_triangles(const TriangleJob& job, const TriangleTarget& target) {
  for (std::size_t number = 0; number < job.triangle_count; ++number)
    draw_affine_triangle(job, number, target, [&](const TriangleSpan& span) {
      const std::size_t first =
          static_cast<std::size_t>(span.y - target.first_row) * static_cast<std::size_t>(target.width) +
          static_cast<std::size_t>(span.x);
      Pixel* const pixels = static_cast<Pixel*>(target.pixels) + first;
      float* const nearest = target.depth + first;
      for (std::int32_t i = 0; i < span.count; ++i) {
        const float lane = static_cast<float>(i);
        const float depth = span.depth + lane * span.depth_step;
        if (!(depth >= nearest[i])) continue;
        nearest[i] = depth;
        pixels[i] = lit_texel(job, skin_texel(job, span, lane, depth), span, lane, Pixel{});
      }
    });
}

}  // namespace

void draw_triangles_u8_scalar(const TriangleJob& job, const TriangleTarget& target) {
  draw_triangles<std::uint8_t>(job, target);
}
void draw_triangles_u32_scalar(const TriangleJob& job, const TriangleTarget& target) {
  draw_triangles<std::uint32_t>(job, target);
}

void look_up_texels_u8(const TriangleJob& job, const std::int32_t* texels, const std::int32_t* lights,
                       std::size_t count, std::uint8_t* out) {
  const std::uint8_t* const colors = static_cast<const std::uint8_t*>(job.colors);
  for (std::size_t i = 0; i < count; ++i) out[i] = colors[lights[i] + job.skin[texels[i]]];
}
void look_up_texels_u32(const TriangleJob& job, const std::int32_t* texels, std::size_t count,
                        std::uint32_t* out) {
  const std::uint32_t* const colors = static_cast<const std::uint32_t*>(job.colors);
  for (std::size_t i = 0; i < count; ++i) out[i] = colors[job.skin[texels[i]]];
}

}  // namespace temblor::render
