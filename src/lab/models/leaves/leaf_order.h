// The places of a level's leaves in the order in which they are painted, from back to front.
#pragma once

#include <limits>

#include "base/arena.h"
#include "render/view/visible_faces.h"

namespace temblor::lab {

struct LeafPlace {
  std::uint32_t order;     // smaller is farther
  render::SortKey behind;  // the leaf comes after faces and brush models with this key or a larger one
};

class LeafOrder {
 public:
  // Lives in `arena`. Walks the whole tree of the world, also those leaves that are not visible.
  LeafOrder(const world::Level& level, const math::Vec3d& eye_world, const render::VisibleFaces& visible,
            base::Arena& arena);

  // The solid leaf is in many places, so a leaf is named by the node above it and its side: 0 front, 1 back.
  const LeafPlace& find(world::NodeIndex node, std::size_t side) const {
    return places_[2 * base::to_size(node) + side];
  }

 private:
  std::span<LeafPlace> places_;
};

// A world that is a single leaf has the first key. Models that no leaf can hide have the place.
constexpr render::SortKey kBehindAll = std::numeric_limits<render::SortKey>::max();
constexpr LeafPlace kBeforeAll{0xffffffffu, 0};

}  // namespace temblor::lab
