#include "render_gl/vertex_light/vertex_light.h"

#include <algorithm>
#include <cmath>

#include "render/surfaces/light/block_light.h"

namespace temblor::render_gl {

namespace {

// The sample before a point along one axis, how many follow from there, and the share of the second one.
struct SamplePosition {
  std::int32_t first, count;
  double share;
};

SamplePosition find_position(double texel, std::int32_t extent, std::int32_t texels_per_sample) {
  const double at = std::clamp(texel, 0.0, static_cast<double>(extent)) / texels_per_sample;
  const std::int32_t samples = extent / texels_per_sample + 1;
  const std::int32_t first = std::min(static_cast<std::int32_t>(at), samples - 1);
  return {first, std::min(2, samples - first), at - first};
}

}  // namespace

std::array<std::int16_t, 3> find_light_at(const world::Level& level, const render::BlockRequest& request,
                                          double s, double t, base::Arena& scratch) {
  scratch.reset();
  const world::Face& face = level.face(request.face);
  const std::int32_t texels = render::choose_sample_texels(level, face, 0);
  const SamplePosition column = find_position(s, face.texture_extents[0], texels);
  const SamplePosition row = find_position(t, face.texture_extents[1], texels);
  const render::SampleGrid grid{column.first, row.first, column.count, row.count, texels};
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto samples = render::make_rgb_samples(
      render::sum_block_light(level, request, {grid, grid}, scratch), columns, scratch);
  std::array<std::int16_t, 3> light{};
  for (std::size_t channel = 0; channel < light.size(); ++channel) {
    // Samples beyond the last column or row have no share.
    const auto sample = [&](std::int32_t x, std::int32_t y) {
      const std::int32_t number = std::min(y, row.count - 1) * column.count + std::min(x, column.count - 1);
      return static_cast<double>(samples[static_cast<std::size_t>(number) * 4 + channel]);
    };
    const double above = std::lerp(sample(0, 0), sample(1, 0), column.share);
    const double below = std::lerp(sample(0, 1), sample(1, 1), column.share);
    light[channel] = static_cast<std::int16_t>(std::lround(std::lerp(above, below, row.share)));
  }
  return light;
}

}  // namespace temblor::render_gl
