#include "oracle/rays/face_color.h"

#include <algorithm>
#include <cmath>

namespace temblor::oracle {
namespace {

constexpr double kLightGridTexels = 16;
constexpr double kBrightest = 255.0 * 256.0;  // the sum that the brightest row of the colormap stands for

std::size_t wrapped(std::int64_t position, std::uint32_t size) {
  const auto period = static_cast<std::int64_t>(size);
  return static_cast<std::size_t>((position % period + period) % period);
}

// The position of a texel in a row of `count` samples: the sample before it, the one after it, and the
// fraction between them.
struct GridPosition {
  std::size_t before, after;
  double fraction;
};
GridPosition grid_position(double along, std::int32_t count) {
  const double position = std::clamp(along, 0.0, count - 1.0);
  const auto before = static_cast<std::size_t>(position);
  return {before, std::min(before + 1, static_cast<std::size_t>(count) - 1),
          position - static_cast<double>(before)};
}

math::Vec2d position_on_light_map(const world::Level& level, const world::Face& face, TexelPosition texel) {
  const auto s = static_cast<double>(texel.s - face.texture_mins[0]);
  const auto t = static_cast<double>(texel.t - face.texture_mins[1]);
  if (face.light_map_grid == world::kStockGrid) return {s / kLightGridTexels, t / kLightGridTexels};
  return level.light_map_grids[face.light_map_grid].position(s, t);
}

Light light_of_sample(const world::Level& level, const world::Face& face,
                      const world::LightStyleValues& styles, std::size_t column, std::size_t row,
                      LightColor color) {
  const auto width = static_cast<std::size_t>(level.light_size(face)[0]);
  const auto height = static_cast<std::size_t>(level.light_size(face)[1]);
  const bool rgb = color == LightColor::kRgb && !level.light_rgb.empty();
  Light sum{};
  for (std::size_t style = 0; style < face.style_count; ++style) {
    const std::size_t sample = face.light + (style * height + row) * width + column;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double value = rgb ? level.light_rgb[sample * 3 + channel] : level.light[sample];
      sum[channel] += value * styles[face.styles[style]];
    }
  }
  const double brightest = *std::max_element(sum.begin(), sum.end());
  if (brightest > kBrightest)
    for (double& channel : sum) channel *= kBrightest / brightest;
  return sum;
}

}  // namespace

math::Vec2d texture_position(const world::Level& level, const world::Face& face,
                             const math::Vec3d& point_model) {
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  return {glm::dot(point_model, math::Vec3d(axes.s_axis)) + static_cast<double>(axes.s_offset),
          glm::dot(point_model, math::Vec3d(axes.t_axis)) + static_cast<double>(axes.t_offset)};
}

std::uint8_t texel_at(const world::Texture& texture, TexelPosition position) {
  return texture
      .mips[0][wrapped(position.t, texture.height) * texture.width + wrapped(position.s, texture.width)];
}

Light sample_light(const world::Level& level, const world::Face& face, const world::LightStyleValues& styles,
                   TexelPosition position, LightColor color) {
  Light light{};
  if (face.light == world::kNoLight) return light;
  const math::Vec2d on_map = position_on_light_map(level, face, position);
  const GridPosition s = grid_position(on_map.x, level.light_size(face)[0]);
  const GridPosition t = grid_position(on_map.y, level.light_size(face)[1]);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto sample = [&](std::size_t column, std::size_t row) {
      return light_of_sample(level, face, styles, column, row, color)[channel];
    };
    const double above = std::lerp(sample(s.before, t.before), sample(s.after, t.before), s.fraction);
    const double below = std::lerp(sample(s.before, t.after), sample(s.after, t.after), s.fraction);
    light[channel] = std::lerp(above, below, t.fraction);
  }
  return light;
}

int colormap_row(double light) {
  const double quarter = std::max((kBrightest - light) / 4, 64.0);
  return std::min(static_cast<int>(quarter / 256), formats::Colormap::kRows - 1);
}

}  // namespace temblor::oracle
