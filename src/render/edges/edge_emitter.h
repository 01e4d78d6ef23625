// One job's share of the edge table: the outlines of some faces on the screen, and then their edges.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

// First outlines are added. When every job is done with that, all surfaces get their numbers, and only then
// can edges be made: which of two neighbors makes their common edge depends on both numbers.
// Emitters lie beside one another and each is used by another thread: none shares a cache line.
class alignas(64) EdgeEmitter {
 public:
  EdgeEmitter(const ViewFrame& view, base::Arena& arena);

  // A face of the world.
  void add_world_face(const VisibleFace& visible, const FaceOutlines& outlines);
  // A piece of a brush model's face: its corners in the world, clockwise seen from its front.
  void add_piece(std::span<const math::Vec3d> corners_world, std::uint32_t instance, world::FaceIndex face,
                 TileGrid tiles, SortKey key, const ScreenPlane& depth);

  // What is on the screen, in the order in which it was added; first_item and piece count from 0.
  std::span<const ScreenSurface> surfaces() const { return surfaces_.view(); }
  std::span<const Piece> pieces() const { return pieces_.view(); }
  std::uint32_t item_count() const { return item_count_; }

  // The surfaces are those from `first` on. `surface_of_face` has the number of each face of the world, or
  // kBackground. Each edge is made by the first surface at it. A surface that does not have its face's number
  // there shares none.
  void make_edges(SurfaceIndex first, std::span<const SurfaceIndex> surface_of_face);
  std::span<const Edge> edges() const { return edges_.view(); }
  // By row: how many edges begin there.
  std::span<std::uint32_t> edges_by_row() { return edges_by_row_; }

 private:
  // Where a corner is, and which sides of the screen it lies beyond (bits as ClipFlags).
  struct Corner {
    math::Vec3d view;
    math::Vec2d screen;  // unless beyond the near plane
    int beyond;
    world::FaceIndex neighbor;
  };
  // A corner of what is before the near plane, and who is across the side from there to the next one.
  struct ScreenCorner {
    math::Vec2d at;
    world::FaceIndex neighbor;
  };
  struct Beyond {
    int all = kClipAll, any = 0;
    void add(int beyond) {
      all &= beyond;
      any |= beyond;
    }
  };

  Corner project(const math::Vec3d& world, world::FaceIndex neighbor) const;
  // The corners of corners_ as an outline on the screen.
  void add_outline(Beyond beyond);
  math::Vec2d cross_near(const Corner& a, const Corner& b) const;
  void add_surface(SortKey key, std::uint32_t instance, world::FaceIndex face, TileGrid tiles,
                   std::uint32_t piece, float nearest_z);
  // Of the side from `start` to `end`, walked with `inside` on the right hand.
  void make_edge(const math::Vec2d& start, const math::Vec2d& end, SurfaceIndex inside, SurfaceIndex across);

  const ViewFrame& view_;
  base::Arena& arena_;
  base::ArenaVector<Corner> corners_;  // of the face that is being added
  base::ArenaVector<ScreenCorner> screen_corners_;
  base::ArenaVector<std::uint32_t> corner_end_;  // by surface, into screen_corners_
  base::ArenaVector<ScreenSurface> surfaces_;
  base::ArenaVector<Piece> pieces_;
  base::ArenaVector<Edge> edges_;
  std::span<std::uint32_t> edges_by_row_;
  std::uint32_t item_count_ = 0;
};

}  // namespace temblor::render
