// A sprite's picture as it comes to the screen: four corners, and what lies under each pixel.
#pragma once

#include <array>
#include <optional>

#include "render/view/view_frame.h"

namespace temblor::render {

// A convex outline: a quad's corners, and one more where the near plane cuts one off.
struct SpriteOutline {
  std::array<math::Vec2d, 5> corners;  // screen, in order
  std::size_t count = 0;
};

struct SpriteQuad {
  const formats::SprPicture* picture = nullptr;
  float alpha = 1;
  SpriteOutline outline;
  int first_row = 0, end_row = 0;  // of the picture drawn to; within it
  // On the screen: ViewFrame::depth, and texels from the picture's left and top edge; texels times 1/z in
  // perspective, unless the depth is the same everywhere.
  ScreenPlane depth, s, t;
  bool affine = false;  // s and t are texels as they are
};

// Where and how a picture hangs in the world: `right` and `up` have the length of one of its units.
struct SpriteAxes {
  math::Vec3d right, up;
};

// By the sprite's orientation, the instance's scale included. Nothing for an upright one seen from within a
// degree of straight above or below: it has no width there.
std::optional<SpriteAxes> sprite_axes(const ViewFrame& view, const SpriteInstance& sprite);

// Nothing when none of it can be seen: behind the near plane, beside the screen, edge-on, or of no size. Both
// sides of an oriented sprite are seen.
std::optional<SpriteQuad> make_sprite_quad(const ViewFrame& view, const SpriteInstance& sprite);

}  // namespace temblor::render
