// World faces go in as they are; faces of brush models are first cut at the world's leafs, so that every
// piece takes its leaf's place in the front-to-back order (Abrash, "The Big Picture").
#include <algorithm>
#include <array>

#include "base/check.h"
#include "render/edges/edge_emitter.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

namespace {

// Corners nearer to a plane than this lie on it: no slivers.
constexpr double kOnPlane = 1.0 / 64;

using Corners = std::span<const math::Vec3d>;

struct Halves {
  Corners front, back;
};

// Cuts a polygon in two; a corner on the plane belongs to both. Points of the cut are worked out from the
// front corner to the back one, so that neighbours cut the edge that they share in the same place.
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

struct BrushFace {
  std::uint32_t instance;
  world::FaceIndex face;
  math::Vec3d normal;
  ScreenPlane depth;
};

// Hands every piece of the polygon that lies in a visited leaf to the emitter.
void emit_pieces(const world::Level& level, const VisibleFaces& visible, const BrushFace& face,
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
      if (key != kNotVisited && level.leafs[leaf].contents != world::Contents::kSolid)
        io_emitter.add_piece(part.corners, face.instance, face.face, key, face.depth);
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
      // A face that lies in the plane belongs to the side it looks to.
      const bool to_front = any_front || (!any_back && glm::dot(normal, face.normal) >= 0);
      open.push_back({node.children[to_front ? 0 : 1], part.corners});
    }
  }
}

// Whether the model may be on the screen: a sphere round it against the frustum.
bool in_frustum(const ViewFrame& view, const ModelView& model_view, const math::Bounds& bounds) {
  const math::Vec3d mins(bounds.mins), maxs(bounds.maxs);
  const math::Vec3d centre = model_view.to_world((mins + maxs) * 0.5);
  const double radius = glm::length(maxs - mins) / 2;
  return std::all_of(view.frustum.begin(), view.frustum.end(), [&](const FrustumPlane& plane) {
    return glm::dot(plane.normal, centre) + plane.offset >= -radius * glm::length(plane.normal);
  });
}

void emit_brush_model(const Scene& scene, std::uint32_t instance, const ViewFrame& view,
                      const ModelView& model_view, const VisibleFaces& visible, base::Arena& io_scratch,
                      EdgeEmitter& io_emitter) {
  const world::Level& level = *scene.level;
  const world::Model& model = level.models[base::to_size(scene.brush_models[instance - 1].model)];
  if (!in_frustum(view, model_view, model.bounds)) return;
  for (std::uint32_t i = model.first_face; i < model.first_face + model.face_count; ++i) {
    const world::Face& face = level.faces[i];
    const FacePlacement placed = place_face(level, face, model_view);
    if (facing(view, placed.normal, placed.distance) < kEdgeOn) continue;
    io_scratch.reset();
    std::span<math::Vec3d> corners = io_scratch.allocate<math::Vec3d>(face.surfedge_count);
    for (std::uint32_t corner = 0; corner < face.surfedge_count; ++corner)
      corners[corner] = model_view.to_world(
          math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + corner)]));
    emit_pieces(level, visible,
                {instance, base::to_index<world::FaceIndex>(i), placed.normal,
                 depth_plane(view, placed.normal, placed.distance)},
                corners, io_scratch, io_emitter);
  }
}

}  // namespace

EdgeTable emit_edges(const Scene& scene, const ViewFrame& view, const VisibleFaces& visible,
                     base::Arena& arena, base::Arena& io_scratch) {
  const world::Level& level = *scene.level;
  EdgeEmitter emitter(level, view, arena);
  for (const VisibleFace& face : visible.faces) emitter.add_world_face(face);

  std::span<ModelView> model_views = arena.allocate<ModelView>(scene.brush_models.size() + 1);
  model_views[0] = ModelView{};
  for (std::uint32_t instance = 1; instance < model_views.size(); ++instance) {
    CHECK(base::to_size(scene.brush_models[instance - 1].model) < level.models.size(), "instance {}",
          instance);
    model_views[instance] = make_model_view(scene.brush_models[instance - 1]);
    emit_brush_model(scene, instance, view, model_views[instance], visible, io_scratch, emitter);
  }
  return emitter.finish(model_views);
}

}  // namespace temblor::render
