// Alias models made in code, for tests and benchmarks without game data.
#pragma once

#include <cstdint>
#include <memory>

#include "formats/models/mdl.h"
#include "render/alias_model.h"

namespace temblor::test {

// The number of the one of formats::mdl_normals() that points most nearly that way.
std::uint8_t nearest_normal(const math::Vec3d& direction);

// A cube of 255 units around its origin: 8 vertices, 12 triangles, a skin of 64 x 32 in which no two
// neighboring texels are alike.
formats::Mdl box_mdl();

// A sphere of 255 units, its skin 128 x 64: the front on the left, the back on the right, joined at a seam.
// 2 * segments * (rings - 1) triangles, outward; segments even, at least 4; rings at least 2.
formats::Mdl sphere_mdl(std::uint32_t segments = 20, std::uint32_t rings = 11);

// The sphere in `poses` single frames and one group of as many, each swollen and bent in its own way.
formats::Mdl many_pose_mdl(std::uint32_t poses = 8);

// What make_alias_model makes of it, with this many units from end to end.
std::shared_ptr<const render::AliasModel> small_model(formats::Mdl mdl, float size = 64);

}  // namespace temblor::test
