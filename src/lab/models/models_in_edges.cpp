#include "lab/models/models_in_edges.h"

#include <algorithm>
#include <memory>
#include <mutex>

#include "lab/models/edges/scan_models.h"
#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"
#include "render/alias/alias_mesh.h"
#include "render/alias/rows/row_list.h"

namespace temblor::lab {

namespace {

// Arenas that threads borrow for a band.
class ArenaPool {
 public:
  base::Arena take() {
    const std::lock_guard lock(mutex_);
    if (arenas_.empty()) return {};
    base::Arena arena = std::move(arenas_.back());
    arenas_.pop_back();
    return arena;
  }
  void give_back(base::Arena arena) {
    arena.reset();
    const std::lock_guard lock(mutex_);
    arenas_.push_back(std::move(arena));
  }

 private:
  std::mutex mutex_;
  std::vector<base::Arena> arenas_;
};

template <typename Pixel>
void draw_span(const render::TriangleJob& job, const render::TriangleSpan& span,
               const render::TriangleTarget& target) {
  const std::size_t first = static_cast<std::size_t>(span.y) * static_cast<std::size_t>(target.width) +
                            static_cast<std::size_t>(span.x);
  Pixel* const pixels = static_cast<Pixel*>(target.pixels) + first;
  float* const nearest = target.depth + first;
  for (std::int32_t i = 0; i < span.count; ++i) {
    const float lane = static_cast<float>(i), depth = span.depth + lane * span.depth_step;
    if (!(depth >= nearest[i])) continue;
    nearest[i] = depth;
    pixels[i] = render::lit_texel(job, render::skin_texel(job, span, lane, depth), span, lane, Pixel{});
  }
}

// The list from which the engine's kernels draw rows of triangles.
void append(const render::TriangleSpan& span, std::int32_t width, render::RowList& io_rows) {
  const std::size_t i = io_rows.size++;
  io_rows.place[i] = span.y * width + span.x;
  io_rows.count[i] = span.count;
  io_rows.perspective[i] = span.perspective ? -1 : 0;
  const float values[4] = {span.depth, span.light, span.s, span.t};
  const float steps[4] = {span.depth_step, span.light_step, span.s_step, span.t_step};
  for (std::size_t value = 0; value < 4; ++value) {
    io_rows.value[value][i] = values[value];
    io_rows.step[value][i] = steps[value];
  }
  io_rows.order[io_rows.ordered++] = static_cast<std::int32_t>(i);
}

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
                bool simd_kernels, const render::TriangleTarget& target, render::PixelFormat format,
                base::Arena& arena) {
  const bool is_indexed = format == render::PixelFormat::kIndexed;
  std::span<std::uint32_t> begin;
  const std::span<const std::uint32_t> order = sort_by_model(spans, models.size(), begin, arena);
  render::RowList& rows = arena.allocate<render::RowList>(1).front();
  for (std::size_t model = 0; model < models.size(); ++model) {
    render::TriangleJob job = models[model].job;
    job.has_short_rows = false;
    rows.size = rows.ordered = rows.groups = 0;
    const auto flush = [&] {
      if (rows.size == 0) return;
      is_indexed ? render::draw_rows_u8_simd(job, rows, target)
                 : render::draw_rows_u32_simd(job, rows, target);
      rows.size = rows.ordered = 0;
    };
    for (std::size_t i = begin[model]; i < begin[model + 1]; ++i) {
      const render::TriangleSpan& span = spans[order[i]].span;
      if (!simd_kernels) {
        is_indexed ? draw_span<std::uint8_t>(job, span, target) : draw_span<std::uint32_t>(job, span, target);
        continue;
      }
      append(span, target.width, rows);
      if (rows.size == render::RowList::kCapacity) flush();
    }
    flush();
  }
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
    draw_spans(models, scan.spans, simd_kernels,
               {pixels, io_frame.depth().data(), io_frame.width(), 0, rows.first, rows.end},
               io_frame.format(), arena);
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
