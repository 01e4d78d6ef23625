// Stages 6 to 9, as far as they can be drawn band by band:
//
//   world spans -> opaque deferred faces -> alias models -> sprites -> particles -> fog
//               -> the farthest translucent faces and sprites -> tint
//
// A band of rows passes through all of these before the next band begins, while its pixels and depth are in
// the core's own cache. Separate passes over the frame would each wait for memory: up to twelve bytes per
// pixel for little computation.
//
// Translucent faces and sprites belong here only if they are behind all translucent models, which is the
// usual case. The other layers are drawn afterwards (translucent/draw_translucent.h).
#pragma once

#include <span>

#include "render/alias/draw_alias_models.h"
#include "render/frame/frame_stages.h"
#include "render/frame_stats.h"
#include "render/particles/draw_particles.h"
#include "render/screen/tint_picture.h"
#include "render/screen/warp.h"
#include "render/sprites/draw_sprites.h"
#include "render/translucent/translucent_layers.h"

namespace temblor::render {

// The input of all bands. Spans refer to the frame's arena.
struct BandedPicture {
  const FrameStages& stages;
  WorldPicture world;
  const TranslucentOrder& order;
  std::span<const PreparedAlias> alias_models{};
  std::span<const SpriteQuad> sprites{};
  // By band of `world.spans`.
  ParticleBands particles{};
  PictureTint tint{};
  // False: something is drawn after the bands (translucent layers, the warp), so the tint has to wait.
  bool tints_bands = false;
};

// Fills in everything except models, sprites, and particles.
BandedPicture make_banded_picture(const FrameContext& context, const FrameStages& stages,
                                  const WorldPicture& world, const TranslucentOrder& order);

// Draws all bands in parallel. Returns the time of each stage, summed over all bands and threads.
StageTimes draw_banded_picture(const FrameContext& context, const BandedPicture& picture,
                               FrameBuffer& io_frame);

// To be called when everything is drawn: applies the underwater warp, and the tint unless the bands applied
// it.
void finish_picture(const FrameContext& context, const BandedPicture& picture, Warp& io_warp,
                    FrameBuffer& io_frame);

}  // namespace temblor::render
