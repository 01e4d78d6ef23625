// The results of other portals that the search through one portal may use.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/vis/bit_matrix.h"

namespace temblor::compiler::vis {

// An upper bound of the view through each portal: the finished row for portals whose rank is below
// `finished`, which earlier rounds computed, and base visibility, or for crowded portals the bound of Reach,
// for all others.
struct FlowBounds {
  const BitMatrix& base;
  const BitMatrix& seen;
  std::span<const std::uint32_t> rank_of_portal;
  std::uint32_t finished = 0;
  std::span<const std::uint8_t> crowded{};  // by portal, 0 or 1; empty: none is

  bool is_crowded(std::uint32_t portal) const { return !crowded.empty() && crowded[portal] != 0; }
  std::span<const BitMatrix::Word> row(std::uint32_t portal) const {
    return finished > 0 && rank_of_portal[portal] < finished ? seen.row(portal) : base.row(portal);
  }
};

}  // namespace temblor::compiler::vis
