// From what a .map says of how a texture lies on a side to the axes that a .bsp holds.
#pragma once

#include <array>
#include <cstdint>

#include "formats/levels/bsp.h"
#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::compiler {

// s = dot(position_world, s_axis) + s_offset, in texels of mip 0; t alike.
struct TextureAxes {
  math::Vec3d s_axis{0.0};
  double s_offset = 0;
  math::Vec3d t_axis{0.0};
  double t_offset = 0;

  math::Vec2d at(const math::Vec3d& position_world) const {
    return {glm::dot(position_world, s_axis) + s_offset, glm::dot(position_world, t_axis) + t_offset};
  }
};

struct SideAxes {
  TextureAxes axes;
  // The text's own axes do not lay the texture over the side (they are zero, or as seen on the side lie in
  // one line), or have more than kMaxTexelsPerUnit or less than kMinTexelsPerUnit: the standard alignment at
  // scale 1 stands in.
  bool replaced = false;
};

constexpr double kMaxTexelsPerUnit = 1000;
constexpr double kMinTexelsPerUnit = 1e-5;

// `normal` is the side's, of length 1, pointing out of the brush. `texture_size_texels` matters to brush
// primitives, whose text measures in whole textures, and to offsets over 2^20 texels, which lose whole
// repetitions of the texture (16 at a time, so that the light map's grid stays).
SideAxes side_axes(const formats::MapTexturing& texturing, const math::Vec3d& normal,
                   const math::Vec2d& texture_size_texels);

// What the text says, whether it covers the side or not; nothing is taken from the offsets.
TextureAxes text_axes(const formats::MapTexturing& texturing, const math::Vec3d& normal,
                      const math::Vec2d& texture_size_texels);

formats::BspTexinfo to_texinfo(const TextureAxes& axes, std::int32_t miptex, std::int32_t flags);

// The two directions within a plane along which brush primitives measure s and t: as in Quake III Arena's
// editor, from the normal's yaw and pitch.
std::array<math::Vec3d, 2> brush_primitive_axes(const math::Vec3d& normal);

}  // namespace temblor::compiler
