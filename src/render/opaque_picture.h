// Stages 6 to 8: everything that is opaque, and its fog. A band of rows goes through all of them before the
// next one begins, while its pixels and depth are in a core's own cache: each of them by itself would wait
// for memory, for twelve bytes a pixel where it computes little.
#pragma once

#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/models/draw_alias_models.h"
#include "render/models/draw_particles.h"
#include "render/models/draw_sprites.h"
#include "render/translucent/late_faces.h"

namespace temblor::render {

struct OpaquePicture {
  LateTarget world;
  std::span<const LateFace> late_faces;  // the opaque ones
  std::span<const PreparedAlias> alias_models;
  std::span<const SpriteQuad> sprites;
  ParticleBands particles;  // in the world's bands
};

// `io_band_arenas` grows as needed. `out_times` are sums over all bands, whoever drew them.
void draw_opaque_picture(const OpaquePicture& picture, const Settings& settings, base::Jobs& jobs,
                         base::Arena& arena, std::vector<base::Arena>& io_band_arenas, FrameBuffer& io_frame,
                         StageTimes& out_times);

}  // namespace temblor::render
