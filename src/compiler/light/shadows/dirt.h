// Dirt: darkness in corners, that is, ambient occlusion measured by short rays (Zhukov, Iones and Kronin, "An
// ambient light illumination model", 1998).
#pragma once

#include <span>
#include <vector>

#include "compiler/light/rays/ray_scene.h"
#include "compiler/light/sources/settings.h"
#include "math/vec.h"

namespace temblor::compiler {

// Returns, for each place, how much is around it, 0 to 1: the mean of 1 - distance / depth over the rays.
// `normals`: one for each place.
std::vector<float> compute_dirt(const RayScene& scene, std::span<const math::Vec3> places,
                                std::span<const math::Vec3> normals, const DirtSettings& settings);

// Returns the share of light that is left where that much is around: 1 - min(1, scale * around^gain).
float find_share_after_dirt(float around, float scale, float gain);

}  // namespace temblor::compiler
