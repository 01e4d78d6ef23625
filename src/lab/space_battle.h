// The program of Michael Abrash's "Sorted Spans in Action" as a scene: a space battle, drawn with an edge
// list that is sorted by 1/z. It needs no level and no BSP tree, because the solids never touch.
//
//   formation    where each solid is at a time                                   space_battle/formation.h
//   edges        polygons -> edges and surfaces, sorted by first row             space_battle/solid_edges.h
//   scan         row by row: edges sorted by x pass a stack of surfaces sorted   hidden_surfaces/stack_scan.h
//                by 1/z, whose last is the background; the result is spans
//   fill         spans -> pixels: one color per surface, stars in the background space_battle.cpp
//
// The scan is that of the techniques `independent-edges` and `abutting-edges`, which draw levels with it.
// Every pixel is written once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/arena.h"
#include "lab/space_battle/formation.h"
#include "lab/space_battle/star_field.h"

namespace temblor::lab::space {

enum class BattleShapes { kConvex, kConcave, kBoth };

// The article's types of sorting by 1/z; see hidden_surfaces/depth_edges.h.
enum class DepthSorting { kIndependent, kAbutting, kIntersecting };

struct BattleOptions {
  std::size_t solids = 100;  // 0 to kMaxSolids
  BattleShapes shapes = BattleShapes::kConvex;
  // Between neighbors, in units of the largest solid's radius; below kSafeSpacing, solids may intersect.
  double spacing = kSafeSpacing;
  DepthSorting sorting = DepthSorting::kIndependent;
  std::uint64_t seed = 1;
};
constexpr std::size_t kMaxSolids = 10'000;

// Work in a frame.
struct BattleCounts {
  std::size_t edges = 0, surfaces = 0, spans = 0;
  std::uint64_t comparisons = 0;  // which of two surfaces is nearer
};

class Battle {
 public:
  explicit Battle(const BattleOptions& options);

  // A place that sees all of the battle or its nearest part, and directions for looking at its middle.
  math::Vec3d lookout() const { return formation_.lookout; }
  math::Basis lookout_axes() const;

  // Draws the battle at a time. `out_pixels` (0xffRRGGBB) has view.width * view.height elements (CHECKed).
  // The same arguments give the same picture. Warm frames allocate nothing from the heap.
  BattleCounts draw(const BattleView& view, double time_s, std::span<std::uint32_t> out_pixels);

  // Surfaces that cover a pixel, without the background, as a mean of all pixels: how deep the picture is.
  double measure_depth_complexity(const BattleView& view, double time_s);

  std::span<const Solid> solids() const { return solids_; }
  const Formation& formation() const { return formation_; }

 private:
  std::vector<Solid> solids_;
  Formation formation_;
  std::vector<Star> stars_;
  DepthSorting sorting_;
  base::Arena arena_;  // of a frame
};

}  // namespace temblor::lab::space
