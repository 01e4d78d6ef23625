// Hot loop. The scalar reference: it defines the results of the kernels.
#include "lab/world_light/kernels/lit_kernels.h"
#include "lab/world_light/kernels/lit_spans_scalar.h"

namespace temblor::lab {

namespace {

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

class PixelSampler {
 public:
  explicit PixelSampler(const PixelLights& lights) : lights_(lights) {}

  int begin_span(std::size_t /*number*/) { return lights_.pixels_before; }
  std::int32_t channels() const { return 1; }
  std::int32_t find_light(const Place& place, std::int32_t /*channel*/) const {
    return static_cast<std::int32_t>(
        lights_.light[static_cast<std::int32_t>(place.lane) - lights_.pixels_before]);
  }

 private:
  const PixelLights& lights_;
};

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
void draw_pixel_lit_u8_scalar(const LitSpans& spans, const PixelLights& light,
                              const render::KernelTarget& target) {
  draw_lit<std::uint8_t>(spans, PixelSampler(light), target);
}
void draw_pixel_lit_u32_scalar(const LitSpans& spans, const PixelLights& light,
                               const render::KernelTarget& target) {
  draw_lit<std::uint32_t>(spans, PixelSampler(light), target);
}

}  // namespace temblor::lab
