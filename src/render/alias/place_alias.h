// The placement of an alias model instance: the transform of its vertices to view space, and whether it can
// be visible at all, which is decided from the bounding box of all poses.
#pragma once

#include <optional>

#include "render/alias/alias_mesh.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// The view model's 1/z is multiplied by this. It reaches at most 256 units, so it is nearer than the level's
// nearest point, 1 / kNearPlane.
constexpr float kWeaponDepthScale = 4096;
// Units from the eye. Instances that reach farther are not drawn: floats would no longer resolve their parts.
constexpr double kMaxCorner = 1 << 24;

// The view model has a projection and a depth range of its own.
enum class AliasRole { kWorld, kViewWeapon };

// An instance that may be visible.
struct AliasPlacement {
  const AliasInstance* instance;
  math::Vec3d x_axis, y_axis, z_axis;  // the model's axes in world space, of length 1
  float to_view[3][4];                 // elements of a pose to view space, as in VertexJob
  float pixels_per_unit, depth_scale;
  float near_z;
  bool perspective;
  // Some vertex may be too near, or too far to the side, to be projected: triangles must be clipped.
  bool needs_clipping;
  bool inside_screen;  // the whole box is
  // The rectangle of the picture that the box touches; ends are exclusive.
  int first_row, row_end, first_column, column_end;
  double largest_pixels_per_unit;  // at the box's nearest point
};

// Nothing if the box is outside the view. CHECKs that poses and skin exist in the model.
std::optional<AliasPlacement> place_alias(const ViewFrame& view, const AliasInstance& instance,
                                          AliasRole role);

}  // namespace temblor::render
