// The materials of the small level and the textures for them, painted by code.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/small_level.h"
#include "formats/levels/bsp.h"

namespace temblor::artgen {

// The values are texture indices of the level. Textures that only appear in animations follow after these.
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

// Liquids and sky have no light maps.
constexpr bool is_lit(Material material) {
  return material != Material::kWater && material != Material::kSky;
}

// All textures in the order of Material, then the other animation frames, each with four mip levels. `tiny`
// makes them a quarter as wide and high; `missing_texture` leaves the brick texture without texels.
std::vector<formats::BspMiptex> make_materials(const SmallLevelOptions& options);

}  // namespace temblor::artgen
