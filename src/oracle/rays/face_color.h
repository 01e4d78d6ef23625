// The color of a point on a face, from the definition: its texel by the texture axes, its light by the light
// map. Mip level 0 only.
#pragma once

#include <array>
#include <cstdint>

#include "formats/images/palette.h"
#include "math/vec.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::oracle {

// The texture coordinates of a point in model space, in texels of mip 0.
math::Vec2d texture_position(const world::Level& level, const world::Face& face,
                             const math::Vec3d& point_model);

// A texel of the texture plane, which the texture tiles endlessly.
struct TexelPosition {
  std::int64_t s = 0, t = 0;
};
std::uint8_t texel_at(const world::Texture& texture, TexelPosition position);

// Red, green, and blue light of a texel in 8.8 fixed point, as real numbers; all three equal for gray light.
// A sample of the light map contributes sample x style value (256: as stored), summed over the face's styles.
// If the brightest channel is above 255 x 256, all three are scaled to make it so. Samples are 16 texels
// apart, the first one at the face's texture_mins; between them light is linear in s and t, and outside it is
// that of the border. A face without samples is black (full-bright faces have another FaceKind).
using Light = std::array<double, 3>;
enum class LightColor { kGray, kRgb };
Light sample_light(const world::Level& level, const world::Face& face, const world::LightStyleValues& styles,
                   TexelPosition position, LightColor color);

// Row of the colormap for gray light: darker rows have larger numbers.
int colormap_row(double light);

}  // namespace temblor::oracle
