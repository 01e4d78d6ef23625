// Converts the three ways in which a .map aligns a texture on a side (standard, Valve 220, brush primitives)
// to the texture axes of a .bsp.
#pragma once

#include <array>
#include <cstdint>

#include "formats/levels/bsp.h"
#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::compiler {

// s = dot(position_world, s_axis) + s_offset, in texels of mip level 0; t likewise.
struct TextureAxes {
  math::Vec3d s_axis{0.0};
  double s_offset = 0;
  math::Vec3d t_axis{0.0};
  double t_offset = 0;

  math::Vec2d at(const math::Vec3d& position_world) const {
    return {glm::dot(position_world, s_axis) + s_offset, glm::dot(position_world, t_axis) + t_offset};
  }
};

// Axes that are safe to use.
struct SideAxes {
  TextureAxes axes;
  // The axes in the text were unusable: they are zero, are parallel as seen on the side, or give more than
  // kMaxTexelsPerUnit or fewer than kMinTexelsPerUnit. `axes` is the standard alignment at scale 1.
  bool replaced = false;
};

constexpr double kMaxTexelsPerUnit = 1000;
constexpr double kMinTexelsPerUnit = 1e-5;

// `normal` points out of the brush and has length 1. The texture's size matters for brush primitives, which
// are measured in whole textures, and for offsets over 2^20 texels, from which whole repetitions of the
// texture are removed (16 at a time, so that the luxel grid stays in place).
SideAxes make_side_axes(const formats::MapTexturing& texturing, const math::Vec3d& normal,
                        const math::Vec2d& texture_size_texels);

// The axes exactly as in the text, usable or not.
TextureAxes make_text_axes(const formats::MapTexturing& texturing, const math::Vec3d& normal,
                           const math::Vec2d& texture_size_texels);

// Rounds the axes to floats for the level.
formats::BspTexinfo to_texinfo(const TextureAxes& axes, std::int32_t miptex, std::int32_t flags);

// The two directions within a plane along which brush primitives measure s and t, from the normal's yaw and
// pitch as in Quake III Arena's editor.
std::array<math::Vec3d, 2> brush_primitive_axes(const math::Vec3d& normal);

}  // namespace temblor::compiler
