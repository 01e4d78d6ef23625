#include "lab/models/triangle_masks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>

#include "lab/models/prepare_with_settings.h"
#include "lab/models/small_masks.h"
#include "lab/models/split_triangles.h"
#include "render/alias/affine_triangle.h"

namespace temblor::lab {

namespace {

// The front triangles of a model, by size.
struct SizedTriangles {
  render::FrontTriangles small, large;
};

// A front triangle in whole pixels.
struct WholeCorners {
  std::array<SmallMasks::Corner, 3> corner;
  std::int32_t left, top, right, bottom;
};

WholeCorners find_corners(const render::TriangleJob& job, std::size_t number) {
  WholeCorners whole;
  for (std::size_t i = 0; i < 3; ++i) {
    const render::ScreenVertex& vertex = job.vertices[job.triangles[number * 3 + i]];
    whole.corner[i] = {vertex.x >> 8, vertex.y >> 8};
  }
  const auto& [a, b, c] = whole.corner;
  whole.left = std::min({a.x, b.x, c.x});
  whole.right = std::max({a.x, b.x, c.x});
  whole.top = std::min({a.y, b.y, c.y});
  whole.bottom = std::max({a.y, b.y, c.y});
  return whole;
}

render::FrontTriangles make_fronts(std::size_t triangles, base::Arena& arena) {
  const std::size_t room = triangles + render::kFrontsSpare;
  return {arena.allocate<std::uint32_t>(room).data(), arena.allocate<render::TriangleRows>(room).data(), 0};
}

void append(std::uint32_t number, render::TriangleRows rows, render::FrontTriangles& io_fronts) {
  io_fronts.numbers[io_fronts.count] = number;
  io_fronts.rows[io_fronts.count++] = rows;
}

SizedTriangles sort_by_size(render::PreparedAlias& io_alias, std::int32_t side, base::Arena& arena) {
  render::TriangleJob& job = io_alias.job;
  if (job.fronts.numbers == nullptr) {
    job.fronts = make_fronts(job.triangle_count, arena);
    render::find_front_triangles_scalar(job, job.fronts);
  }
  SizedTriangles sized{make_fronts(job.fronts.count, arena), make_fronts(job.fronts.count, arena)};
  for (std::size_t i = 0; i < job.fronts.count; ++i) {
    const std::uint32_t number = job.fronts.numbers[i];
    const WholeCorners whole = find_corners(job, number);
    const bool is_small = whole.right - whole.left <= side && whole.bottom - whole.top <= side;
    append(number, job.fronts.rows[i], is_small ? sized.small : sized.large);
  }
  return sized;
}

// Hot loop. Scalar: most of these triangles have a few pixels.
template <typename Pixel>
class MaskPainter {
 public:
  MaskPainter(const SmallMasks& masks, const render::TriangleJob& job, const render::TriangleTarget& target)
      : masks_(masks), job_(job), target_(target) {}

  void draw(std::uint32_t number) {
    const WholeCorners whole = find_corners(job_, number);
    const auto relative = [&](const SmallMasks::Corner& corner) {
      return SmallMasks::Corner{corner.x - whole.left, corner.y - whole.top};
    };
    const SmallMasks::Corner a = relative(whole.corner[0]), b = relative(whole.corner[1]),
                             c = relative(whole.corner[2]);
    std::uint32_t mask = masks_.find(a, b, c);
    if (mask == 0) return;
    const std::uint32_t* index = job_.triangles + std::size_t{number} * 3;
    const render::ScreenVertex* const corner[3] = {job_.vertices + index[0], job_.vertices + index[1],
                                                   job_.vertices + index[2]};
    const render::TexelPoint* const texel[3] = {job_.texels + index[0], job_.texels + index[1],
                                                job_.texels + index[2]};
    const auto bx = static_cast<float>(b.x - a.x), by = static_cast<float>(b.y - a.y);
    const auto cx = static_cast<float>(c.x - a.x), cy = static_cast<float>(c.y - a.y);
    const float scale = 1 / (bx * cy - cx * by);
    const auto make_line = [&](float at_a, float at_b, float at_c) {
      const float along_b = (at_b - at_a) * scale, along_c = (at_c - at_a) * scale;
      return Line{at_a, along_b * cy - along_c * by, along_c * bx - along_b * cx};
    };
    const Line depth = make_line(corner[0]->depth, corner[1]->depth, corner[2]->depth);
    const Line light = make_line(corner[0]->light, corner[1]->light, corner[2]->light);
    const Line s = make_line(texel[0]->s, texel[1]->s, texel[2]->s);
    const Line t = make_line(texel[0]->t, texel[1]->t, texel[2]->t);
    for (; mask != 0; mask &= mask - 1) {
      const std::int32_t bit = std::countr_zero(mask);
      const std::int32_t column = bit % SmallMasks::kMaxSide, row = bit / SmallMasks::kMaxSide;
      const std::int32_t x = whole.left + column, y = whole.top + row;
      if (x < 0 || x >= target_.width || y < target_.row_begin || y >= target_.row_end) continue;
      const auto right = static_cast<float>(column - a.x), down = static_cast<float>(row - a.y);
      const std::size_t at =
          static_cast<std::size_t>(y - target_.first_row) * static_cast<std::size_t>(target_.width) +
          static_cast<std::size_t>(x);
      const float here = depth.at(right, down);
      if (!(here >= target_.depth[at])) continue;
      target_.depth[at] = here;
      render::TriangleSpan pixel{};
      pixel.s = s.at(right, down);
      pixel.t = t.at(right, down);
      pixel.light = light.at(right, down);
      static_cast<Pixel*>(target_.pixels)[at] =
          render::lit_texel(job_, render::skin_texel(job_, pixel, 0, here), pixel, 0, Pixel{});
    }
  }

