// Stages 6 to 9, as far as they can be drawn by bands: everything that is opaque, its fog, the translucent
// faces that lie behind all other translucent things (mostly there are no others), and the tint. A band of
// rows goes through all of them before the next one begins, while its pixels and depth are in a core's own
// cache: each of them by itself would wait for memory, for twelve bytes a pixel where it computes little.
#pragma once

#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/alias/draw_alias_models.h"
#include "render/particles/draw_particles.h"
#include "render/screen/tint_picture.h"
#include "render/sprites/draw_sprites.h"
#include "render/translucent/deferred_faces.h"

namespace temblor::render {

struct BandedPicture {
  LateTarget world;
  std::span<const DeferredFace> opaque_faces{};
  std::span<const PreparedAlias> alias_models{};
  std::span<const SpriteQuad> sprites{};
  ParticleBands particles{};  // in the world's bands
  std::span<const DeferredFace> translucent_faces{};
  PictureTint tint{};  // changes nothing where something is still to come
};

// `io_band_arenas` grows as needed. `out_times` are sums over all bands, whoever drew them.
void draw_banded_picture(const BandedPicture& picture, const Settings& settings, base::Jobs& jobs,
                         base::Arena& arena, std::vector<base::Arena>& io_band_arenas, FrameBuffer& io_frame,
                         StageTimes& out_times);

}  // namespace temblor::render
