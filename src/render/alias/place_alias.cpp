#include "render/alias/place_alias.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "render/alias/vertex_kernels.h"

namespace temblor::render {

namespace {

// An affine transform.
struct Affine {
  math::Vec3d columns[3], offset;
  math::Vec3d operator()(const math::Vec3d& p) const {
    return columns[0] * p.x + columns[1] * p.y + columns[2] * p.z + offset;
  }
};

// Model space to view space.
Affine model_to_view(const ViewFrame& view, const AliasInstance& instance, const AliasPlacement& axes) {
  const auto direction = [&](const math::Vec3d& world) {
    return math::Vec3d(glm::dot(world, view.axes.right), glm::dot(world, view.axes.up),
                       glm::dot(world, view.axes.forward)) *
           double{instance.scale};
  };
  return {{direction(axes.x_axis), direction(axes.y_axis), direction(axes.z_axis)},
          view.to_view(math::Vec3d(instance.origin_world))};
}

// The projection of the eight corners of an instance's box.
struct BoxOnScreen {
  bool finite = true;
  double min_z = std::numeric_limits<double>::infinity(), max_z = -min_z;
  math::Vec2d mins{std::numeric_limits<double>::infinity()}, maxs{-std::numeric_limits<double>::infinity()};
};

BoxOnScreen project_box(const ViewFrame& view, const Affine& to_view, const math::Bounds& bounds,
                        const AliasPlacement& placement) {
  BoxOnScreen box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const math::Vec3d p =
        to_view({corner & 1 ? bounds.maxs.x : bounds.mins.x, corner & 2 ? bounds.maxs.y : bounds.mins.y,
                 corner & 4 ? bounds.maxs.z : bounds.mins.z});
    for (int axis = 0; axis < 3; ++axis) box.finite &= std::abs(p[axis]) < kMaxCorner;
    box.min_z = std::min(box.min_z, p.z);
    box.max_z = std::max(box.max_z, p.z);
    // Corners behind the near plane are projected as if on it. If the box crosses the plane, place_alias
    // ignores the rectangle, since the box may then appear anywhere.
    const double scale = placement.perspective
                             ? placement.pixels_per_unit / std::max(p.z, double{placement.near_z})
                             : placement.pixels_per_unit;
    const math::Vec2d screen{view.center_x + p.x * scale, view.center_y - p.y * scale};
    box.mins = glm::min(box.mins, screen);
    box.maxs = glm::max(box.maxs, screen);
  }
  return box;
}

// Whether all corners of the box are outside the same side of the view.
bool is_outside(const ViewFrame& view, const Affine& to_view, const math::Bounds& bounds,
                const AliasPlacement& placement) {
  const double scale = placement.pixels_per_unit;
  const auto outside = [&](auto distance) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const math::Vec3d p =
          to_view({corner & 1 ? bounds.maxs.x : bounds.mins.x, corner & 2 ? bounds.maxs.y : bounds.mins.y,
                   corner & 4 ? bounds.maxs.z : bounds.mins.z});
      // Pixels off the side, times z in perspective.
      if (distance(p, placement.perspective ? p.z : 1.0) >= 0) return false;
    }
    return true;
  };
  return outside([&](const math::Vec3d& p, double w) { return p.x * scale + (view.center_x + 1) * w; }) ||
         outside([&](const math::Vec3d& p, double w) {
           return (view.width - view.center_x) * w - p.x * scale;
         }) ||
         outside([&](const math::Vec3d& p, double w) { return (view.center_y + 1) * w - p.y * scale; }) ||
         outside(
             [&](const math::Vec3d& p, double w) { return p.y * scale + (view.height - view.center_y) * w; });
}

// The view model is always drawn in perspective.
void set_projection(const ViewFrame& view, AliasRole role, AliasPlacement& io_placement) {
  io_placement.perspective = view.perspective || role == AliasRole::kViewWeapon;
  io_placement.near_z = static_cast<float>(view.near_z);
  io_placement.pixels_per_unit = static_cast<float>(view.pixels_per_unit);
  io_placement.depth_scale = 1;
  if (role != AliasRole::kViewWeapon) return;
  io_placement.pixels_per_unit = static_cast<float>(view.weapon_pixels_per_unit);
  io_placement.depth_scale = kWeaponDepthScale;
}

// Combines the decoding of poses (scale and origin) with the transform to view space.
void set_to_view(const AliasModel& model, const Affine& to_view, AliasPlacement& io_placement) {
  const math::Vec3d scale(model.scale);
  const math::Vec3d offset = to_view(math::Vec3d(model.origin));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      io_placement.to_view[row][column] = static_cast<float>(to_view.columns[column][row] * scale[column]);
    io_placement.to_view[row][3] = static_cast<float>(offset[row]);
  }
}

int inside(double pixels, int size) {
  return static_cast<int>(std::clamp(pixels, 0.0, static_cast<double>(size)));
}

}  // namespace

std::optional<AliasPlacement> place_alias(const ViewFrame& view, const AliasInstance& instance,
                                          AliasRole role) {
  const AliasModel& model = *instance.model;
  CHECK(base::to_size(instance.from_pose) < model.pose_count() &&
            base::to_size(instance.to_pose) < model.pose_count() && instance.skin < model.picture_count(),
        "{}: poses {} and {}, skin {}", model.name, base::to_size(instance.from_pose),
        base::to_size(instance.to_pose), instance.skin);
  AliasPlacement placement{};
  placement.instance = &instance;
  const math::Vec3& angles = instance.angles_deg;
  const math::Basis basis = math::basis_from_angles({-angles.x, angles.y, angles.z});
  placement.x_axis = basis.forward;
  placement.y_axis = -basis.right;
  placement.z_axis = basis.up;
  set_projection(view, role, placement);

  const Affine to_view = model_to_view(view, instance, placement);
  const BoxOnScreen box = project_box(view, to_view, model.bounds, placement);
  if (!box.finite || box.max_z < placement.near_z) return std::nullopt;
  if (is_outside(view, to_view, model.bounds, placement)) return std::nullopt;
  set_to_view(model, to_view, placement);
  const bool crosses_near = box.min_z < placement.near_z;
  const bool beyond_guard = glm::any(glm::lessThan(box.mins, math::Vec2d(-kGuardPixels))) ||
                            glm::any(glm::greaterThan(box.maxs, math::Vec2d(kGuardPixels)));
  placement.needs_clipping = crosses_near || beyond_guard;
  placement.inside_screen = !placement.needs_clipping && box.mins.x >= 1 && box.mins.y >= 1 &&
                            box.maxs.x <= view.width - 2 && box.maxs.y <= view.height - 2;
  placement.row_end = view.height;
  placement.column_end = view.width;
  if (!crosses_near) {
    // Rounding may move a vertex out of the box by a hundredth of a pixel.
    placement.first_row = inside(box.mins.y - 1, view.height);
    placement.row_end = inside(box.maxs.y + 2, view.height);
    placement.first_column = inside(box.mins.x - 1, view.width);
    placement.column_end = inside(box.maxs.x + 2, view.width);
  }
  placement.largest_pixels_per_unit =
      placement.perspective ? placement.pixels_per_unit / std::max(box.min_z, double{placement.near_z})
                            : placement.pixels_per_unit;
  return placement;
}

}  // namespace temblor::render
