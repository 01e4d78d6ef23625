// What lights and sky give a face straight away.
#pragma once

#include <span>
#include <vector>

#include "compiler/light/face_light.h"
#include "compiler/light/known_light.h"
#include "compiler/light/leaf_sight.h"
#include "compiler/light/light_source.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/phong.h"
#include "compiler/light/ray_scene.h"
#include "compiler/light/settings.h"
#include "compiler/light/shadow_filter.h"
#include "compiler/light/sky_lights.h"

namespace temblor::compiler {

struct DirectLightInput {
  const LitLevel& lit;
  const RayScene& scene;
  const PhongNormals& phong;
  const LeafSight& sight;  // of `lights`
  const LightSettings& settings;
  std::span<const LightSource> lights;
  std::span<const SkyBeam> beams;
  ShadowSampling sampling;
  const KnownLight* known;  // null: every ray is asked
};

// On a light map (LitLevel::maps) of a face that gets light. Safe to call for several maps at once.
// `out_learned`: what a cache is to keep of the face; null: nothing.
FaceLight direct_light_of(const DirectLightInput& input, std::size_t map, LightCache::Map* out_learned);

}  // namespace temblor::compiler
