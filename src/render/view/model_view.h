// The placement of a brush model: transforms from model space to world space, and the planes of its faces in
// world space. Computed once per instance and frame; the identity for the world itself.
#pragma once

#include <optional>

#include "render/view/view_frame.h"

namespace temblor::render {

// Rigid: a rotation and a translation, without scale.
struct ModelView {
  math::Vec3d origin_world{0.0};
  // The model's axes in world space, orthonormal.
  math::Vec3d x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

  math::Vec3d direction_to_world(const math::Vec3d& v) const {
    return x_axis * v.x + y_axis * v.y + z_axis * v.z;
  }
  math::Vec3d to_world(const math::Vec3d& p) const { return origin_world + direction_to_world(p); }
};

ModelView make_model_view(const BrushModelInstance& instance);

// A face's plane in world space: normal . p = distance. The normal points to the face's front, even where the
// file stores the face on the back side of its plane.
struct FacePlane {
  math::Vec3d normal;
  double distance;
};

FacePlane place_plane(const world::Level& level, const world::Face& face, const ModelView& model_view);

// A FacePlane with texture axes: s = s_axis . p + s_offset, and t likewise, in texels of mip 0.
struct FacePlacement : FacePlane {
  math::Vec3d s_axis, t_axis;  // texels per unit
  double s_offset, t_offset;   // so that 0 is the face's first texel (Face::texture_mins)
};

FacePlacement place_face(const world::Level& level, const world::Face& face, const ModelView& model_view);

// Steps along the plane of a face, in units, that move by one texel along one texture axis and by none along
// the other.
struct TexelSteps {
  math::Vec3d s, t;
};
// The inverse of the texture axes. Nothing if the axes are parallel on the plane.
std::optional<TexelSteps> find_texel_steps(const FacePlacement& placed);

// Perspective: the eye's distance in front of the plane, in units. Orthographic: the cosine between the
// plane's normal and the direction to the eye. Not positive: the back is visible.
double facing(const ViewFrame& view, const math::Vec3d& normal, double distance);

}  // namespace temblor::render
