// Light that comes back from lit faces.
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

// What bounced light sees: a number for each of many rays, which depend on the level's shape alone.
struct BounceRays {
  std::vector<std::uint32_t> seen;         // face by face
  std::vector<std::size_t> begin_of_face;  // into `seen`; one more than there are faces
  std::vector<std::uint8_t> is_traced;     // by face, 0 or 1: what is not sees nothing yet
};
BounceRays begin_bounces(const LitLevel& lit);

// Traces those of some faces that are not traced yet. Calls `step` once for each, from any thread; false when
// it ever said so, and then some may be left.
bool trace_bounces(const LitLevel& lit, const RayScene& scene, std::span<const std::uint32_t> faces,
                   base::Jobs& io_jobs, base::FunctionRef<bool()> step, BounceRays& io_rays);

// Whether `seen` could be what bounced light sees in this level.
bool are_bounces_of(const LitLevel& lit, std::span<const std::uint32_t> seen);

// Adds to style 0 of every face what it gets from the others after settings.count bounces of style 0, and so
// for every style with settings.styled. Negative lights do not bounce. Without a palette no face has a
// color. `seen`: of all faces. `io_light`: by light map.
void add_bounced_light(const LitLevel& lit, std::span<const std::uint32_t> seen,
                       const BounceSettings& settings, const std::optional<formats::Palette>& palette,
                       base::Jobs& io_jobs, std::vector<FaceLight>& io_light);

}  // namespace temblor::compiler
