#include "render/frame/banded_picture.h"

#include "render/frame/stage_clock.h"
#include "render/screen/fog_band.h"
#include "render/spans/draw_spans.h"

namespace temblor::render {

namespace {

StageTimes draw_band(const BandedPicture& picture, const Settings& settings, std::size_t number,
                     base::Arena& arena, FrameBuffer& io_frame) {
  const LateTarget& world = picture.world;
  const Band& band = world.spans.bands[number];
  const RowRange rows{band.first_row, band.first_row + band.row_count};
  const bool vectors = settings.vector_kernels;
  StageTimes times;
  StageClock clock(times);
  draw_spans(settings, world.view, band, world.sources, world.tables, io_frame);
  clock.end(Stage::kSpans);
  if (settings.fill_depth) {  // what follows is tested against it
    draw_deferred_faces(picture.opaque_faces, world, band, arena, io_frame);
    clock.end(Stage::kTranslucent);
    draw_alias_models(picture.alias_models, vectors, rows, io_frame);
    clock.end(Stage::kModels);
    draw_sprites(picture.sprites, world.tables, vectors, rows, io_frame);
    clock.end(Stage::kSprites);
    draw_particles(picture.particles, number, vectors, io_frame);
    clock.end(Stage::kParticles);
  }
  fog_band(world.fog, band, world.sources.items, arena, io_frame);
  clock.end(Stage::kScreen);
  draw_deferred_faces(picture.translucent_faces, world, band, arena, io_frame);
  clock.end(Stage::kTranslucent);
  if (picture.tint.changes_pixels()) picture.tint.apply_to_rows(rows, io_frame);
  clock.end(Stage::kScreen);
  return times;
}

}  // namespace

void draw_banded_picture(const BandedPicture& picture, const Settings& settings, base::Jobs& jobs,
                         base::Arena& arena, std::vector<base::Arena>& io_band_arenas, FrameBuffer& io_frame,
                         StageTimes& out_times) {
  const std::size_t bands = picture.world.spans.bands.size();
  if (io_band_arenas.size() < bands) io_band_arenas.resize(bands);
  const std::span<StageTimes> times = arena.allocate<StageTimes>(bands);
  jobs.parallel_for(bands, [&](std::size_t number) {
    io_band_arenas[number].reset();
    times[number] = draw_band(picture, settings, number, io_band_arenas[number], io_frame);
  });
  for (const StageTimes& band : times) out_times += band;
}

}  // namespace temblor::render
