#include "lab/space_battle/solid_edges.h"

#include <algorithm>
#include <limits>

#include "render/edges/edge_crossing.h"
#include "render/frame_buffer.h"

namespace temblor::lab::space {

namespace {

using math::Vec2d;
using math::Vec3d;
using render::kBackground;

// A face is left out if the eye is nearer than this to its plane, in front or behind: it would be a line on
// the screen, and its 1/z would be meaningless.
constexpr double kEdgeOn = 1e-6;

const Vec3d kToSun = glm::normalize(Vec3d{-0.5, 0.6, 0.7});
constexpr double kAmbient = 0.2;

// 1/z of the plane normal . p = distance, in view space. A pixel's ray is z * (x, y, 1), so
// 1/z = normal . (x, y, 1) / distance.
render::ScreenPlane find_depth(const BattleView& view, const Vec3d& normal, double distance) {
  render::ScreenPlane depth;
  depth.dx = normal.x / (view.pixels_per_unit * distance);
  depth.dy = -normal.y / (view.pixels_per_unit * distance);
  depth.at_origin = normal.z / distance - depth.dx * view.center_x - depth.dy * view.center_y;
  return depth;
}

}  // namespace

std::uint32_t light_face(const formats::Rgb& color, const Vec3d& normal_world) {
  const double factor = kAmbient + (1 - kAmbient) * (0.5 + 0.5 * glm::dot(normal_world, kToSun));
  const auto channel = [&](std::uint8_t value) { return static_cast<std::uint8_t>(value * factor); };
  return render::to_rgb({channel(color.r), channel(color.g), channel(color.b)});
}

Vec3d turn_solid(const math::Basis& axes, const Vec3d& model) {
  return axes.forward * model.x - axes.right * model.y + axes.up * model.z;
}

SolidEdges::SolidEdges(const BattleView& view, base::Arena& arena)
    : view_(view),
      arena_(arena),
      depths_(arena, 4096),
      colors_(arena, 4096),
      edges_(arena, 8192),
      edges_by_row_(arena.allocate_filled<std::uint32_t>(static_cast<std::size_t>(view.height), 0)),
      corners_(arena, 64),
      surfaces_(arena, 64),
      outline_(arena, 64) {
  depths_.push_back({std::numeric_limits<double>::lowest(), 0, 0});
  colors_.push_back(0xff000000);
}

void SolidEdges::add(const Solid& solid, const Placement& placement, const formats::Rgb& color) {
  const Vec3d center_view = view_.turn_to_view(placement.center - view_.eye);
  if (!view_.can_see(center_view, solid.radius)) return;
  place_corners(solid, placement, center_view);
  add_surfaces(solid, placement, color);
  for (std::size_t face = 0; face < solid.faces.size(); ++face) {
    if (surfaces_[face] == kBackground) continue;
    clip_face(solid, solid.faces[face]);
    add_outline(surfaces_[face]);
  }
}

void SolidEdges::place_corners(const Solid& solid, const Placement& placement, const Vec3d& center_view) {
  const math::Basis axes_view{view_.turn_to_view(placement.axes.forward),
                              view_.turn_to_view(placement.axes.right),
                              view_.turn_to_view(placement.axes.up)};
  corners_.clear();
  for (const Vec3d& corner : solid.corners) {
    Corner placed{center_view + turn_solid(axes_view, corner), Vec2d(0.0)};
    if (is_before(placed)) placed.screen = view_.to_screen(placed.view);
    corners_.push_back(placed);
  }
}

void SolidEdges::add_surfaces(const Solid& solid, const Placement& placement, const formats::Rgb& color) {
  const Vec3d to_center = placement.center - view_.eye;
  surfaces_.clear();
  for (const SolidFace& face : solid.faces) {
    const Vec3d normal_world = turn_solid(placement.axes, face.normal);
    // From the eye to the face's plane, along its normal: negative if it shows its front.
    const double distance = face.distance + glm::dot(normal_world, to_center);
    surfaces_.push_back(kBackground);
    if (distance > -kEdgeOn) continue;
    surfaces_.back() = base::to_index<Surface>(depths_.size());
    depths_.push_back(find_depth(view_, view_.turn_to_view(normal_world), distance));
    colors_.push_back(light_face(color, normal_world));
  }
}

// Where the outline passes behind the near plane, it continues along that plane to the point at which it
// comes back.
void SolidEdges::clip_face(const Solid& solid, const SolidFace& face) {
  const std::span<const SolidSide> sides = solid.list_sides(face);
  outline_.clear();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Corner &here = corners_[sides[i].corner],
                 &next = corners_[sides[i + 1 < sides.size() ? i + 1 : 0].corner];
    const Surface across = surfaces_[sides[i].neighbor];
    if (is_before(here)) outline_.push_back({here.screen, across});
    if (is_before(here) == is_before(next)) continue;
    // From the end behind the plane, so that both faces at this side get the same point.
    const Corner &behind = is_before(here) ? next : here, &before = is_before(here) ? here : next;
    const double share = (view_.near_z - behind.view.z) / (before.view.z - behind.view.z);
    Vec3d crossing = behind.view + (before.view - behind.view) * share;
    crossing.z = view_.near_z;
    outline_.push_back({view_.to_screen(crossing), is_before(here) ? kBackground : across});
  }
}

