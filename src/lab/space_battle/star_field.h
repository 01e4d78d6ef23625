// Stars, infinitely far away in all directions. They are drawn only in the spans of the background, so that
// stars cost nothing behind solids and no pixel is drawn over.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "lab/space_battle/battle_view.h"

namespace temblor::lab::space {

struct Star {
  math::Vec3d direction;  // length 1
  std::uint32_t color;    // 0xffRRGGBB
  std::uint8_t size_px;   // a square of 1 or 2 pixels per side
};

// A pixel of a star: pixel number `place`, counted along the rows from the top left.
struct StarPixel {
  std::uint32_t place, color;
};

std::vector<Star> make_stars(std::size_t count, std::uint64_t seed);

// The pixels of all stars on the screen, in order of their places. They live in the arena.
std::span<const StarPixel> find_star_pixels(std::span<const Star> stars, const BattleView& view,
                                            base::Arena& arena);

}  // namespace temblor::lab::space
