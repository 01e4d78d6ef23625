#include "lab/world_light/vertex_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/surfaces/light/block_light.h"

namespace temblor::lab {

namespace {

std::span<const render::FaceLight> find_dynamic_lights(const render::FrameContext& context,
                                                       const render::FacePlacement& placed,
                                                       const render::SampleGrid& whole, base::Arena& arena) {
  base::ArenaVector<render::FaceLight> lights(arena, 4);
  for (const render::DynamicLight& light : context.scene.lights) {
    const std::optional<render::FaceLight> on_face =
        render::light_on_face(light, placed, context.settings.colored_light);
    if (on_face && render::reaches(*on_face, whole)) lights.push_back(*on_face);
  }
  return lights.view();
}

// Less is brighter in indexed frames.
float brightness(const PointLight& light, int channels, bool indexed) {
  return indexed ? -light[0] : *std::max_element(light.begin(), light.begin() + channels);
}

bool is_inside(const FacePoint& point, std::span<const FacePoint> polygon) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FacePoint& a = polygon[i];
    const FacePoint& b = polygon[(i + 1) % polygon.size()];
    const double side = (b.s - a.s) * (point.t - a.t) - (b.t - a.t) * (point.s - a.s);
    left += side <= 0;
    right += side >= 0;
  }
  return left == 0 || right == 0;
}

}  // namespace

VertexLighter::VertexLighter(const render::FrameContext& context, const render::BlockRequest& request,
                             const render::FacePlacement& placed, base::Arena& arena)
    : context_(context), face_(context.level().face(request.face)), arena_(arena) {
  const std::int32_t texels = render::choose_sample_texels(context.level(), face_, 0);
  whole_ = {0, 0, face_.texture_extents[0] / texels + 1, face_.texture_extents[1] / texels + 1, texels};
  light_ = {request.contents.style_values, request.contents.colored,
            find_dynamic_lights(context, placed, whole_, arena)};
  const bool has_color =
      light_.colored || std::any_of(light_.lights.begin(), light_.lights.end(), render::has_color);
  channels_ = has_color && !context.is_indexed() ? 3 : 1;
}

std::span<const std::int16_t> VertexLighter::make_samples(const render::SampleGrid& grid,
                                                          std::size_t& out_stride) const {
  const render::LightSums sums = render::sum_light(context_.level(), face_, grid, light_, arena_);
  const auto columns = static_cast<std::size_t>(grid.columns);
  out_stride = context_.is_indexed() ? 1 : 4;
  return context_.is_indexed() ? render::make_dark_samples(sums, columns, arena_)
                               : render::make_rgb_samples(sums, columns, arena_);
}

PointLight VertexLighter::find_light(const FacePoint& point) const {
  const auto place = [&](double texel, std::int32_t count) {
    return std::clamp(texel / whole_.texels, 0.0, static_cast<double>(count - 1));
  };
  const double x = place(point.s, whole_.columns), y = place(point.t, whole_.rows);
  const auto column = std::clamp(static_cast<std::int32_t>(x), 0, std::max(whole_.columns - 2, 0));
  const auto row = std::clamp(static_cast<std::int32_t>(y), 0, std::max(whole_.rows - 2, 0));
  const render::SampleGrid around{column, row, std::min(whole_.columns - column, 2),
                                  std::min(whole_.rows - row, 2), whole_.texels};
  std::size_t stride = 0;
  const std::span<const std::int16_t> samples = make_samples(around, stride);
  const auto columns = static_cast<std::size_t>(around.columns);
  const std::size_t right = (columns - 1) * stride;
  const std::size_t below = around.rows > 1 ? columns * stride : 0;
  const double share_x = x - column, share_y = y - row;
  PointLight light{};
  for (std::size_t channel = 0; channel < static_cast<std::size_t>(channels_); ++channel) {
    const auto sample = [&](std::size_t offset) { return static_cast<double>(samples[channel + offset]); };
    const double upper = std::lerp(sample(0), sample(right), share_x);
    const double lower = std::lerp(sample(below), sample(below + right), share_x);
    light[channel] = static_cast<float>(std::lerp(upper, lower, share_y));
  }
  return light;
}

std::optional<FacePoint> VertexLighter::find_brightest(std::span<const FacePoint> polygon) const {
  const bool indexed = context_.is_indexed();
  float most = std::numeric_limits<float>::lowest();
  for (const FacePoint& corner : polygon)
    most = std::max(most, brightness(find_light(corner), channels_, indexed));
  std::size_t stride = 0;
  const std::span<const std::int16_t> samples = make_samples(whole_, stride);
  std::optional<FacePoint> brightest;
  std::size_t sample = 0;
  for (std::int32_t row = 0; row < whole_.rows; ++row)
    for (std::int32_t column = 0; column < whole_.columns; ++column, sample += stride) {
      PointLight light{};
      for (std::size_t channel = 0; channel < static_cast<std::size_t>(channels_); ++channel)
        light[channel] = samples[sample + channel];
      const FacePoint point{1.0 * column * whole_.texels, 1.0 * row * whole_.texels};
      const float here = brightness(light, channels_, indexed);
      if (here <= most || !is_inside(point, polygon)) continue;
      most = here;
      brightest = point;
    }
  return brightest;
}

}  // namespace temblor::lab
