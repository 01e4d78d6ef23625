// Darkness in corners: ambient occlusion by short rays.
#pragma once

#include <span>
#include <vector>

#include "compiler/light/rays/ray_scene.h"
#include "compiler/light/sources/settings.h"
#include "math/vec.h"

namespace temblor::compiler {

// For each place the share of light that dirt leaves: 1 - min(1, scale * o^gain), o being how much nearer
// than `depth` what lies around is on average, as a share of it. `normals`: one for each place.
std::vector<float> dirt_at(const RayScene& scene, std::span<const math::Vec3> places,
                           std::span<const math::Vec3> normals, const DirtSettings& settings);

}  // namespace temblor::compiler
