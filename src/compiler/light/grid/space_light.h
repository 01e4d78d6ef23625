// Light in open space, where no face gives it a direction: what a model at a point gets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/light/faces/face_light.h"
#include "compiler/light/faces/sample_points.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/rays/leaf_sight.h"
#include "compiler/light/rays/ray_scene.h"
#include "compiler/light/sources/light_source.h"
#include "compiler/light/sources/projection.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"

namespace temblor::compiler {

// Everything that the light of points depends on.
struct SpaceLightInput {
  const LitLevel& lit;
  const RayScene& scene;
  const LeafSight& sight;  // made for `lights`
  const LightSettings& settings;
  std::span<const LightSource> lights;
  std::span<const Projection> projections;
  std::span<const SkyBeam> beams;
  std::span<const FaceLight> face_light;      // direct light, by light map
  std::span<const math::Vec3> first_bounces;  // compute_first_bounces(), by face
};

// Finds the light at points that are close together and in open space; samples are in the order of the
// points. A light counts as on a surface that faces it, averaged over all such surfaces. The first
// bounce counts too, gathered from all directions; each further one would bring a fifth of it.
FaceLight compute_space_light(const SpaceLightInput& input, const SamplePoints& places);

}  // namespace temblor::compiler
