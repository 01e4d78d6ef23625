#include "world/loading/texel_range.h"

#include <algorithm>
#include <limits>

namespace temblor::world {
namespace {

// The sum is computed in double and rounded to float once. Light compilers use the same rule; any other
// rounding gives some faces of real levels one column of light samples too many or too few.
double texel_coordinate(const math::Vec3& position, const math::Vec3& axis, float offset) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const double texel = glm::dot(math::Vec3d(position), math::Vec3d(axis)) + double{offset};
  return static_cast<float>(std::clamp(texel, -kLargest, kLargest));
}

}  // namespace

TexelRange find_texel_range(const Level& level, const Face& face, int axis) {
  const TextureAxes& axes = level.texture_axes[face.axes];
  TexelRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3& vertex = level.vertices[level.surfedge_start(face.first_surfedge + i)];
    const double texel = axis == 0 ? texel_coordinate(vertex, axes.s_axis, axes.s_offset)
                                   : texel_coordinate(vertex, axes.t_axis, axes.t_offset);
    range.min = std::min(range.min, texel);
    range.max = std::max(range.max, texel);
  }
  return range;
}

}  // namespace temblor::world
