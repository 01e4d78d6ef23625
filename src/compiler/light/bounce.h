// Light that comes back from lit faces.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/parallel_for.h"
#include "compiler/light/face_light.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/ray_scene.h"
#include "compiler/light/settings.h"
#include "formats/palette.h"

namespace temblor::compiler {

// Adds to style 0 of every face what it gets from the others after settings.count bounces of style 0. Other
// styles do not bounce, nor do negative lights. Without a palette no face has a colour. `io_light`: by face.
void add_bounced_light(const LitLevel& lit, const RayScene& scene, const BounceSettings& settings,
                       const std::optional<formats::Palette>& palette, base::Jobs& io_jobs,
                       std::vector<FaceLight>& io_light);

}  // namespace temblor::compiler
