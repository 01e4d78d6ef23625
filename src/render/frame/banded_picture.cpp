#include "render/frame/banded_picture.h"

#include "render/frame/stage_clock.h"
#include "render/screen/fog_band.h"
#include "render/translucent/banded_layers.h"

namespace temblor::render {

namespace {

// The order matters. Deferred faces with holes write depth, so models behind a fence's wire stay hidden. Fog
// covers everything opaque; translucent layers are fogged one by one before they are blended.
StageTimes draw_band(const FrameContext& context, const BandedPicture& picture, std::size_t number,
                     base::Arena& scratch, FrameBuffer& io_frame) {
  const WorldPicture& world = picture.world;
  const Band& band = world.spans.bands[number];
  const RowRange rows{band.first_row, band.first_row + band.row_count};
  const bool simd = context.settings.simd_kernels;
  StageTimes times;
  StageClock clock(times);
  picture.stages.draw_band_spans(context, world.view, band, world.sources, io_frame);
  clock.end(Stage::kSpans);
  if (world.sources.fill_depth) {  // all of these are tested against depth
    draw_deferred_faces(picture.order.faces.opaque, world, band, scratch, io_frame);
    clock.end(Stage::kTranslucent);
    picture.stages.draw_alias_models(picture.alias_models, simd, rows, io_frame);
    clock.end(Stage::kModels);
    draw_sprites(picture.sprites, world.colors, simd, rows, io_frame);
    clock.end(Stage::kSprites);
    draw_particles(picture.particles, number, simd, io_frame);
    clock.end(Stage::kParticles);
  }
  fog_band(world.fog, band, world.sources.draws, scratch, io_frame);
  clock.end(Stage::kScreen);
  draw_banded_layers(picture.order.layers.first(picture.order.banded), picture.order, world, band, scratch,
                     io_frame);
  clock.end(Stage::kTranslucent);
  if (picture.tints_bands && picture.tint.changes_pixels()) picture.tint.apply_to_rows(rows, io_frame);
  clock.end(Stage::kScreen);
  return times;
}

}  // namespace

BandedPicture make_banded_picture(const FrameContext& context, const FrameStages& stages,
                                  const WorldPicture& world, const TranslucentOrder& order) {
  const Scene& scene = context.scene;
  return {.stages = stages,
          .world = world,
          .order = order,
          .tint = PictureTint(scene.tint, context.format, context.settings.simd_kernels),
          .tints_bands = order.banded == order.layers.size() && !scene.underwater};
}

StageTimes draw_banded_picture(const FrameContext& context, const BandedPicture& picture,
                               FrameBuffer& io_frame) {
  const std::size_t bands = picture.world.spans.bands.size();
  std::vector<base::Arena>& scratch = context.arenas.scratch;
  FrameArenas::grow(scratch, bands);
  const std::span<StageTimes> times = context.arena().allocate<StageTimes>(bands);
  context.jobs.parallel_for(bands, [&](std::size_t number) {
    scratch[number].reset();
    times[number] = draw_band(context, picture, number, scratch[number], io_frame);
  });
  // One StageTimes per band, so that threads do not share a counter.
  StageTimes sum;
  for (const StageTimes& band : times) sum += band;
  return sum;
}

void finish_picture(const FrameContext& context, const BandedPicture& picture, Warp& io_warp,
                    FrameBuffer& io_frame) {
  if (context.scene.underwater)
    io_warp.apply(context.scene.time_s, picture.tint, context.jobs, io_frame);
  else if (!picture.tints_bands)
    tint_picture(picture.tint, context.jobs, io_frame);
}

}  // namespace temblor::render
