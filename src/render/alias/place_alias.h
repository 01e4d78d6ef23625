// An instance of a model where it stands now: how its vertices get to the screen, and whether any of it can
// be seen, told from its box alone.
#pragma once

#include <optional>

#include "render/alias/alias_mesh.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// The view weapon has this field of view (of a 4:3 picture) whatever the camera's, so that it looks the same
// in every one of them.
constexpr double kWeaponFovDeg = 90;
// Its 1/z is multiplied by this: at most 256 units long, it is nearer than the level's nearest, 1/kNearPlane.
constexpr float kWeaponDepthScale = 4096;
// Instances that reach farther from the eye, in units, are not drawn: floats no longer tell their parts.
constexpr double kMaxCorner = 1 << 24;

enum class AliasRole { kWorld, kViewWeapon };

struct AliasPlacement {
  const AliasInstance* instance;
  math::Vec3d x_axis, y_axis, z_axis;  // the model's, in the world, of length 1
  float to_view[3][4];                 // bytes of a pose to view space, as VertexJob has it
  float pixels_per_unit, depth_scale;
  float near_z;
  bool perspective;
  // Some vertex may be too near or too far to the side to be projected: triangles have to be clipped.
  bool needs_clipping;
  bool inside_screen;  // all of the box is
  // What the box touches, within the picture.
  int first_row, row_end, first_column, column_end;
  double largest_pixels_per_unit;  // at the box's nearest point
};

// Nothing when the box is outside the view. CHECKs that poses and skin are of the model.
std::optional<AliasPlacement> place_alias(const ViewFrame& view, const AliasInstance& instance,
                                          AliasRole role);

}  // namespace temblor::render
