// One job's share of the edge table. Work is divided by faces, in two passes with a barrier between them:
//
//   add_world_face, add_fragment   project, reject, clip to the near plane -> outlines, surfaces
//   (all jobs done)                surfaces get their final numbers (emit_edges.cpp)
//   make_edges                     outlines -> edges; of two neighbors, the one with the smaller number makes
//                                  the shared edge
//
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

// Emitters are stored side by side and used by different threads, so each gets its own cache lines.
class alignas(64) EdgeEmitter {
 public:
  EdgeEmitter(const ViewFrame& view, base::Arena& arena);

  // Nothing is added if all corners are beyond one side of the screen.
  void add_world_face(const VisibleFace& visible, const FaceOutlines& outlines);
  // A fragment of a brush model's face; its corners in world space, clockwise seen from the front.
  void add_fragment(std::span<const math::Vec3d> corners_world, std::uint32_t instance, world::FaceIndex face,
                    TileGrid tiles, SortKey key, const ScreenPlane& depth);

  // Surfaces on the screen, in the order of the add calls; first_draw and fragment count from 0 within this
  // job.
  std::span<const ScreenSurface> surfaces() const { return surfaces_.view(); }
  std::span<const BrushFragment> fragments() const { return fragments_.view(); }
  std::uint32_t draw_count() const { return draw_count_; }

  // This job's surfaces are numbered from `first` on. `surface_of_face` holds the surface number of each face
  // of the world, or kBackground. A surface that is not its face's entry there shares no edges.
  void make_edges(SurfaceIndex first, std::span<const SurfaceIndex> surface_of_face);
  std::span<const Edge> edges() const { return edges_.view(); }
  // By row: the number of edges that begin there. The caller turns the counts into positions, in place.
  std::span<std::uint32_t> edges_by_row() { return edges_by_row_; }

 private:
  // A projected corner, and the sides of the screen that it lies beyond (ClipFlags).
  struct Corner {
    math::Vec3d view;
    // Undefined if the corner is beyond the near plane.
    math::Vec2d screen;
    int beyond;
    world::FaceIndex neighbor;
  };
  // A corner in front of the near plane, and the face across the side from it to the next corner.
  struct ScreenCorner {
    math::Vec2d at;
    world::FaceIndex neighbor;
  };
  // Accumulates the flags of an outline: `all` not 0 rejects it, `any` without kClipNear needs no near clip.
  struct Beyond {
    int all = kClipAll, any = 0;
    void add(int beyond) {
      all &= beyond;
      any |= beyond;
    }
  };

  Corner project(const math::Vec3d& world, world::FaceIndex neighbor) const;
  // Appends the outline in corners_, clipped to the near plane.
  void add_outline(Beyond beyond);
  math::Vec2d cross_near(const Corner& a, const Corner& b) const;
  void add_surface(SortKey key, std::uint32_t instance, world::FaceIndex face, TileGrid tiles,
                   std::uint32_t fragment, float nearest_z);
  // Makes the edge of the side from `start` to `end`, which has surface `inside` on its right and `across` on
  // its left. Makes nothing if the side crosses no row of the screen.
  void make_edge(const math::Vec2d& start, const math::Vec2d& end, SurfaceIndex inside, SurfaceIndex across);

  const ViewFrame& view_;
  base::Arena& arena_;
  base::ArenaVector<Corner> corners_;  // of the face that is being added
  base::ArenaVector<ScreenCorner> screen_corners_;
  base::ArenaVector<std::uint32_t> corner_end_;  // by surface, into screen_corners_
  base::ArenaVector<ScreenSurface> surfaces_;
  base::ArenaVector<BrushFragment> fragments_;
  base::ArenaVector<Edge> edges_;
  std::span<std::uint32_t> edges_by_row_;
  std::uint32_t draw_count_ = 0;
};

}  // namespace temblor::render
