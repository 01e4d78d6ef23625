// Hot loop. The scalar reference: it defines the results of the kernels.
#include "lab/world_light/lit_kernels.h"

namespace temblor::lab {

namespace {

float larger(float a, float b) {
  return a > b ? a : b;
}
float smaller(float a, float b) {
  return a < b ? a : b;
}

// A linear function along a span.
struct Line {
  float base, step;
  float at(float lane) const { return base + lane * step; }
};
Line make_line(const render::KernelPlane& plane, int x, int y) {
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

class GridSampler {
 public:
  explicit GridSampler(const GridLight& grid) : grid_(grid) {}

  int begin_span(std::size_t /*number*/) { return 0; }
  std::int32_t channels() const { return grid_.channels; }
  std::int32_t find_light(const Place& place, std::int32_t channel) const {
    const std::int32_t texels = 1 << grid_.texel_shift;
    const std::int32_t to_nearest = grid_.is_nearest ? texels / 2 : 0;
    const std::int32_t s = place.s + to_nearest, t = place.t + to_nearest;
    const std::uint32_t* cell = grid_.cells[channel] +
                                static_cast<std::ptrdiff_t>(t >> grid_.texel_shift) * grid_.columns +
                                (s >> grid_.texel_shift);
    if (grid_.is_nearest) return static_cast<std::int32_t>(*cell & 0xffff);
    const std::int32_t down = (t & (texels - 1)) << (15 - grid_.texel_shift);
    const std::int32_t right = (s & (texels - 1)) << (15 - grid_.texel_shift);
    const auto interpolate_down = [&](int shift) {
      const auto above = static_cast<std::int32_t>(cell[0] >> shift & 0xffff);
      const auto below = static_cast<std::int32_t>(cell[grid_.columns] >> shift & 0xffff);
      return above + multiply_q15(below - above, down);
    };
    const std::int32_t first = interpolate_down(0), second = interpolate_down(16);
    return first + multiply_q15(second - first, right);
  }

 private:
  const GridLight& grid_;
};

class LineSampler {
 public:
  explicit LineSampler(const LineLights& lights) : lights_(lights) {}

  int begin_span(std::size_t number) {
    line_ = &lights_.lines[number];
    return line_->pixels_before;
  }
  std::int32_t channels() const { return lights_.channels; }
  std::int32_t find_light(const Place& place, std::int32_t channel) const {
    float light = line_->base[channel] + place.lane * line_->step[channel];
    if (lights_.is_over_z) light = light * place.z;
    light = smaller(larger(light, line_->least[channel]), line_->most[channel]);
    return static_cast<std::int32_t>(light + 0.5f);
  }

 private:
  const LineLights& lights_;
  const LineLight* line_ = nullptr;
};

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
      const std::int32_t texel = (place.t + spans.first_t) % spans.texture.height * spans.texture.width +
                                 (place.s + spans.first_s) % spans.texture.width;
      static_cast<Texel*>(target.pixels)[first + static_cast<std::size_t>(i)] =
          light_texel(static_cast<const Texel*>(spans.texture.texels)[texel], spans, sampler, place);
    }
  }
}

}  // namespace

void draw_grid_lit_u8_scalar(const LitSpans& spans, const GridLight& light,
                             const render::KernelTarget& target) {
  draw_lit<std::uint8_t>(spans, GridSampler(light), target);
}
void draw_grid_lit_u32_scalar(const LitSpans& spans, const GridLight& light,
                              const render::KernelTarget& target) {
  draw_lit<std::uint32_t>(spans, GridSampler(light), target);
}
void draw_line_lit_u8_scalar(const LitSpans& spans, const LineLights& light,
                             const render::KernelTarget& target) {
  draw_lit<std::uint8_t>(spans, LineSampler(light), target);
}
void draw_line_lit_u32_scalar(const LitSpans& spans, const LineLights& light,
                              const render::KernelTarget& target) {
  draw_lit<std::uint32_t>(spans, LineSampler(light), target);
}

}  // namespace temblor::lab
