// The scalar reference of lit spans: draw_lit() draws spans with a sampler, which finds the light of a pixel.
//
//   int begin_span(number)         prepares for a span; returns the pixels before it
//                                  (LineLight::pixels_before)
//   channels()                     1 or 3
//   find_light(place, channel)
#pragma once

#include "lab/world_light/kernels/lit_kernels.h"

namespace temblor::lab {

inline float larger(float a, float b) {
  return a > b ? a : b;
}
inline float smaller(float a, float b) {
  return a < b ? a : b;
}

// A linear function along a span.
struct Line {
  float base, step;
  float at(float lane) const { return base + lane * step; }
};
inline Line make_line(const render::KernelPlane& plane, int x, int y) {
  return {static_cast<float>(plane.at_origin + plane.dx * x + plane.dy * y), static_cast<float>(plane.dx)};
}

// A pixel: its number in the span, its distance, and its texel of the tile.
struct Place {
  float lane, z;
  std::int32_t s, t;
};

constexpr std::int32_t multiply_q15(std::int32_t a, std::int32_t b) {
  return (a * b + 16384) >> 15;
}

template <typename Sampler>
std::uint8_t light_texel(std::uint8_t texel, const LitSpans& spans, const Sampler& sampler,
                         const Place& place) {
  return spans.colormap[(sampler.find_light(place, 0) & ~255) + texel];
}

template <typename Sampler>
std::uint32_t light_texel(std::uint32_t texel, const LitSpans& /*spans*/, const Sampler& sampler,
                          const Place& place) {
  if (texel >> 24 == 0) return texel | 0xff000000u;
  std::uint32_t out = 0xff000000u;
  for (int channel = 0; channel < 3; ++channel) {
    const std::int32_t light = sampler.find_light(place, sampler.channels() == 3 ? channel : 0);
    const auto color = static_cast<std::int32_t>(texel >> (8 * channel) & 255);
    const std::int32_t lit = multiply_q15(2 * color, light);
    out |= static_cast<std::uint32_t>(lit > 255 ? 255 : lit) << (8 * channel);
  }
  return out;
}

template <typename Texel, typename Sampler>
void draw_lit(const LitSpans& spans, Sampler sampler, const render::KernelTarget& target) {
  const auto clamped = [](float texel, std::int32_t last) {
    return static_cast<std::int32_t>(smaller(larger(texel, 0.0f), static_cast<float>(last)));
  };
  for (std::size_t number = 0; number < spans.span_count; ++number) {
    const render::Span& span = spans.spans[number];
    const std::size_t first = span.y * target.width + span.x;
    const int before = sampler.begin_span(number), x = span.x - before;
    const Line depth = make_line(spans.depth, x, span.y), s = make_line(spans.s, x, span.y),
               t = make_line(spans.t, x, span.y);
    for (int i = 0; i < span.count; ++i) {
      Place place{static_cast<float>(before + i), 1.0f, 0, 0};
      const float near = depth.at(place.lane);
      if (target.depth != nullptr) target.depth[first + static_cast<std::size_t>(i)] = near;
      if (spans.perspective) place.z = 1.0f / larger(near, render::kMinSpanDepth);
      place.s = clamped(s.at(place.lane) * place.z, spans.last_s);
      place.t = clamped(t.at(place.lane) * place.z, spans.last_t);
      const std::int32_t column = (place.s + spans.first_s) % spans.texture.width;
      const std::int32_t row = (place.t + spans.first_t) % spans.texture.height;
      const std::int32_t texel = row * (spans.texture.width + kMarginColumns) + column;
      static_cast<Texel*>(target.pixels)[first + static_cast<std::size_t>(i)] =
          light_texel(static_cast<const Texel*>(spans.texture.texels)[texel], spans, sampler, place);
    }
  }
}

}  // namespace temblor::lab
