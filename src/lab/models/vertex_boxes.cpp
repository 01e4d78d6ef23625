#include "lab/models/vertex_boxes.h"

#include <algorithm>
#include <memory>

#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"
#include "render/alias/affine_triangle.h"

namespace temblor::lab {

namespace {

// The box's pixels are those around the vertex, which is never nearer than half a pixel to the box's border.
template <typename Pixel>
class BoxPainter {
 public:
  BoxPainter(const render::TriangleJob& job, const render::TriangleTarget& target)
      : job_(job), target_(target) {}

  void draw_all() {
    for (std::size_t i = 0; i < job_.vertex_count; ++i) draw(i);
  }
  void draw_of_triangles() {
    for (std::size_t i = 0; i < 3 * job_.triangle_count; ++i) draw(job_.triangles[i]);
  }

 private:
  void draw(std::size_t number) {
    const render::ScreenVertex& vertex = job_.vertices[number];
    const std::int32_t x = vertex.x >> 8, y = vertex.y >> 8;
    const std::int32_t first_x = std::max(x, 0), end_x = std::min(x + 2, target_.width);
    const std::int32_t first_y = std::max(y, target_.row_begin), end_y = std::min(y + 2, target_.row_end);
    if (first_x >= end_x || first_y >= end_y) return;
    const render::TexelPoint& texel = job_.texels[number];
    const std::int32_t s = static_cast<std::int32_t>(texel.s), t = static_cast<std::int32_t>(texel.t);
    render::TriangleSpan lit{};
    lit.light = vertex.light;
    const Pixel color = render::lit_texel(job_, job_.skin[t * job_.skin_width + s], lit, 0, Pixel{});
    for (std::int32_t row = first_y; row < end_y; ++row)
      for (std::int32_t column = first_x; column < end_x; ++column) plot(column, row, vertex.depth, color);
  }

  void plot(std::int32_t x, std::int32_t y, float depth, Pixel color) {
    const std::size_t at =
        static_cast<std::size_t>(y - target_.first_row) * static_cast<std::size_t>(target_.width) +
        static_cast<std::size_t>(x);
    if (!(depth >= target_.depth[at])) return;
    target_.depth[at] = depth;
    static_cast<Pixel*>(target_.pixels)[at] = color;
  }

  const render::TriangleJob& job_;
  const render::TriangleTarget& target_;
};

template <typename Pixel>
void draw_model(const render::TriangleJob& job, bool is_clipped, const render::TriangleTarget& target) {
  BoxPainter<Pixel> painter(job, target);
  is_clipped ? painter.draw_of_triangles() : painter.draw_all();
}

}  // namespace

render::FrameStages make_vertex_boxes(std::span<const double> /*values*/, Counter* /*counter*/) {
  // The placements of the frame's models, in their order.
  const auto placements = std::make_shared<std::span<const render::AliasPlacement>>();
  render::FrameStages stages;
  stages.prepare_alias_models = [=](const render::FrameContext& context, const render::ViewFrame& view) {
    // By subdivision, the engine does not look for front faces, which boxes do not need.
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kSubdivision;
    *placements = render::place_alias_models(context.scene, view, context.arena());
    return std::span<const render::PreparedAlias>(
        render::prepare_placed_models(with_settings(context, settings), view, *placements));
  };
  stages.draw_alias_models = [=](std::span<const render::PreparedAlias> models, bool /*simd_kernels*/,
                                 render::RowRange rows, render::FrameBuffer& io_frame) {
    for (std::size_t i = 0; i < models.size(); ++i) {
      const render::TriangleTarget target = make_model_target(models[i], rows, io_frame);
      if (target.row_begin >= target.row_end) continue;
      const bool is_clipped = (*placements)[i].needs_clipping;
      io_frame.format() == render::PixelFormat::kIndexed
          ? draw_model<std::uint8_t>(models[i].job, is_clipped, target)
          : draw_model<std::uint32_t>(models[i].job, is_clipped, target);
    }
  };
  return stages;
}

}  // namespace temblor::lab
