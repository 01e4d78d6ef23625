#include "render/sprites/sprite_quad.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"

namespace temblor::render {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// The axes of an upright picture that faces `direction`, which need not be level.
std::optional<SpriteAxes> upright_across(const math::Vec3d& direction) {
  if (std::abs(direction.z) > std::cos(kDegree) * glm::length(direction)) return std::nullopt;
  const double level = std::hypot(direction.x, direction.y);
  if (!(level > 0)) return std::nullopt;  // the eye is at the sprite's origin
  return SpriteAxes{{direction.y / level, -direction.x / level, 0}, {0, 0, 1}};
}

// Positive roll turns the picture counterclockwise.
SpriteAxes rolled(const math::Basis& axes, double roll_deg) {
  const double sine = std::sin(roll_deg * kDegree), cosine = std::cos(roll_deg * kDegree);
  return {axes.right * cosine + axes.up * sine, axes.up * cosine - axes.right * sine};
}

// The five orientation types of SPR files.
std::optional<SpriteAxes> unit_axes(const ViewFrame& view, const SpriteInstance& sprite) {
  switch (sprite.sprite->orientation) {
    case formats::SprOrientation::kParallelUpright:
      return upright_across(view.axes.forward);
    case formats::SprOrientation::kFacingUpright:
      return upright_across(view.perspective ? math::Vec3d(sprite.origin_world) - view.eye_world
                                             : view.axes.forward);
    case formats::SprOrientation::kParallel:
      return SpriteAxes{view.axes.right, view.axes.up};
    case formats::SprOrientation::kOriented: {
      const math::Basis own = math::basis_from_angles(sprite.angles_deg);
      return SpriteAxes{own.right, own.up};
    }
    case formats::SprOrientation::kParallelOriented:
      return rolled(view.axes, sprite.angles_deg.z);
  }
  return std::nullopt;
}

// Clips the quad to the near plane and projects it.
SpriteOutline clip_and_project(const ViewFrame& view, const std::array<math::Vec3d, 4>& corners_view) {
  SpriteOutline outline;
  for (std::size_t i = 0; i < corners_view.size(); ++i) {
    const math::Vec3d &from = corners_view[i], &to = corners_view[(i + 1) % corners_view.size()];
    const bool from_inside = from.z >= view.near_z, to_inside = to.z >= view.near_z;
    if (from_inside) outline.corners[outline.count++] = view.to_screen(from);
    if (from_inside == to_inside) continue;
    math::Vec3d border = from + (to - from) * ((view.near_z - from.z) / (to.z - from.z));
    border.z = view.near_z;
    outline.corners[outline.count++] = view.to_screen(border);
  }
  return outline;
}

// Sets the range of rows whose centers are between the outline's top and bottom.
void find_rows(const ViewFrame& view, SpriteQuad& io_quad) {
  double top = view.height, bottom = 0;
  for (std::size_t i = 0; i < io_quad.outline.count; ++i) {
    top = std::min(top, io_quad.outline.corners[i].y);
    bottom = std::max(bottom, io_quad.outline.corners[i].y);
  }
  io_quad.first_row = static_cast<int>(std::ceil(std::max(top, 0.0)));
  io_quad.end_row = static_cast<int>(std::ceil(std::min<double>(bottom, view.height)));
}

bool is_beside_screen(const ViewFrame& view, const SpriteOutline& outline) {
  bool all_left = true, all_right = true;
  for (std::size_t i = 0; i < outline.count; ++i) {
    all_left &= outline.corners[i].x <= 0;
    all_right &= outline.corners[i].x >= view.width;
  }
  return all_left || all_right;
}

bool is_finite_vector(const math::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::optional<SpriteAxes> sprite_axes(const ViewFrame& view, const SpriteInstance& sprite) {
  std::optional<SpriteAxes> axes = unit_axes(view, sprite);
  if (axes) {
    axes->right *= static_cast<double>(sprite.scale);
    axes->up *= static_cast<double>(sprite.scale);
  }
  return axes;
}

std::optional<SpriteQuad> make_sprite_quad(const ViewFrame& view, const SpriteInstance& sprite) {
  CHECK(sprite.sprite != nullptr && sprite.picture != nullptr);
  const formats::SprPicture& picture = *sprite.picture;
  CHECK(picture.texels.size() == std::size_t{picture.width} * picture.height, "{} texels of {}x{}",
        picture.texels.size(), picture.width, picture.height);
  if (!is_finite_vector(sprite.origin_world) || !is_finite_vector(sprite.angles_deg) || !(sprite.scale > 0) ||
      !std::isfinite(sprite.scale))
    return std::nullopt;
  const std::optional<SpriteAxes> axes = sprite_axes(view, sprite);
  if (!axes) return std::nullopt;

  const math::Vec3d origin(sprite.origin_world);
  const math::Vec3d normal = glm::normalize(glm::cross(axes->right, axes->up));
  const double distance = glm::dot(normal, origin);
  const double from_eye =
      view.perspective ? distance - glm::dot(normal, view.eye_world) : glm::dot(normal, view.axes.forward);
  if (std::abs(from_eye) < kEdgeOn) return std::nullopt;

  SpriteQuad quad;
  quad.picture = &picture;
  quad.alpha = sprite.alpha;
  const double left = picture.left, right = left + picture.width;
  const double top = picture.up, bottom = top - picture.height;
  const auto corner = [&](double x, double y) {
    return view.to_view(origin + axes->right * x + axes->up * y);
  };
  quad.outline = clip_and_project(
      view, {corner(left, top), corner(right, top), corner(right, bottom), corner(left, bottom)});
  if (quad.outline.count < 3 || is_beside_screen(view, quad.outline)) return std::nullopt;
  find_rows(view, quad);
  if (quad.first_row >= quad.end_row) return std::nullopt;

  // A texel is `scale` units long; dividing the axes by its square maps world units to texels.
  const double units = 1.0 / (static_cast<double>(sprite.scale) * static_cast<double>(sprite.scale));
  const math::Vec3d s_axis = axes->right * units, t_axis = axes->up * -units;
  const bool parallel = std::abs(glm::dot(normal, view.axes.forward)) > 1.0 - 1e-12;
  quad.depth = depth_plane(view, normal, distance);
  if (parallel) {  // set exactly: rounding would tilt the plane
    quad.depth = {view.depth(view.to_view(origin).z), 0, 0};
  }
  quad.s = coordinate_plane(view, quad.depth, s_axis, -glm::dot(s_axis, origin) - left);
  quad.t = coordinate_plane(view, quad.depth, t_axis, -glm::dot(t_axis, origin) + top);
  quad.affine = !view.perspective || parallel;
  if (view.perspective && parallel)
    for (ScreenPlane* plane : {&quad.s, &quad.t}) {
      plane->at_origin /= quad.depth.at_origin;
      plane->dx /= quad.depth.at_origin;
      plane->dy /= quad.depth.at_origin;
    }
  return quad;
}

}  // namespace temblor::render
