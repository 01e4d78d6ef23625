// The polygons with light at their corners that a tile of a face is drawn as.
#pragma once

#include "lab/world_light/lit_polygons.h"
#include "render/view/model_view.h"

namespace temblor::lab {

// The technique's parameters.
struct GouraudCut {
  bool perspective = false;
  bool triangles = false;
  bool spot = false;
  int cell_texels = 0;  // 0: no grid
};

struct LitFace {
  const render::BlockRequest& request;
  const render::ModelView& model_view;
};

struct GouraudPolygons {
  std::span<const LitPolygon> all;  // only those in the frustum
  int channels;                     // 1 or 3
};

// Without a grid: the face's own polygon, or its triangles from one corner, or from the brightest sample.
// With a grid: the cells of the tile, which may reach beyond the face. Lives in `arena`.
GouraudPolygons make_gouraud_polygons(const render::FrameContext& context, const render::ViewFrame& view,
                                      const GouraudCut& cut, const LitFace& face, base::Arena& arena);

}  // namespace temblor::lab
