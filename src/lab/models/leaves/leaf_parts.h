// The front triangles of a model, cut at the planes of the BSP tree, so that each part lies in one leaf.
#pragma once

#include "lab/models/leaves/leaf_order.h"
#include "render/alias/prepare_alias.h"

namespace temblor::lab {

// A triangle to paint.
struct LeafPart {
  LeafPlace place;
  std::uint32_t model, triangle;
  float depth;                  // the mean of its corners
  std::int32_t first_row, end;  // rows
};

struct LeafParts {
  render::TriangleJob job;  // with the parts as triangles
  std::span<const LeafPart> parts;
  std::uint64_t splits = 0;
};

struct CutRules {
  const world::Level& level;
  const LeafOrder& order;
  const render::ViewFrame& view;
  bool cuts;  // false: all triangles are in the leaf of the model's middle
};

// `placement` is that of `alias`, whose number is `model`. The result lives in `arena`.
LeafParts cut_into_leaves(const CutRules& rules, const render::AliasPlacement& placement,
                          const render::PreparedAlias& alias, std::uint32_t model, base::Arena& arena);

}  // namespace temblor::lab
