// Hits on walls by material: metal sprays sparks, wood splinters, stone and all else turns to dust. The
// texture's name tells the material, since levels contain nothing else that does.
#pragma once

#include <string_view>

#include "client/debris/puffs.h"
#include "client/effects/particle_bursts.h"

namespace temblor::client {

enum class Material { kStone, kMetal, kWood };

// The material that a texture's name describes, by parts of stock names and plain English ("metal5_2",
// "+0slip", "crate1"); stone if it describes none.
Material find_material(std::string_view texture_name);

// A shot that hits a wall. `normal` points away from the wall.
struct Impact {
  math::Vec3 origin_world{0.0f}, normal{0.0f};
  Material material{};
};
void spawn_impact(const BurstContext& context, const Impact& impact, Puffs& io_puffs);

}  // namespace temblor::client
