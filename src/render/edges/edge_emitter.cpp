#include "render/edges/edge_emitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace temblor::render {

namespace {

// Whether a line from start to end runs down the screen. Level ones cross no row.
bool runs_down(const math::Vec2d& start, const math::Vec2d& end) {
  return start.y < end.y;
}

// An outline that goes behind the near plane is closed along that plane, from where it left to where it comes
// back. A concave one may do so several times.
class NearPlaneGaps {
 public:
  struct Gap {
    math::Vec2d from, to;
  };
  void leave(const math::Vec2d& at) {
    left_at_ = at;
    outside_ = true;
  }
  std::optional<Gap> come_back(const math::Vec2d& at) {
    if (std::exchange(outside_, false)) return Gap{left_at_, at};
    first_return_ = at;  // the walk began behind the plane
    return std::nullopt;
  }
  std::optional<Gap> finish() const {
    return outside_ ? std::optional(Gap{left_at_, first_return_}) : std::nullopt;
  }

 private:
  math::Vec2d left_at_{}, first_return_{};
  bool outside_ = false;
};

}  // namespace

bool has_surface(const world::Face& face) {
  return face.kind == world::FaceKind::kLit && face.light != world::kNoLight;
}

TileGrid tile_grid(const world::Face& face) {
  if (!has_surface(face)) return {};
  const auto across = [](std::int32_t extent) {
    return static_cast<std::uint16_t>(std::max(1, (extent + kTileTexels - 1) / kTileTexels));
  };
  return {across(face.texture_extents[0]), across(face.texture_extents[1])};
}

EdgeEmitter::EdgeEmitter(const world::Level& level, const ViewFrame& view, base::Arena& arena)
    : level_(level),
      view_(view),
      arena_(arena),
      vertices_(arena.allocate<ScreenVertex>(level.vertices.size())),
      vertex_ready_(arena.allocate_filled<std::uint8_t>(level.vertices.size(), 0)),
      edge_of_bsp_(arena.allocate_filled<std::uint32_t>(level.edges.size(), kNotMade)),
      edges_(arena, 4096),
      surfaces_(arena, 1024),
      pieces_(arena, 64) {
  surfaces_.push_back({std::numeric_limits<SortKey>::max(), 0, world::FaceIndex{0}, 0, {}, 0, 0});
}

EdgeEmitter::ScreenVertex EdgeEmitter::project(const math::Vec3d& world) const {
  ScreenVertex v{view_.to_view(world), math::Vec2d(0.0), 0};
  if (v.view.z < view_.near_z) {
    v.beyond = kClipNear;
    return v;
  }
  v.screen = view_.to_screen(v.view);
  v.beyond = (v.screen.x < 0 ? kClipLeft : 0) | (v.screen.x > view_.width - 1 ? kClipRight : 0) |
             (v.screen.y < 0 ? kClipTop : 0) | (v.screen.y > view_.height - 1 ? kClipBottom : 0);
  return v;
}

const EdgeEmitter::ScreenVertex& EdgeEmitter::vertex(std::uint32_t index) {
  if (vertex_ready_[index] == 0) {
    vertices_[index] = project(math::Vec3d(level_.vertices[index]));
    vertex_ready_[index] = 1;
  }
  return vertices_[index];
}

EdgeEmitter::ClippedLine EdgeEmitter::clip_near(const ScreenVertex& start, const ScreenVertex& end) const {
  const bool start_behind = (start.beyond & kClipNear) != 0, end_behind = (end.beyond & kClipNear) != 0;
  if (start_behind && end_behind) return {{}, {}, false};
  if (!start_behind && !end_behind) return {start.screen, end.screen, true};
  const double t = (view_.near_z - start.view.z) / (end.view.z - start.view.z);
  math::Vec3d crossing = start.view + (end.view - start.view) * t;
  crossing.z = view_.near_z;
  const math::Vec2d at = view_.to_screen(crossing);
  return start_behind ? ClippedLine{at, end.screen, true} : ClippedLine{start.screen, at, true};
}

std::uint32_t EdgeEmitter::make_edge(const math::Vec2d& start, const math::Vec2d& end) {
  // Upper end first, so that the same line gives the same numbers whichever way it is walked.
  const auto [top, bottom] = runs_down(start, end) ? std::pair(start, end) : std::pair(end, start);
  const double last_screen_row = view_.height - 1;
  const double first = std::max(std::ceil(top.y), 0.0);
  const double last = std::min(std::ceil(bottom.y) - 1, last_screen_row);
  if (!(first <= last)) return kOffScreen;
  Edge edge;
  edge.first_row = static_cast<std::int32_t>(first);
  edge.last_row = static_cast<std::int32_t>(last);
  edge.step = (bottom.x - top.x) / (bottom.y - top.y);
  // An edge that is all but level has a step beyond all measure: rounding must not carry it past its ends.
  const auto [left, right] = std::minmax(top.x, bottom.x);
  edge.x_first = std::clamp(top.x + (first - top.y) * edge.step, left, right);
  edge.leading = edge.trailing = kBackground;
  const double x_last = edge.x_first + edge.step * (last - first);
  if (edge.x_first > view_.width - 1 && x_last > view_.width - 1) return kOffScreen;
  if (edge.x_first <= 0 && x_last <= 0) edge.x_first = edge.step = 0;
  edges_.push_back(edge);
  return static_cast<std::uint32_t>(edges_.size());
}

