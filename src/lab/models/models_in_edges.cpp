#include "lab/models/models_in_edges.h"

#include <algorithm>
#include <memory>

#include "lab/models/edges/arena_pool.h"
#include "lab/models/edges/row_painter.h"
#include "lab/models/edges/scan_models.h"
#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"
#include "render/alias/alias_mesh.h"

namespace temblor::lab {

namespace {

// The numbers of the spans, model by model.
std::span<const std::uint32_t> sort_by_model(std::span<const ModelSpan> spans, std::size_t models,
                                             std::span<std::uint32_t>& out_begin, base::Arena& arena) {
  out_begin = arena.allocate_filled<std::uint32_t>(models + 2, 0);
  for (const ModelSpan& span : spans) ++out_begin[span.model + 2];
  for (std::size_t i = 2; i < out_begin.size(); ++i) out_begin[i] += out_begin[i - 1];
  const std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(spans.size());
  for (std::size_t i = 0; i < spans.size(); ++i)
    order[out_begin[spans[i].model + 1]++] = static_cast<std::uint32_t>(i);
  return order;
}

void draw_spans(std::span<const render::PreparedAlias> models, std::span<const ModelSpan> spans,
                const RowKernels& kernels, const render::TriangleTarget& target, base::Arena& arena) {
  std::span<std::uint32_t> begin;
  const std::span<const std::uint32_t> order = sort_by_model(spans, models.size(), begin, arena);
  RowPainter painter(kernels, target, arena);
  for (std::size_t model = 0; model < models.size(); ++model) {
    painter.begin_model(models[model].job);
    for (std::size_t i = begin[model]; i < begin[model + 1]; ++i) painter.add(spans[order[i]].span);
  }
  painter.draw();
}

std::size_t count_triangles(const render::Scene& scene) {
  std::size_t triangles = 0;
  for (const render::AliasInstance& instance : scene.alias_models)
    if (instance.model != nullptr) triangles += instance.model->triangles.size();
  return triangles;
}

}  // namespace

render::FrameStages make_models_in_edges(std::span<const double> values, Counter* counter) {
  const bool uses_tree = values[0] != 0;
  const auto most_triangles = static_cast<std::size_t>(values[1]);
  const auto arenas = std::make_shared<ArenaPool>();
  const auto is_refused = std::make_shared<bool>(false);
  render::FrameStages stages;
  stages.prepare_alias_models = [=](const render::FrameContext& context, const render::ViewFrame& view) {
    *is_refused = count_triangles(context.scene) > most_triangles;
    if (*is_refused) return render::prepare_alias_models(context, view);
    // By subdivision, the engine does not look for front faces, which the scan does by itself.
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kSubdivision;
    return render::prepare_alias_models(with_settings(context, settings), view);
  };
  stages.draw_alias_models = [=](std::span<const render::PreparedAlias> models, bool simd_kernels,
                                 render::RowRange rows, render::FrameBuffer& io_frame) {
    if (*is_refused) return render::draw_alias_models(models, simd_kernels, rows, io_frame);
    if (models.empty()) return;
    base::Arena arena = arenas->take();
    const ModelScan scan = scan_models(models, rows, io_frame.width(), uses_tree, arena);
    if (counter != nullptr) {
      Counts counts = scan.counts;
      counts.bytes = arena.used_bytes();
      counter->add(counts);
    }
    const bool is_indexed = io_frame.format() == render::PixelFormat::kIndexed;
    void* const pixels = is_indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data();
    draw_spans(models, scan.spans, {io_frame.format(), simd_kernels},
               {pixels, io_frame.depth().data(), io_frame.width(), 0, rows.first, rows.end}, arena);
    arenas->give_back(std::move(arena));
  };
  return stages;
}

base::Status check_models_in_edges(std::span<const double> values, const render::Scene& scene) {
  const std::size_t triangles = count_triangles(scene);
  if (static_cast<double>(triangles) <= values[1]) return base::Ok{};
  return base::error(base::ErrorCode::kUsage,
                     "the models have {} triangles, more than the {} that models-in-edges draws; show fewer "
                     "models, or set models-in-edges:triangles=N",
                     triangles, values[1]);
}

}  // namespace temblor::lab