// The face with the smaller number makes the edge that two faces share.
void SolidEdges::add_outline(Surface inside) {
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const OutlineCorner& here = outline_[i];
    if (here.across != kBackground && here.across < inside) continue;
    add_edge(here.screen, outline_[i + 1 < outline_.size() ? i + 1 : 0].screen, inside, here.across);
  }
}

// Rows y with top.y <= y < bottom.y belong to the edge, so that an outline covers each row an even number of
// times.
void SolidEdges::add_edge(const Vec2d& start, const Vec2d& end, Surface inside, Surface across) {
  const bool runs_down = start.y < end.y;
  const Vec2d &top = runs_down ? start : end, &bottom = runs_down ? end : start;
  const double height = view_.height;
  if (!(top.y <= height - 1 && bottom.y > 0)) return;
  render::Edge edge;
  edge.first_row = render::first_pixel(std::max(top.y, 0.0));
  edge.last_row = render::first_pixel(std::min(bottom.y, height)) - 1;
  if (edge.first_row > edge.last_row) return;
  edge.step = (bottom.x - top.x) / (bottom.y - top.y);
  // Rounding must not carry a nearly level edge past its ends.
  const auto [left, right] = std::minmax(top.x, bottom.x);
  edge.x_first = std::clamp(top.x + (edge.first_row - top.y) * edge.step, left, right);
  if (left > view_.width - 1) return;  // the scan stops before it
  if (right <= 0) edge.x_first = edge.step = 0;
  // Clockwise, a side that runs down has its face to the left.
  edge.leading = runs_down ? across : inside;
  edge.trailing = runs_down ? inside : across;
  edges_.push_back(edge);
  ++edges_by_row_[static_cast<std::size_t>(edge.first_row)];
}

SceneEdges SolidEdges::finish() {
  const std::size_t height = edges_by_row_.size();
  const std::span<std::uint32_t> row_begin = arena_.allocate<std::uint32_t>(height + 1);
  row_begin[0] = 0;
  for (std::size_t row = 0; row < height; ++row) row_begin[row + 1] = row_begin[row] + edges_by_row_[row];
  // Places for the edges of each row, filled from the last to the first.
  const std::span<std::uint32_t> order = arena_.allocate<std::uint32_t>(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const std::size_t row = static_cast<std::size_t>(edges_[i].first_row);
    order[row_begin[row] + --edges_by_row_[row]] = static_cast<std::uint32_t>(i);
  }
  const std::span<render::ScreenSurface> surfaces =
      arena_.allocate_filled<render::ScreenSurface>(depths_.size(), {});
  for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i].first_draw = static_cast<std::uint32_t>(i);
  SceneEdges scene;
  scene.table.edges = edges_.view();
  scene.table.order = order;
  scene.table.row_begin = row_begin;
  scene.table.surfaces = surfaces;
  scene.table.draw_count = static_cast<std::uint32_t>(surfaces.size());
  scene.depths = depths_.view();
  scene.colors = colors_.view();
  return scene;
}

}  // namespace temblor::lab::space
