// Films of Gouraud's variances: the light of a technique beside the engine's, while the camera turns (faces
// are seen from other angles, and clipped elsewhere) and rolls. Textures are gray, so that only light shows.
#pragma once

#include "app/commands/options.h"
#include "base/result.h"
#include "lab/technique.h"
#include "render/scene.h"
#include "render/settings.h"

namespace temblor::app {

// An animated PNG, 2.4 s long. `size`: of each of the two pictures in a frame.
base::Result<base::ByteVector> make_light_film(const lab::Choice& choice, const render::Scene& scene,
                                               const render::Settings& settings, FrameSize size);

}  // namespace temblor::app