 private:
  // A linear function of the pixels from corner a.
  struct Line {
    float at_a, dx, dy;
    float at(float right, float down) const { return at_a + dx * right + dy * down; }
  };

  const SmallMasks& masks_;
  const render::TriangleJob& job_;
  const render::TriangleTarget& target_;
};

template <typename Pixel>
void draw_small(const SmallMasks& masks, const render::TriangleJob& job, const render::FrontTriangles& small,
                const render::TriangleTarget& target) {
  MaskPainter<Pixel> painter(masks, job, target);
  for (std::size_t i = 0; i < small.count; ++i)
    if (small.rows[i].first < target.row_end && small.rows[i].end > target.row_begin)
      painter.draw(small.numbers[i]);
}

template <typename Pixel>
void draw_large_scalar(const render::TriangleJob& job, const render::FrontTriangles& large,
                       const render::TriangleTarget& target) {
  for (std::size_t i = 0; i < large.count; ++i)
    render::draw_affine_triangle(job, large.numbers[i], target, [&](const render::TriangleSpan& span) {
      const std::size_t first =
          static_cast<std::size_t>(span.y - target.first_row) * static_cast<std::size_t>(target.width) +
          static_cast<std::size_t>(span.x);
      for (std::int32_t pixel = 0; pixel < span.count; ++pixel) {
        const float lane = static_cast<float>(pixel), depth = span.depth + lane * span.depth_step;
        const std::size_t at = first + static_cast<std::size_t>(pixel);
        if (!(depth >= target.depth[at])) continue;
        target.depth[at] = depth;
        static_cast<Pixel*>(target.pixels)[at] =
            render::lit_texel(job, render::skin_texel(job, span, lane, depth), span, lane, Pixel{});
      }
    });
}

void draw_large(const render::TriangleJob& job, const render::FrontTriangles& large, bool is_indexed,
                bool simd_kernels, const render::TriangleTarget& target) {
  if (large.count == 0) return;
  if (!simd_kernels) {
    is_indexed ? draw_large_scalar<std::uint8_t>(job, large, target)
               : draw_large_scalar<std::uint32_t>(job, large, target);
    return;
  }
  render::TriangleJob only_large = job;
  only_large.fronts = large;
  is_indexed ? render::draw_triangles_u8_simd(only_large, target)
             : render::draw_triangles_u32_simd(only_large, target);
}

}  // namespace

render::FrameStages make_triangle_masks(std::span<const double> values, Counter* counter) {
  const auto side = static_cast<std::int32_t>(values[0]);
  const auto masks = std::make_shared<const SmallMasks>();
  const auto sized = std::make_shared<std::span<SizedTriangles>>();  // by model of the frame
  render::FrameStages stages;
  stages.prepare_alias_models = [=](const render::FrameContext& context, const render::ViewFrame& view) {
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kAffine;
    settings.alias_snap = true;
    const std::span<render::PreparedAlias> prepared =
        render::prepare_placed_models(with_settings(context, settings), view,
                                      render::place_alias_models(context.scene, view, context.arena()));
    *sized = context.arena().allocate<SizedTriangles>(prepared.size());
    for (std::size_t i = 0; i < prepared.size(); ++i)
      (*sized)[i] = sort_by_size(prepared[i], side, context.arena());
    if (counter != nullptr) counter->add({.bytes = masks->size_bytes()});
    return std::span<const render::PreparedAlias>(prepared);
  };
  stages.draw_alias_models = [=](std::span<const render::PreparedAlias> models, bool simd_kernels,
                                 render::RowRange rows, render::FrameBuffer& io_frame) {
    const bool is_indexed = io_frame.format() == render::PixelFormat::kIndexed;
    for (std::size_t i = 0; i < models.size(); ++i) {
      const render::TriangleTarget target = make_model_target(models[i], rows, io_frame);
      if (target.row_begin >= target.row_end) continue;
      const SizedTriangles& own = (*sized)[i];
      is_indexed ? draw_small<std::uint8_t>(*masks, models[i].job, own.small, target)
                 : draw_small<std::uint32_t>(*masks, models[i].job, own.small, target);
      draw_large(models[i].job, own.large, is_indexed, simd_kernels, target);
    }
  };
  return stages;
}

}  // namespace temblor::lab
