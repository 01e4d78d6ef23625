// Stage 3. VisibleFaces and brush models -> EdgeTable: every drawn face's outline on the screen, an edge
// between two neighbors stored once (Abrash, "Sorted Spans in Action").
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/edges/face_outlines.h"
#include "render/scene.h"
#include "render/view/model_view.h"
#include "render/view/visible_faces.h"

namespace temblor::render {

enum class SurfaceIndex : std::uint32_t {};
constexpr SurfaceIndex kBackground{0};

// Row y, from first_row to last_row, is crossed at x = x_first + step * (y - first_row): computed, never
// accumulated, so that a band of rows may start anywhere. Pixels with centers at or right of x lie right of
// the edge. Going right, `trailing` ends here and `leading` begins (kBackground: none).
struct Edge {
  double x_first, step;
  std::int32_t first_row, last_row;
  SurfaceIndex leading, trailing;
};

// One face on the screen, or one piece of a brush model's face.
struct ScreenSurface {
  SortKey key;             // the background has the largest
  std::uint32_t instance;  // 0: the world; i + 1: Scene::brush_models[i]
  world::FaceIndex face;
  std::uint32_t first_item;  // what a span of it is drawn from: first_item + tile number
  TileGrid tiles;
  std::uint32_t piece;  // into EdgeTable::pieces, for brush models
  // Smallest distance along the view of its corners, when all of them are on the screen; else 0.
  float nearest_z;
};

// What decides between brush models in one leaf.
struct Piece {
  ScreenPlane depth;
};

struct EdgeTable {
  std::span<const Edge> edges;
  // Edge numbers by first row: those of row y are order[row_begin[y]] .. order[row_begin[y + 1] - 1].
  std::span<const std::uint32_t> order, row_begin;
  std::span<const ScreenSurface> surfaces;  // by SurfaceIndex; 0 is the background
  std::span<const Piece> pieces;
  std::span<const ModelView> model_views;  // by ScreenSurface::instance; 0 is the world's
  std::uint32_t item_count = 0;            // item 0 is the background
  // The last surfaces are those of late faces: none of the edges above bounds them. Each has its own, those
  // of late surface i from deferred_edges[deferred_edge_begin[i]] on.
  std::span<const Edge> deferred_edges{};
  std::span<const std::uint32_t> deferred_edge_begin{};  // one more than there are late surfaces, or none

  std::size_t deferred_count() const {
    return deferred_edge_begin.empty() ? 0 : deferred_edge_begin.size() - 1;
  }
  std::size_t first_late() const { return surfaces.size() - deferred_count(); }
  // Items of late surfaces come after those of all others.
  std::uint32_t first_deferred_item() const {
    return deferred_count() == 0 ? item_count : surfaces[first_late()].first_item;
  }
};

// Scratch of one job: of all its faces, and of the one that is being cut.
struct EdgeJobArenas {
  base::Arena faces, pieces;
};

// A job of fewer faces is over before another thread has woken up.
constexpr std::size_t kFacesAnEdgeJob = 128;

// `outlines` are those of the scene's level. The same table comes out for any number of threads and of faces
// a job; one thread has one job (and one more for late faces).
EdgeTable emit_edges(const Scene& scene, const ViewFrame& view, const VisibleFaces& visible,
                     const FaceOutlines& outlines, base::Jobs& jobs, base::Arena& arena,
                     std::vector<EdgeJobArenas>& io_job_arenas, std::size_t faces_a_job = kFacesAnEdgeJob);

}  // namespace temblor::render
