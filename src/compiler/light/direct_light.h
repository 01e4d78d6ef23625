// What lights and sky give a face straight away.
#pragma once

#include <span>
#include <vector>

#include "compiler/light/cached_light.h"
#include "compiler/light/faces/face_light.h"
#include "compiler/light/faces/phong.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/rays/leaf_sight.h"
#include "compiler/light/rays/ray_scene.h"
#include "compiler/light/shadows/shadow_filter.h"
#include "compiler/light/sources/light_source.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"

namespace temblor::compiler {

struct DirectLightInput {
  const LitLevel& lit;
  const RayScene& scene;
  const PhongNormals& phong;
  const Leavesight& sight;  // of `lights`
  const LightSettings& settings;
  std::span<const LightSource> lights;
  std::span<const SkyBeam> beams;
  ShadowSampling sampling;
  const CachedLight* known;  // null: every ray is asked
};

// On a light map (LitLevel::maps) of a face that gets light. Safe to call for several maps at once.
// `out_learned`: what a cache is to keep of the face; null: nothing.
FaceLight direct_light_of(const DirectLightInput& input, std::size_t map, LightCache::Map* out_learned);

}  // namespace temblor::compiler
