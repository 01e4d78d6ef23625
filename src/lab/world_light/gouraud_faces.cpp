#include "lab/world_light/gouraud_faces.h"

#include <algorithm>

#include "render/edges/face_outlines.h"

namespace temblor::lab {

namespace {

// Makes the polygons of one draw.
class PolygonMaker {
 public:
  PolygonMaker(const render::FrameContext& context, const render::ViewFrame& view, const GouraudCut& cut,
               const LitFace& face, base::Arena& arena)
      : view_(view),
        cut_(cut),
        request_(face.request),
        face_(context.level().face(face.request.face)),
        placed_(render::place_face(context.level(), face_, face.model_view)),
        lighter_(context, face.request, placed_, arena),
        arena_(arena),
        polygons_(arena, 8) {
    const std::span<math::Vec3d> corners = arena.allocate<math::Vec3d>(face_.surfedge_count);
    for (std::uint32_t i = 0; i < face_.surfedge_count; ++i)
      corners[i] = face.model_view.to_world(
          math::Vec3d(context.level().vertices[context.level().surfedge_start(face_.first_surfedge + i)]));
    corners_world_ = corners;
  }

  GouraudPolygons make() {
    const std::optional<render::TexelSteps> steps = render::find_texel_steps(placed_);
    if (cut_.cell_texels > 0 && steps)
      add_cells(*steps);
    else
      add_face(steps);
    if (polygons_.empty()) add_point();
    return {polygons_.view(), lighter_.channels()};
  }

 private:
  FacePoint find_point(const math::Vec3d& at_world) const {
    return {glm::dot(placed_.s_axis, at_world) + placed_.s_offset,
            glm::dot(placed_.t_axis, at_world) + placed_.t_offset};
  }
  math::Vec3d find_place(const FacePoint& point, const render::TexelSteps& steps) const {
    const FacePoint first = find_point(corners_world_[0]);
    return corners_world_[0] + steps.s * (point.s - first.s) + steps.t * (point.t - first.t);
  }

  void add(std::span<const WorldCorner> corners) {
    const LitPolygon polygon = place_polygon(view_, corners, cut_.perspective && view_.perspective, arena_);
    if (!polygon.corners.empty()) polygons_.push_back(polygon);
  }
  void add_quad(const std::array<WorldCorner, 4>& quad) {
    if (!cut_.triangles) return add(quad);
    add(std::array{quad[0], quad[1], quad[2]});
    add(std::array{quad[0], quad[2], quad[3]});
  }

  void add_face(const std::optional<render::TexelSteps>& steps) {
    const std::span<WorldCorner> corners = arena_.allocate<WorldCorner>(corners_world_.size());
    const std::span<FacePoint> points = arena_.allocate<FacePoint>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      points[i] = find_point(corners_world_[i]);
      corners[i] = {corners_world_[i], lighter_.find_light(points[i])};
    }
    if (cut_.spot && steps) {
      const std::optional<FacePoint> spot = lighter_.find_brightest(points);
      if (spot) return add_fan({find_place(*spot, *steps), lighter_.find_light(*spot)}, corners, true);
    }
    if (cut_.triangles) return add_fan(corners[0], corners.subspan(1), false);
    add(corners);
  }

  // By rounding, a face at the edge of the screen has pixels although nothing of it is in the frustum.
  void add_point() {
    const PointLight light = lighter_.find_light(find_point(corners_world_[0]));
    const std::span<ScreenCorner> corner = arena_.allocate_filled(1, ScreenCorner{});
    polygons_.push_back({corner, 0, 0, light, light});
  }

  // Triangles from `center` to each two corners that follow one another.
  void add_fan(const WorldCorner& center, std::span<const WorldCorner> around, bool is_closed) {
    for (std::size_t i = 0; i + 1 < around.size(); ++i) add(std::array{center, around[i], around[i + 1]});
    if (is_closed) add(std::array{center, around.back(), around.front()});
  }

  void add_cells(const render::TexelSteps& steps) {
    const auto first = [](int tile) { return tile * render::kTileTexels; };
    const auto end = [&](int tile, std::size_t axis) {
      return std::min(first(tile) + render::kTileTexels, std::max(face_.texture_extents[axis], 1));
    };
    const int end_s = end(request_.tile_s, 0), end_t = end(request_.tile_t, 1), size = cut_.cell_texels;
    const auto corner = [&](int s, int t) {
      const FacePoint point{static_cast<double>(std::min(s, end_s)), static_cast<double>(std::min(t, end_t))};
      return WorldCorner{find_place(point, steps), lighter_.find_light(point)};
    };
    for (int t = first(request_.tile_t); t < end_t; t += size)
      for (int s = first(request_.tile_s); s < end_s; s += size)
        add_quad({corner(s, t), corner(s + size, t), corner(s + size, t + size), corner(s, t + size)});
  }

  const render::ViewFrame& view_;
  const GouraudCut& cut_;
  const render::BlockRequest& request_;
  const world::Face& face_;
  const render::FacePlacement placed_;
  const VertexLighter lighter_;
  base::Arena& arena_;
  std::span<const math::Vec3d> corners_world_;
  base::ArenaVector<LitPolygon> polygons_;
};

}  // namespace

GouraudPolygons make_gouraud_polygons(const render::FrameContext& context, const render::ViewFrame& view,
                                      const GouraudCut& cut, const LitFace& face, base::Arena& arena) {
  return PolygonMaker(context, view, cut, face, arena).make();
}

}  // namespace temblor::lab
