// One brush model where it stands now: model space <-> world space, asked once a frame.
#pragma once

#include "render/view/view_frame.h"

namespace temblor::render {

struct ModelView {
  math::Vec3d origin_world{0.0};
  math::Vec3d x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};  // the model's own axes, in the world

  math::Vec3d direction_to_world(const math::Vec3d& v) const {
    return x_axis * v.x + y_axis * v.y + z_axis * v.z;
  }
  math::Vec3d to_world(const math::Vec3d& p) const { return origin_world + direction_to_world(p); }
};

ModelView make_model_view(const BrushModelInstance& instance);

// A face's plane in the world, wherever its model stands. It looks where the face does.
struct FacePlane {
  math::Vec3d normal;
  double distance;
};

FacePlane place_plane(const world::Level& level, const world::Face& face, const ModelView& model_view);

// And its texture axes.
struct FacePlacement : FacePlane {
  math::Vec3d s_axis, t_axis;  // texels a unit
  double s_offset, t_offset;   // from the surface's first texel (Face::texture_mins)
};

FacePlacement place_face(const world::Level& level, const world::Face& face, const ModelView& model_view);

// How far the eye stands in front of the face's plane; seen in parallel, the cosine towards the eye. Not
// positive: its back is seen.
double facing(const ViewFrame& view, const math::Vec3d& normal, double distance);

}  // namespace temblor::render
