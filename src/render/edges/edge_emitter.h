// Collects edges and surfaces: projection, near clip, the clip to the screen, sharing.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

class EdgeEmitter {
 public:
  EdgeEmitter(const world::Level& level, const ViewFrame& view, base::Arena& arena);

  // A face of the world, edges shared with the neighbours entered before and after it.
  void add_world_face(const VisibleFace& visible);
  // A piece of a brush model's face: its corners in the world, clockwise seen from its front.
  void add_piece(std::span<const math::Vec3d> corners_world, std::uint32_t instance, world::FaceIndex face,
                 SortKey key, const ScreenPlane& depth);

  // Edges bucketed by first row; the emitter is spent.
  EdgeTable finish(std::span<const ModelView> model_views);

 private:
  // Where a vertex is, and which sides of the screen it lies beyond (bits as ClipFlags).
  struct ScreenVertex {
    math::Vec3d view;
    math::Vec2d screen;  // unless beyond the near plane
    int beyond;
  };
  // The screen ends of a line that was clipped to the near plane; `beyond` as above for the original ends.
  struct ClippedLine {
    math::Vec2d start, end;
    bool visible;
  };

  ScreenVertex project(const math::Vec3d& world) const;
  const ScreenVertex& vertex(std::uint32_t index);
  ClippedLine clip_near(const ScreenVertex& start, const ScreenVertex& end) const;
  void add_shared_edge(std::uint32_t edge, bool reversed, SurfaceIndex surface);
  void add_own_edge(const math::Vec2d& start, const math::Vec2d& end, SurfaceIndex surface);
  // The edge's number + 1, or kOffScreen when it crosses no row left of the screen's right side.
  std::uint32_t make_edge(const math::Vec2d& start, const math::Vec2d& end);
  SurfaceIndex add_surface(SortKey key, std::uint32_t instance, world::FaceIndex face, std::uint32_t piece,
                           float nearest_z);

  static constexpr std::uint32_t kNotMade = 0, kOffScreen = 0xffffffff;
  const world::Level& level_;
  const ViewFrame& view_;
  base::Arena& arena_;
  std::span<ScreenVertex> vertices_;      // by vertex of the level
  std::span<std::uint8_t> vertex_ready_;  // by vertex of the level
  std::span<std::uint32_t> edge_of_bsp_;  // by edge of the level: number + 1, kNotMade or kOffScreen
  base::ArenaVector<Edge> edges_;
  base::ArenaVector<ScreenSurface> surfaces_;
  base::ArenaVector<Piece> pieces_;
  std::uint32_t item_count_ = 1;
};

}  // namespace temblor::render
