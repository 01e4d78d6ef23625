#include "render/edges/edge_emitter.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace temblor::render {

namespace {

// Whether a side runs down the screen. Level sides cross no row, so their direction does not matter.
bool runs_down(const math::Vec2d& start, const math::Vec2d& end) {
  return start.y < end.y;
}

// y is at least 0. (std::ceil would be a function call on processors without SSE 4.1.)
std::int32_t ceil_to_row(double y) {
  const std::int32_t whole = static_cast<std::int32_t>(y);
  return whole + (y > whole ? 1 : 0);
}

}  // namespace

EdgeEmitter::EdgeEmitter(const ViewFrame& view, base::Arena& arena)
    : view_(view),
      arena_(arena),
      corners_(arena, 64),
      screen_corners_(arena, 2048),
      corner_end_(arena, 512),
      surfaces_(arena, 512),
      fragments_(arena, 64) {}

EdgeEmitter::Corner EdgeEmitter::project(const math::Vec3d& world, world::FaceIndex neighbor) const {
  Corner corner{view_.to_view(world), math::Vec2d(0.0), kClipNear, neighbor};
  if (corner.view.z < view_.near_z) return corner;
  corner.screen = view_.to_screen(corner.view);
  corner.beyond =
      (corner.screen.x < 0 ? kClipLeft : 0) | (corner.screen.x > view_.width - 1 ? kClipRight : 0) |
      (corner.screen.y < 0 ? kClipTop : 0) | (corner.screen.y > view_.height - 1 ? kClipBottom : 0);
  return corner;
}

// Always computed from the end behind the plane: neighbors have the side in opposite directions and must get
// exactly the same point.
math::Vec2d EdgeEmitter::cross_near(const Corner& a, const Corner& b) const {
  const auto& [behind, before] =
      (a.beyond & kClipNear) != 0 ? std::pair(a.view, b.view) : std::pair(b.view, a.view);
  const double t = (view_.near_z - behind.z) / (before.z - behind.z);
  math::Vec3d crossing = behind + (before - behind) * t;
  crossing.z = view_.near_z;
  return view_.to_screen(crossing);
}

void EdgeEmitter::add_outline(Beyond beyond) {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner& here = corners_[i];
    if ((here.beyond & kClipNear) == 0) screen_corners_.push_back({here.screen, here.neighbor});
    if ((beyond.any & kClipNear) == 0) continue;
    // Where the outline passes behind the near plane, it is closed along that plane, up to the point where it
    // comes back. The closing side has no neighbor.
    const Corner& next = corners_[i + 1 < corners_.size() ? i + 1 : 0];
    if (((here.beyond ^ next.beyond) & kClipNear) == 0) continue;
    const bool comes_back = (here.beyond & kClipNear) != 0;
    screen_corners_.push_back({cross_near(here, next), comes_back ? here.neighbor : kNoNeighbor});
  }
  corner_end_.push_back(static_cast<std::uint32_t>(screen_corners_.size()));
}

void EdgeEmitter::add_surface(SortKey key, std::uint32_t instance, world::FaceIndex face, TileGrid tiles,
                              std::uint32_t fragment, float nearest_z) {
  surfaces_.push_back({key, instance, face, draw_count_, tiles, fragment, nearest_z});
  draw_count_ += static_cast<std::uint32_t>(tiles.s) * tiles.t;
}

void EdgeEmitter::add_world_face(const VisibleFace& visible, const FaceOutlines& outlines) {
  const FaceOutline& outline = outlines.faces[base::to_size(visible.face)];
  Beyond beyond;
  double nearest_z = std::numeric_limits<double>::max();
  corners_.clear();
  for (std::uint32_t i = 0; i < outline.corner_count; ++i) {
    const OutlineCorner& corner = outlines.corners[outline.first_corner + i];
    corners_.push_back(project(math::Vec3d(corner.position), corner.neighbor));
    beyond.add(corners_.back().beyond);
    nearest_z = std::min(nearest_z, corners_.back().view.z);
  }
  if (beyond.all != 0) return;
  add_surface(visible.key, 0, visible.face, outline.tiles, 0,
              beyond.any == 0 ? static_cast<float>(nearest_z) : 0);
  add_outline(beyond);
}

