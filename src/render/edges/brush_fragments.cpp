#include "render/edges/brush_fragments.h"

#include <array>

namespace temblor::render {

namespace {

// Units. A corner nearer to a plane than this lies on the plane, which avoids slivers.
constexpr double kOnPlane = 1.0 / 64;

using Corners = std::span<const math::Vec3d>;

struct Halves {
  Corners front, back;
};

// Cuts a polygon in two; a corner on the plane belongs to both halves. The cut point is always computed from
// the front corner to the back corner, so that two faces that share a side cut it at exactly the same point.
Halves split(Corners corners, const math::Vec3d& normal, double distance, base::Arena& arena) {
  base::ArenaVector<math::Vec3d> front(arena, corners.size() + 4), back(arena, corners.size() + 4);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const math::Vec3d &here = corners[i], &next = corners[(i + 1) % corners.size()];
    const double d_here = glm::dot(normal, here) - distance, d_next = glm::dot(normal, next) - distance;
    if (d_here >= -kOnPlane) front.push_back(here);
    if (d_here <= kOnPlane) back.push_back(here);
    if ((d_here > kOnPlane && d_next < -kOnPlane) || (d_here < -kOnPlane && d_next > kOnPlane)) {
      const bool here_in_front = d_here > 0;
      const math::Vec3d &a = here_in_front ? here : next, &b = here_in_front ? next : here;
      const double d_a = here_in_front ? d_here : d_next, d_b = here_in_front ? d_next : d_here;
      const math::Vec3d cut = a + (b - a) * (d_a / (d_a - d_b));
      front.push_back(cut);
      back.push_back(cut);
    }
  }
  return {front.view(), back.view()};
}

struct PlacedFace {
  std::uint32_t instance;
  world::FaceIndex face;
  TileGrid tiles;
  math::Vec3d normal;
  ScreenPlane depth;
};

// Pushes the polygon down the world's tree and passes each fragment in a visible, non-solid leaf to the
// emitter. Unmarked nodes have no potentially visible leaf below them, so they are skipped.
void emit_fragments(const world::Level& level, const VisibleFaces& visible, const PlacedFace& face,
                    Corners corners, base::Arena& arena, EdgeEmitter& io_emitter) {
  struct Part {
    world::Child child;
    Corners corners;
  };
  base::ArenaVector<Part> open(arena, 32);
  open.push_back({level.world().head, corners});
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    if (part.child.is_leaf()) {
      const std::size_t leaf = base::to_size(part.child.leaf());
      const SortKey key = visible.leaf_keys[leaf];
      if (key != kNotVisited && level.leaves[leaf].contents != world::Contents::kSolid)
        io_emitter.add_fragment(part.corners, face.instance, face.face, face.tiles, key, face.depth);
      continue;
    }
    if (visible.node_marked[base::to_size(part.child.node())] == 0) continue;
    const world::Node& node = level.node(part.child.node());
    const world::Plane& plane = level.planes[node.plane];
    const math::Vec3d normal(plane.normal);
    const double distance = static_cast<double>(plane.distance);
    bool any_front = false, any_back = false;
    for (const math::Vec3d& corner : part.corners) {
      const double d = glm::dot(normal, corner) - distance;
      any_front |= d > kOnPlane;
      any_back |= d < -kOnPlane;
    }
    if (any_front && any_back) {
      const Halves halves = split(part.corners, normal, distance, arena);
      open.push_back({node.children[0], halves.front});
      open.push_back({node.children[1], halves.back});
    } else {
      // A face that lies in the plane belongs to the side that it faces.
      const bool to_front = any_front || (!any_back && glm::dot(normal, face.normal) >= 0);
      open.push_back({node.children[to_front ? 0 : 1], part.corners});
    }
  }
}

}  // namespace

void add_brush_face(const world::Level& level, const ViewFrame& view, const VisibleFaces& visible,
                    const FaceOutlines& outlines, const BrushFace& face, base::Arena& io_scratch,
                    EdgeEmitter& io_emitter) {
  const FacePlane plane = place_plane(level, level.face(face.number), face.model_view);
  if (facing(view, plane.normal, plane.distance) < kEdgeOn) return;
  const FaceOutline& outline = outlines.faces[base::to_size(face.number)];
  io_scratch.reset();
  std::span<math::Vec3d> corners = io_scratch.allocate<math::Vec3d>(outline.corner_count);
  for (std::uint32_t i = 0; i < outline.corner_count; ++i)
    corners[i] = face.model_view.to_world(math::Vec3d(outlines.corners[outline.first_corner + i].position));
  emit_fragments(level, visible,
                 {face.instance, face.number, outline.tiles, plane.normal,
                  depth_plane(view, plane.normal, plane.distance)},
                 corners, io_scratch, io_emitter);
}

}  // namespace temblor::render
