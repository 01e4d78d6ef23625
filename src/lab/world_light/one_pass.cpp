#include "lab/world_light/one_pass.h"

#include <bit>
#include <memory>

#include "lab/world_light/lit_draws.h"
#include "render/surfaces/light/block_light.h"

namespace temblor::lab {

namespace {

// The state of one frame. Its memory is kept for the next one.
struct OnePass {
  LitDraws draws;
  std::span<GridLight> lights;  // by draw number
  LitPreparation preparation;   // of `lights`
};

// Makes the cells of one channel from samples that lie `stride` apart.
const std::uint32_t* make_cells(std::span<const std::int16_t> samples, std::size_t stride,
                                const render::SampleGrid& grid, base::Arena& arena) {
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  const std::span<std::uint32_t> cells = arena.allocate<std::uint32_t>(columns * (rows + 2) + kCellPadding);
  std::size_t cell = 0;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column, ++cell) {
      const std::size_t right = column + 1 < columns ? cell + 1 : cell;
      cells[cell] = static_cast<std::uint32_t>(samples[cell * stride]) |
                    static_cast<std::uint32_t>(samples[right * stride]) << 16;
    }
  for (; cell < cells.size(); ++cell) cells[cell] = 0;
  return cells.data();
}

GridLight make_light(const render::FrameContext& context, const render::BlockRequest& request,
                     bool is_nearest, base::Arena& arena) {
  const render::BlockGrids grids = render::choose_block_grids(context.level(), request);
  const auto columns = static_cast<std::size_t>(grids.shown.columns);
  const render::LightSums sums = render::sum_block_light(context.level(), request, grids, arena);
  const auto texels = static_cast<std::uint32_t>(render::at_mip(grids.shown.texels, request.mip));
  GridLight light{.cells = {},
                  .channels = !context.is_indexed() && sums.channels == 3 ? 3 : 1,
                  .columns = grids.shown.columns,
                  .texel_shift = std::countr_zero(texels),
                  .is_nearest = is_nearest};
  const std::size_t stride = context.is_indexed() ? 1 : 4;
  const std::span<const std::int16_t> samples = context.is_indexed()
                                                    ? render::make_dark_samples(sums, columns, arena)
                                                    : render::make_rgb_samples(sums, columns, arena);
  for (std::size_t channel = 0; channel < static_cast<std::size_t>(light.channels); ++channel)
    light.cells[channel] = make_cells(samples.subspan(channel), stride, grids.shown, arena);
  return light;
}

void prepare(const render::FrameContext& context, const render::SurfaceRequests& requests, bool is_nearest,
             OnePass& io_state) {
  io_state.draws = choose_lit_draws(context, requests);
  io_state.lights = context.arena().allocate<GridLight>(requests.draws.size());
  io_state.preparation.run(context, io_state.draws.own, [&](std::uint32_t number, base::Arena& arena) {
    io_state.lights[number] = make_light(context, *io_state.draws.all[number].request, is_nearest, arena);
  });
}

constexpr LitKernels kGridKernels{draw_grid_lit_u8_simd, draw_grid_lit_u8_scalar, draw_grid_lit_u32_simd,
                                  draw_grid_lit_u32_scalar};

}  // namespace

render::FrameStages make_one_pass(std::span<const double> values, Counter* counter) {
  const bool is_nearest = values[0] == 0;
  const auto state = std::make_shared<OnePass>();
  render::FrameStages stages;
  stages.reserve_surfaces = [=](const render::FrameContext& context, const render::SurfaceRequests& requests,
                                render::SurfaceCache& io_cache) {
    const std::size_t before = context.arena().used_bytes();
    prepare(context, requests, is_nearest, *state);
    if (counter != nullptr)
      counter->add({.bytes = context.arena().used_bytes() - before + state->preparation.used_bytes()});
    return render::reserve_surfaces(context, state->draws.left, io_cache);
  };
  stages.draw_band_spans = [=](const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    draw_lit_band(
        {context, view, band, sources}, state->draws.all,
        [&](std::uint32_t number, std::span<const render::Span> drawn, const render::KernelTarget& target) {
          LitSpans spans = make_lit_spans(context, view, sources.draws.all[number], state->draws.all[number]);
          spans.spans = drawn.data();
          spans.span_count = drawn.size();
          kGridKernels.choose(sources)(spans, state->lights[number], target);
        },
        io_frame);
  };
  return stages;
}

}  // namespace temblor::lab