void EdgeEmitter::add_fragment(std::span<const math::Vec3d> corners_world, std::uint32_t instance,
                               world::FaceIndex face, TileGrid tiles, SortKey key, const ScreenPlane& depth) {
  Beyond beyond;
  corners_.clear();
  for (const math::Vec3d& corner : corners_world) {
    corners_.push_back(project(corner, kNoNeighbor));
    beyond.add(corners_.back().beyond);
  }
  if (beyond.all != 0) return;
  add_surface(key, instance, face, tiles, static_cast<std::uint32_t>(fragments_.size()), 0);
  fragments_.push_back({depth});
  add_outline(beyond);
}

// Only the near plane is clipped to as a polygon. Rows outside the screen are cut off here; x needs no
// clipping, because `crossing` clamps it to the left border and the scan stops at the right one.
void EdgeEmitter::make_edge(const math::Vec2d& start, const math::Vec2d& end, SurfaceIndex inside,
                            SurfaceIndex across) {
  const bool down = runs_down(start, end);
  // From the upper end, so that a line yields the same numbers in either direction.
  const math::Vec2d &top = down ? start : end, &bottom = down ? end : start;
  const std::int32_t last_screen_row = view_.height - 1;
  if (!(top.y <= last_screen_row && bottom.y > 0)) return;
  Edge edge;
  edge.first_row = top.y > 0 ? ceil_to_row(top.y) : 0;
  edge.last_row = bottom.y > last_screen_row ? last_screen_row : ceil_to_row(bottom.y) - 1;
  if (edge.first_row > edge.last_row) return;
  edge.step = (bottom.x - top.x) / (bottom.y - top.y);
  // A nearly level edge has a huge step: rounding must not carry x past the ends of the side.
  const auto [left, right] = std::minmax(top.x, bottom.x);
  edge.x_first = std::clamp(top.x + (edge.first_row - top.y) * edge.step, left, right);
  const double x_last = edge.x_first + edge.step * (edge.last_row - edge.first_row);
  // Edges right of the screen change nothing. Edges left of it do: their surface begins at x = 0.
  if (edge.x_first > view_.width - 1 && x_last > view_.width - 1) return;
  if (edge.x_first <= 0 && x_last <= 0) edge.x_first = edge.step = 0;
  edge.leading = down ? across : inside;
  edge.trailing = down ? inside : across;
  edges_.push_back(edge);
  ++edges_by_row_[static_cast<std::size_t>(edge.first_row)];
}

void EdgeEmitter::make_edges(SurfaceIndex first, std::span<const SurfaceIndex> surface_of_face) {
  edges_ = base::ArenaVector<Edge>(arena_, screen_corners_.size());
  edges_by_row_ = arena_.allocate_filled<std::uint32_t>(static_cast<std::size_t>(view_.height), 0);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const SurfaceIndex surface = base::to_index<SurfaceIndex>(base::to_size(first) + i);
    // Deferred faces share no edges. A file may also list a face twice in its tree: then only the last of its
    // surfaces shares edges.
    const bool shares = surface_of_face[base::to_size(surfaces_[i].face)] == surface;
    const std::size_t end = corner_end_[i];
    for (std::size_t corner = begin; corner < end; ++corner) {
      const ScreenCorner& here = screen_corners_[corner];
      SurfaceIndex across = kBackground;
      if (shares && here.neighbor != kNoNeighbor) {
        across = surface_of_face[base::to_size(here.neighbor)];
        // The neighbor made this edge already.
        if (across != kBackground && across < surface) continue;
      }
      make_edge(here.at, screen_corners_[corner + 1 < end ? corner + 1 : begin].at, surface, across);
    }
    begin = end;
  }
}

}  // namespace temblor::render
