// Stage 3. VisibleFaces and brush models -> EdgeTable: the outlines of all visible faces on the screen, as
// edges sorted by their first row. An edge between two neighboring faces is stored once and bounds both.
//
//        \                       On a row, from left to right, the edge ends
//     A   \    B                 surface A (its trailing surface) and begins
//          \                     surface B (its leading surface).
//
// Method: Michael Abrash, "Sorted Spans in Action" (Graphics Programming Black Book, chapter 67). Stock Quake
// steps x in fixed point from row to row; here x is computed from the row, see Edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/edges/face_outlines.h"
#include "render/view/frame_context.h"
#include "render/view/model_view.h"
#include "render/view/visible_faces.h"

namespace temblor::render {

// Numbers surfaces in the order of the visible faces, brush fragments after the world. 0 is the background,
// which lies behind everything, so every pixel has a front surface.
enum class SurfaceIndex : std::uint32_t {};
constexpr SurfaceIndex kBackground{0};

// Row y, from first_row to last_row, is crossed at x = x_first + step * (y - first_row). x is computed and
// never accumulated, so scanning may start at any row. Pixels whose centers are at or right of x lie right of
// the edge. From left to right, surface `trailing` ends here and `leading` begins (kBackground: none).
struct Edge {
  double x_first, step;
  std::int32_t first_row, last_row;
  SurfaceIndex leading, trailing;
};

// One face on the screen, or one fragment of a brush model's face.
struct ScreenSurface {
  SortKey key;             // the background has the largest
  std::uint32_t instance;  // 0: the world; i + 1: Scene::brush_models[i]
  world::FaceIndex face;
  // Tile i of the surface is drawn by SurfaceDraw number first_draw + i.
  std::uint32_t first_draw;
  TileGrid tiles;
  // Index into EdgeTable::fragments. Meaningless for faces of the world.
  std::uint32_t fragment;
  // The smallest distance of its corners along the view, if all corners are on the screen; else 0. It spares
  // the mip choice the clipping of most faces.
  float nearest_z;
};

// The plane of 1/z on the screen, which orders brush models in one leaf: they have equal sort keys.
struct BrushFragment {
  ScreenPlane depth;
};

struct EdgeTable {
  std::span<const Edge> edges;
  // Edge numbers sorted by first row: those of row y are order[row_begin[y]] to order[row_begin[y + 1] - 1].
  std::span<const std::uint32_t> order, row_begin;
  std::span<const ScreenSurface> surfaces;  // by SurfaceIndex; 0 is the background
  std::span<const BrushFragment> fragments;
  std::span<const ModelView> model_views;  // by ScreenSurface::instance; 0 is the world's
  std::uint32_t draw_count = 0;            // draw 0 is the background
  // The last surfaces belong to deferred faces. Their edges are not in `edges`; those of deferred surface i
  // are deferred_edges[deferred_edge_begin[i]] to deferred_edges[deferred_edge_begin[i + 1] - 1].
  std::span<const Edge> deferred_edges{};
  std::span<const std::uint32_t> deferred_edge_begin{};  // one more than there are deferred surfaces, or none

  std::size_t deferred_count() const {
    return deferred_edge_begin.empty() ? 0 : deferred_edge_begin.size() - 1;
  }
  std::size_t first_deferred() const { return surfaces.size() - deferred_count(); }
  // Draws of deferred surfaces come after all others.
  std::uint32_t first_deferred_draw() const {
    return deferred_count() == 0 ? draw_count : surfaces[first_deferred()].first_draw;
  }
};

// A job with fewer faces would be done before another thread wakes up.
constexpr std::size_t kFacesPerEdgeJob = 128;

// `outlines` must be those of the scene's level; models of brush instances must exist (CHECKed). The table is
// the same for any number of threads and of faces per job. One thread runs one job, plus one for deferred
// faces. Results live in the frame's arena.
EdgeTable emit_edges(const FrameContext& context, const ViewFrame& view, const VisibleFaces& visible,
                     const FaceOutlines& outlines, std::size_t faces_per_job = kFacesPerEdgeJob);

}  // namespace temblor::render
