// Alias models made in code, for tests and benchmarks without game data.
#pragma once

#include <cstdint>
#include <memory>

#include "formats/models/mdl.h"
#include "render/alias_model.h"

namespace temblor::test {

// Returns the index of the nearest of formats::mdl_normals().
std::uint8_t nearest_normal(const math::Vec3d& direction);

// A cube of 255 units around its origin: 8 vertices, 12 triangles, and a skin of 64 x 32 texels whose
// neighbors all differ.
formats::Mdl box_mdl();

// A sphere of 255 units with a skin of 128 x 64 texels: the front on the left, the back on the right, joined
// at a seam. It has 2 * segments * (rings - 1) triangles that face outward. `segments` must be even and at
// least 4, `rings` at least 2.
formats::Mdl sphere_mdl(std::uint32_t segments = 20, std::uint32_t rings = 11);

// The sphere in `poses` single frames and one group of as many poses, each deformed in a different way.
formats::Mdl many_pose_mdl(std::uint32_t poses = 8);

// Converts the model with make_alias_model(), scaled to this many units from end to end.
std::shared_ptr<const render::AliasModel> small_model(formats::Mdl mdl, float size = 64);

}  // namespace temblor::test
