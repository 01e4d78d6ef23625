// Direct light: what a face gets from lights and sky without any bounce.
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
#include "compiler/light/sources/projection.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"

namespace temblor::compiler {

// Everything that direct light depends on. Shared by all faces.
struct DirectLightInput {
  const LitLevel& lit;
  const RayScene& scene;
  const PhongNormals& phong;
  const LeafSight& sight;  // made for `lights`
  const LightSettings& settings;
  std::span<const LightSource> lights;
  std::span<const Projection> projections;  // by LightSource::projection
  std::span<const SkyBeam> beams;
  ShadowSampling sampling;
  bool needs_dirt;           // a light or minimum light takes dirt
  const CachedLight* known;  // null: trace every ray
};

// Lights one light map (LitLevel::maps) of a face that gets light. May run for several maps at once.
// `out_learned`: gets what a cache keeps of the map; null: nothing is kept.
FaceLight compute_direct_light(const DirectLightInput& input, std::size_t map, LightCache::Map* out_learned);

}  // namespace temblor::compiler
