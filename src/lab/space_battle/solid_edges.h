// Solids -> edges: the first half of the space battle's frame. Each face that shows its front becomes a
// surface, a drawing object without corners: the plane of its 1/z on the screen, and edges at which it begins
// or ends. An edge between two visible faces of a solid is stored once and bounds both.
//
//   solid --> in view space --> faces to the front --> clipped at the near plane --> edges, by first row
//
// Faces are clipped as polygons only at the near plane. Edges are cut off at the top and the bottom of the
// screen; the scan cuts them off at its sides (edge_crossing.h).
//
// Source: Michael Abrash, "Sorted Spans in Action". His program keeps the edges of each polygon apart, and
// steps x in fixed point; here, edges are shared and x is computed from the row, as in the engine.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "lab/space_battle/battle_view.h"
#include "lab/space_battle/formation.h"
#include "lab/space_battle/solid.h"
#include "render/edges/edge_table.h"

namespace temblor::lab::space {

// By surface; 0 is the background, which is farther than everything.
struct SceneEdges {
  render::EdgeTable table;
  std::span<const render::ScreenPlane> depths;
  std::span<const std::uint32_t> colors;  // 0xffRRGGBB, with light
};

// 0xffRRGGBB: the color in the light of the battle's sun, which leaves no face black.
std::uint32_t light_face(const formats::Rgb& color, const math::Vec3d& normal_world);

// A direction or a place from the solid's own axes to those that `axes` are given in.
math::Vec3d turn_solid(const math::Basis& axes, const math::Vec3d& model);

class SolidEdges {
 public:
  SolidEdges(const BattleView& view, base::Arena& arena);

  void add(const Solid& solid, const Placement& placement, const formats::Rgb& color);
  // Sorts the edges by their first row. Call last. The result lives in the arena.
  SceneEdges finish();

 private:
  using Surface = render::SurfaceIndex;
  struct Corner {
    math::Vec3d view;
    math::Vec2d screen;  // only if the corner is before the near plane
  };
  // A corner of a face on the screen. The side from here to the next corner has `across` beyond it.
  struct OutlineCorner {
    math::Vec2d screen;
    Surface across;
  };

  void place_corners(const Solid& solid, const Placement& placement, const math::Vec3d& center_view);
  void add_surfaces(const Solid& solid, const Placement& placement, const formats::Rgb& color);
  void clip_face(const Solid& solid, const SolidFace& face);
  void add_outline(Surface inside);
  void add_edge(const math::Vec2d& start, const math::Vec2d& end, Surface inside, Surface across);
  bool is_before(const Corner& corner) const { return corner.view.z >= view_.near_z; }

  const BattleView& view_;
  base::Arena& arena_;
  // By surface, of all solids.
  base::ArenaVector<render::ScreenPlane> depths_;
  base::ArenaVector<std::uint32_t> colors_;
  base::ArenaVector<render::Edge> edges_;
  std::span<std::uint32_t> edges_by_row_;  // how many begin there
  // The solid that is being added, and one of its faces.
  base::ArenaVector<Corner> corners_;
  base::ArenaVector<Surface> surfaces_;  // by face; the background if it shows its back
  base::ArenaVector<OutlineCorner> outline_;
};

}  // namespace temblor::lab::space
