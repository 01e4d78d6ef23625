#include "lab/models/leaves/models_in_leaves.h"

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>

#include "lab/hidden_surfaces/painter.h"
#include "lab/models/leaves/leaf_parts.h"
#include "lab/models/model_jobs.h"
#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"
#include "render/alias/affine_triangle.h"
#include "render/alias/draw_alias_models.h"

namespace temblor::lab {

namespace {

// Hot loop. Paints a triangle without comparing depths. Scalar: rows of most triangles have a few pixels.
template <typename Pixel>
void paint_triangle(const render::TriangleJob& job, std::uint32_t number,
                    const render::TriangleTarget& target) {
  render::draw_affine_triangle(job, number, target, [&](const render::TriangleSpan& span) {
    const std::size_t first =
        static_cast<std::size_t>(span.y - target.first_row) * static_cast<std::size_t>(target.width) +
        static_cast<std::size_t>(span.x);
    for (std::int32_t pixel = 0; pixel < span.count; ++pixel) {
      const float lane = static_cast<float>(pixel), depth = span.depth + lane * span.depth_step;
      const std::size_t at = first + static_cast<std::size_t>(pixel);
      target.depth[at] = depth;
      static_cast<Pixel*>(target.pixels)[at] =
          render::lit_texel(job, render::skin_texel(job, span, lane, depth), span, lane, Pixel{});
    }
  });
}

class ModelsInLeaves {
 public:
  explicit ModelsInLeaves(bool cuts) : cuts_(cuts) {}

  void begin_frame(const render::VisibleFaces& visible) {
    visible_ = visible;
    parts_ = {};
  }

  void set_draws(const render::FrameContext& context, const render::EdgeTable& table) {
    draw_keys_ = context.arena().allocate_filled<render::SortKey>(table.draw_count, kBehindAll);
    for (const render::ScreenSurface& surface : table.surfaces)
      for (std::uint32_t tile = 0; tile < std::uint32_t{surface.tiles.s} * surface.tiles.t; ++tile)
        draw_keys_[surface.first_draw + tile] = surface.key;
  }

  // Returns no models, since they are drawn with the world.
  Counts prepare(const render::FrameContext& context, const render::ViewFrame& view) {
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kSubdivision;  // without a search for front faces
    base::Arena& arena = context.arena();
    const auto placements = render::place_alias_models(context.scene, view, arena);
    prepared_ = render::prepare_placed_models(with_settings(context, settings), view, placements);
    const LeafOrder order(context.level(), view.eye_world, visible_, arena);
    const CutRules rules{context.level(), order, view, cuts_};
    models_ = arena.allocate<LeafParts>(prepared_.size());
    cut_models(context, rules, placements);
    Counts counts;
    std::size_t count = 0;
    for (const LeafParts& model : models_) {
      count += model.parts.size();
      counts.splits += model.splits;
    }
    const std::span<LeafPart> parts = arena.allocate<LeafPart>(count);
    auto out = parts.begin();
    for (const LeafParts& model : models_) out = std::ranges::copy(model.parts, out).out;
    sort(parts, rank_models(view, placements, arena));
    parts_ = parts;
    counts.bytes = parts.size_bytes();
    return counts;
  }

  void draw_band(const render::FrameContext& context, const render::ViewFrame& view, const render::Band& band,
                 const render::SpanSources& sources, render::FrameBuffer& io_frame) const {
    const render::RowRange rows{band.first_row, band.first_row + band.row_count};
    auto next = parts_.begin();
    for (std::size_t position = 0; position < band.draws.size(); ++position) {
      const std::uint32_t number = band.draws[position];
      if (number >= sources.draws.first_deferred) break;
      for (; number != 0 && next != parts_.end() && next->place.behind > draw_keys_[number]; ++next)
        paint(*next, rows, io_frame);
      render::Band one = band;
      one.draws = band.draws.subspan(position, 1);
      one.span_begin = band.span_begin.subspan(position, 2);
      render::draw_band_spans(context, view, one, sources, io_frame);
    }
    for (; next != parts_.end(); ++next) paint(*next, rows, io_frame);
  }

 private:
  void cut_models(const render::FrameContext& context, const CutRules& rules,
                  std::span<const render::AliasPlacement> placements) {
    for_each_model(context, prepared_.size(), arenas_, [&](std::size_t i, base::Arena& io_arena) {
      models_[i] =
          cut_into_leaves(rules, placements[i], prepared_[i], static_cast<std::uint32_t>(i), io_arena);
    });
  }

  // By model: farther ones have smaller numbers.
  static std::span<const double> rank_models(const render::ViewFrame& view,
                                             std::span<const render::AliasPlacement> placements,
                                             base::Arena& arena) {
    const std::span<double> ranks = arena.allocate<double>(placements.size());
    for (std::size_t i = 0; i < ranks.size(); ++i)
      ranks[i] = -view.to_view(math::Vec3d(placements[i].instance->origin_world)).z;
    return ranks;
  }

  static void sort(std::span<LeafPart> io_parts, std::span<const double> ranks) {
    std::ranges::sort(io_parts, {}, [&](const LeafPart& part) {
      return std::tuple(part.place.order, ranks[part.model], part.model, part.depth, part.triangle);
    });
  }

  void paint(const LeafPart& part, render::RowRange rows, render::FrameBuffer& io_frame) const {
    if (part.first_row >= rows.end || part.end <= rows.first) return;
    const render::TriangleTarget target = make_model_target(prepared_[part.model], rows, io_frame);
    if (target.row_begin >= target.row_end) return;
    const render::TriangleJob& job = models_[part.model].job;
    io_frame.format() == render::PixelFormat::kIndexed
        ? paint_triangle<std::uint8_t>(job, part.triangle, target)
        : paint_triangle<std::uint32_t>(job, part.triangle, target);
  }

  const bool cuts_;
  render::VisibleFaces visible_;
  std::span<render::SortKey> draw_keys_;
  std::span<const render::PreparedAlias> prepared_;
  std::span<LeafParts> models_;
  std::span<const LeafPart> parts_;  // from back to front
  std::vector<base::Arena> arenas_;  // by job
};

constexpr std::array kAllOfThePvs{1.0};

}  // namespace

render::FrameStages make_models_in_leaves(std::span<const double> values, Counter* counter) {
  const auto state = std::make_shared<ModelsInLeaves>(values[0] != 0);
  const render::FrameStages painter = make_painter(kAllOfThePvs, nullptr);
  render::FrameStages stages;
  stages.find_visible_faces = [=](const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::LevelTables& tables) {
    const render::VisibleFaces visible = render::find_visible_faces(context, view, tables);
    state->begin_frame(visible);
    return visible;
  };
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    state->set_draws(context, table);
    return painter.scan_edges(context, view, table);
  };
  stages.prepare_alias_models = [=](const render::FrameContext& context, const render::ViewFrame& view) {
    const Counts counts = state->prepare(context, view);
    if (counter != nullptr) counter->add(counts);
    return std::span<const render::PreparedAlias>();
  };
  stages.draw_band_spans = [=](const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    state->draw_band(context, view, band, sources, io_frame);
  };
  stages.draw_alias_models = [](std::span<const render::PreparedAlias> /*models*/, bool /*simd_kernels*/,
                                render::RowRange /*rows*/, render::FrameBuffer& /*io_frame*/) {};
  return stages;
}

}  // namespace temblor::lab
