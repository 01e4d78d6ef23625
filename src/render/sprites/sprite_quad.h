// The quad of a sprite: its corners on the screen, and linear functions that give depth and texel under each
// pixel.
#pragma once

#include <array>
#include <optional>

#include "render/view/view_frame.h"

namespace temblor::render {

// A convex outline: the four corners, and one more if the near plane cuts one off.
struct SpriteOutline {
  std::array<math::Vec2d, 5> corners;  // screen positions, in order
  std::size_t count = 0;
};

// A visible sprite, ready to be drawn.
struct SpriteQuad {
  const formats::SprPicture* picture = nullptr;
  float alpha = 1;
  SpriteOutline outline;
  int first_row = 0, end_row = 0;  // the rows of the frame that it touches; end exclusive
  // ViewFrame::depth, and texels from the left and upper edge of the sprite's picture. In perspective s and t
  // are multiplied by 1/z, unless the depth is constant.
  ScreenPlane depth, s, t;
  bool affine = false;  // true: s and t are plain texels
};

// The orientation of a sprite in world space; both vectors have the length of one unit of its picture.
struct SpriteAxes {
  math::Vec3d right, up;
};

// The axes for the sprite's orientation type, scaled by the instance's scale. Nothing for an upright sprite
// that is seen from within one degree of straight above or below, where it has no width.
std::optional<SpriteAxes> sprite_axes(const ViewFrame& view, const SpriteInstance& sprite);

// Nothing if no part can be visible: behind the near plane, beside the screen, edge-on, or of size zero.
// Oriented sprites are visible from both sides.
std::optional<SpriteQuad> make_sprite_quad(const ViewFrame& view, const SpriteInstance& sprite);

}  // namespace temblor::render
