// Light that comes back from lit faces.
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel_for.h"
#include "compiler/light/face_light.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/ray_scene.h"
#include "compiler/light/settings.h"

namespace temblor::compiler {

// Adds to style 0 of every face what it gets from the others after settings.count bounces of style 0. Other
// styles do not bounce, nor do negative lights. `io_light`: by face.
void add_bounced_light(const LitLevel& lit, const RayScene& scene, const BounceSettings& settings,
                       base::Jobs& io_jobs, std::vector<FaceLight>& io_light);

}  // namespace temblor::compiler
