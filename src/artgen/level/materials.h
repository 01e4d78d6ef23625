// What the faces of the level made in code are covered with, and the textures for it.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/small_level.h"
#include "formats/levels/bsp.h"

namespace temblor::artgen {

// In the order of the level's textures; the frames that only an animation shows follow behind.
enum class Material : std::uint8_t {
  kBrick,
  kSlabs,
  kConcrete,
  kTrim,
  kStone,
  kEarth,
  kPanel,
  kDoor,
  kWater,
  kSky
};

constexpr bool is_lit(Material material) {
  return material != Material::kWater && material != Material::kSky;
}

std::vector<formats::BspMiptex> make_materials(const SmallLevelOptions& options);

}  // namespace temblor::artgen
