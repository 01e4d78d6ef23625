// Hot loop. The scalar reference of the skybox kernels.
#include <cmath>

#include "render/spans/skybox_kernels.h"

namespace temblor::render {

namespace {

// A position on one of the sides, in texels.
struct Place {
  float u, v;
  std::int32_t side;
};

// Divides by the largest component, which projects the ray onto the cube.
Place find_place(float x, float y, float z, std::int32_t size) {
  const float ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
  const float half = static_cast<float>(size) * 0.5f, center = half + 0.5f;
  float s, t, largest;
  std::int32_t side;
  if (ax >= ay && ax >= az) {
    s = x > 0 ? -y : y;
    t = z;
    largest = ax;
    side = x > 0 ? 0 : 2;
  } else if (ay >= az) {
    s = y > 0 ? x : -x;
    t = z;
    largest = ay;
    side = y > 0 ? 1 : 3;
  } else {
    s = -y;
    t = z > 0 ? -x : x;
    largest = az;
    side = z > 0 ? 4 : 5;
  }
  return {center + s / largest * half, center - t / largest * half, side};
}

std::uint8_t texel_at(const std::uint8_t* texels, const Place& place, std::int32_t size) {
  const std::int32_t row = size + 2;
  const auto column = static_cast<std::int32_t>(place.u + 0.5f);
  const auto line = static_cast<std::int32_t>(place.v + 0.5f);
  return texels[(place.side * row + line) * row + column];
}

// Bilinear, in 256ths; the border makes the right and lower neighbor available everywhere.
std::uint32_t texel_at(const std::uint32_t* texels, const Place& place, std::int32_t size) {
  const std::int32_t row = size + 2;
  const auto column = static_cast<std::int32_t>(place.u), line = static_cast<std::int32_t>(place.v);
  const auto right = static_cast<std::uint32_t>((place.u - static_cast<float>(column)) * 256.0f);
  const auto below = static_cast<std::uint32_t>((place.v - static_cast<float>(line)) * 256.0f);
  const std::uint32_t* const four = texels + (place.side * row + line) * row + column;
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8) {
    const auto channel = [&](std::uint32_t texel) { return texel >> shift & 255; };
    const std::uint32_t above_sum = channel(four[0]) * (256 - right) + channel(four[1]) * right;
    const std::uint32_t below_sum = channel(four[row]) * (256 - right) + channel(four[row + 1]) * right;
    out |= (above_sum * (256 - below) + below_sum * below + 32768) >> 16 << shift;
  }
  return out;
}

template <typename Texel>
void draw_span(const SkyboxSpans& sky, const Span& span, std::int32_t first, const KernelTarget& target) {
  const std::size_t start = span.y * target.width + span.x;
  const auto depth = static_cast<float>(sky.depth.at_origin + sky.depth.dx * span.x + sky.depth.dy * span.y);
  const auto depth_step = static_cast<float>(sky.depth.dx);
  float ray[3], step[3];
  for (int axis = 0; axis < 3; ++axis) {
    ray[axis] = static_cast<float>(sky.forward[axis] + sky.right[axis] * span.x + sky.down[axis] * span.y);
    step[axis] = static_cast<float>(sky.right[axis]);
  }
  for (std::int32_t i = first; i < span.count; ++i) {
    const float lane = static_cast<float>(i);
    const std::size_t pixel = start + static_cast<std::size_t>(i);
    if (target.depth != nullptr) target.depth[pixel] = depth + lane * depth_step;
    const Place place =
        find_place(ray[0] + lane * step[0], ray[1] + lane * step[1], ray[2] + lane * step[2], sky.size);
    static_cast<Texel*>(target.pixels)[pixel] =
        texel_at(static_cast<const Texel*>(sky.texels), place, sky.size);
  }
}

}  // namespace

void draw_skybox_span_u8_scalar(const SkyboxSpans& spans, const Span& span, std::int32_t first,
                                const KernelTarget& target) {
  draw_span<std::uint8_t>(spans, span, first, target);
}
void draw_skybox_span_u32_scalar(const SkyboxSpans& spans, const Span& span, std::int32_t first,
                                 const KernelTarget& target) {
  draw_span<std::uint32_t>(spans, span, first, target);
}

void draw_skybox_spans_u8_scalar(const SkyboxSpans& spans, const KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_span<std::uint8_t>(spans, spans.spans[i], 0, target);
}
void draw_skybox_spans_u32_scalar(const SkyboxSpans& spans, const KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_span<std::uint32_t>(spans, spans.spans[i], 0, target);
}

}  // namespace temblor::render
