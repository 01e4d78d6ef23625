// Bounced light: the light that lit faces send back to others (radiosity, Goral et al., "Modeling the
// interaction of light between diffuse surfaces", 1984). bounce.cpp describes the method.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "base/parallel_for.h"
#include "compiler/light/faces/face_light.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/rays/ray_scene.h"
#include "compiler/light/sources/settings.h"
#include "formats/images/palette.h"

namespace temblor::compiler {

// The targets of bounced light: the node that each of many rays ends at. Depends only on the level's shape,
// so the light cache keeps it.
struct BounceRays {
  std::vector<std::uint32_t> seen;         // by ray, face after face: a node, or none, or hidden
  std::vector<std::size_t> begin_of_face;  // by face, plus one: where its rays begin in `seen`
  std::vector<std::uint8_t> is_traced;     // by face, 0 or 1
};
// Returns rays of which none is traced.
BounceRays begin_bounces(const LitLevel& lit);

// Traces the rays of those `faces` that are not traced yet. Calls `step` once for each face, from any thread.
// Returns false if it ever returned false; then some faces may be missing.
bool trace_bounces(const LitLevel& lit, const RayScene& scene, std::span<const std::uint32_t> faces,
                   base::Jobs& io_jobs, base::FunctionRef<bool()> step, BounceRays& io_rays);

// Whether `seen` has the right size and node numbers for this level.
bool are_bounces_for(const LitLevel& lit, std::span<const std::uint32_t> seen);

// Adds to style 0 of every face the light that it gets from others after settings.bounce.count bounces, and
// with settings.bounce.styled, to every style. Negative lights do not bounce. Without a palette, faces are
// gray. `seen`: BounceRays::seen of all faces. `io_light`: by light map.
void add_bounced_light(const LitLevel& lit, std::span<const std::uint32_t> seen,
                       const LightSettings& settings, const std::optional<formats::Palette>& palette,
                       base::Jobs& io_jobs, std::vector<FaceLight>& io_light);

// The share of a face's own light that arrives, after its first bounce, at a point that sees nothing else.
// By face; black for faces that do not take part, and for all if settings.count is 0.
std::vector<math::Vec3> compute_first_bounces(const LitLevel& lit, const BounceSettings& settings,
                                              const std::optional<formats::Palette>& palette);

}  // namespace temblor::compiler