void EdgeEmitter::add_shared_edge(std::uint32_t bsp_edge, bool reversed, SurfaceIndex surface) {
  const formats::BspEdge& ends = level_.edges[bsp_edge];
  const ScreenVertex &start = vertex(ends.vertices[0]), &end = vertex(ends.vertices[1]);
  std::uint32_t& made = edge_of_bsp_[bsp_edge];
  if (made == kOffScreen) return;
  ClippedLine line{start.screen, end.screen, true};
  if (((start.beyond | end.beyond) & kClipNear) != 0) line = clip_near(start, end);
  if (made == kNotMade) {
    made = line.visible ? make_edge(line.start, line.end) : kOffScreen;
    if (made == kOffScreen) return;
  }
  const bool down = runs_down(line.start, line.end) != reversed;
  Edge& edge = edges_[made - 1];
  SurfaceIndex& side = down ? edge.trailing : edge.leading;
  if (side == kBackground) {
    side = surface;
    return;
  }
  // A third face at this edge, or two that look the same way: one more edge in the same place.
  Edge another = edge;
  another.leading = down ? kBackground : surface;
  another.trailing = down ? surface : kBackground;
  edges_.push_back(another);
}

void EdgeEmitter::add_own_edge(const math::Vec2d& start, const math::Vec2d& end, SurfaceIndex surface) {
  const std::uint32_t made = make_edge(start, end);
  if (made == kOffScreen) return;
  (runs_down(start, end) ? edges_[made - 1].trailing : edges_[made - 1].leading) = surface;
}

SurfaceIndex EdgeEmitter::add_surface(SortKey key, std::uint32_t instance, world::FaceIndex index,
                                      std::uint32_t piece, float nearest_z) {
  const TileGrid tiles = tile_grid(level_.face(index));
  surfaces_.push_back({key, instance, index, item_count_, tiles, piece, nearest_z});
  item_count_ += static_cast<std::uint32_t>(tiles.s) * tiles.t;
  return base::to_index<SurfaceIndex>(surfaces_.size() - 1);
}

void EdgeEmitter::add_world_face(const VisibleFace& visible) {
  const world::Face& face = level_.face(visible.face);
  int beyond_all = kClipAll, beyond_any = 0;
  double nearest_z = std::numeric_limits<double>::max();
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const ScreenVertex& corner = vertex(level_.surfedge_start(face.first_surfedge + i));
    beyond_all &= corner.beyond;
    beyond_any |= corner.beyond;
    nearest_z = std::min(nearest_z, corner.view.z);
  }
  if (beyond_all != 0) return;

  const SurfaceIndex surface =
      add_surface(visible.key, 0, visible.face, 0, beyond_any == 0 ? static_cast<float>(nearest_z) : 0);
  NearPlaneGaps gaps;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const std::int32_t surfedge = level_.surfedges[face.first_surfedge + i];
    const std::uint32_t edge = static_cast<std::uint32_t>(surfedge < 0 ? -surfedge : surfedge);
    add_shared_edge(edge, surfedge < 0, surface);
    if ((beyond_any & kClipNear) == 0) continue;

    const formats::BspEdge& ends = level_.edges[edge];
    const ScreenVertex &start = vertices_[ends.vertices[0]], &end = vertices_[ends.vertices[1]];
    if (((start.beyond ^ end.beyond) & kClipNear) == 0) continue;
    const ClippedLine line = clip_near(start, end);
    const bool start_behind = (start.beyond & kClipNear) != 0;
    const math::Vec2d crossing = start_behind ? line.start : line.end;
    if (start_behind == (surfedge < 0))  // walked this way, it goes behind
      gaps.leave(crossing);
    else if (const auto gap = gaps.come_back(crossing))
      add_own_edge(gap->from, gap->to, surface);
  }
  if (const auto gap = gaps.finish()) add_own_edge(gap->from, gap->to, surface);
}

void EdgeEmitter::add_piece(std::span<const math::Vec3d> corners_world, std::uint32_t instance,
                            world::FaceIndex face, SortKey key, const ScreenPlane& depth) {
  std::span<ScreenVertex> corners = arena_.allocate<ScreenVertex>(corners_world.size());
  int beyond_all = kClipAll;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = project(corners_world[i]);
    beyond_all &= corners[i].beyond;
  }
  if (beyond_all != 0) return;

  pieces_.push_back({depth});
  const SurfaceIndex surface =
      add_surface(key, instance, face, static_cast<std::uint32_t>(pieces_.size() - 1), 0);
  NearPlaneGaps gaps;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ScreenVertex &start = corners[i], &end = corners[(i + 1) % corners.size()];
    const ClippedLine line = clip_near(start, end);
    if (line.visible) add_own_edge(line.start, line.end, surface);
    if (((start.beyond ^ end.beyond) & kClipNear) == 0) continue;
    if ((end.beyond & kClipNear) != 0)
      gaps.leave(line.end);
    else if (const auto gap = gaps.come_back(line.start))
      add_own_edge(gap->from, gap->to, surface);
  }
  if (const auto gap = gaps.finish()) add_own_edge(gap->from, gap->to, surface);
}

EdgeTable EdgeEmitter::finish(std::span<const ModelView> model_views) {
  const std::size_t rows = static_cast<std::size_t>(view_.height);
  std::span<std::uint32_t> row_begin = arena_.allocate_filled<std::uint32_t>(rows + 2, 0);
  for (const Edge& edge : edges_) ++row_begin[static_cast<std::size_t>(edge.first_row) + 2];
  for (std::size_t row = 2; row < row_begin.size(); ++row) row_begin[row] += row_begin[row - 1];
  std::span<std::uint32_t> order = arena_.allocate<std::uint32_t>(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i)
    order[row_begin[static_cast<std::size_t>(edges_[i].first_row) + 1]++] = static_cast<std::uint32_t>(i);
  return {edges_.view(), order,      row_begin.first(rows + 1), surfaces_.view(), pieces_.view(),
          model_views,   item_count_};
}

}  // namespace temblor::render
