#include "lab/models/small/small_triangles.h"

#include <algorithm>
#include <bit>
#include <memory>

#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"

namespace temblor::lab {

namespace {

// The front triangles of a model, by size.
struct SizedTriangles {
  std::span<const SmallTriangle> small;
  render::FrontTriangles large;
};

// A triangle in whole pixels. The corners are from the top left corner of its box.
struct WholeTriangle {
  SmallCorners corners;
  std::int32_t left, top, width, height;
};

WholeTriangle find_whole_triangle(const render::TriangleJob& job, std::uint32_t number) {
  const std::uint32_t* index = job.triangles + std::size_t{number} * 3;
  std::int32_t x[3], y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = job.vertices[index[i]].x >> 8;
    y[i] = job.vertices[index[i]].y >> 8;
  }
  const std::int32_t left = std::min({x[0], x[1], x[2]}), top = std::min({y[0], y[1], y[2]});
  return {{{x[0] - left, y[0] - top}, {x[1] - left, y[1] - top}, {x[2] - left, y[2] - top}},
          left,
          top,
          std::max({x[0], x[1], x[2]}) - left,
          std::max({y[0], y[1], y[2]}) - top};
}

render::FrontTriangles make_fronts(std::size_t triangles, base::Arena& arena) {
  const std::size_t room = triangles + render::kFrontsSpare;
  return {arena.allocate<std::uint32_t>(room).data(), arena.allocate<render::TriangleRows>(room).data(), 0};
}

SizedTriangles sort_by_size(render::PreparedAlias& io_alias, std::int32_t side, base::Arena& arena) {
  render::TriangleJob& job = io_alias.job;
  if (job.fronts.numbers == nullptr) {
    job.fronts = make_fronts(job.triangle_count, arena);
    render::find_front_triangles_scalar(job, job.fronts);
  }
  const std::span<SmallTriangle> room = arena.allocate<SmallTriangle>(job.fronts.count);
  std::size_t small = 0;
  render::FrontTriangles large = make_fronts(job.fronts.count, arena);
  for (std::size_t i = 0; i < job.fronts.count; ++i) {
    const std::uint32_t number = job.fronts.numbers[i];
    const WholeTriangle whole = find_whole_triangle(job, number);
    if (whole.width <= side && whole.height <= side) {
      room[small++] = {number,
                       whole.left,
                       whole.top,
                       static_cast<std::uint8_t>(whole.width),
                       static_cast<std::uint8_t>(whole.height),
                       static_cast<std::uint16_t>(SmallMasks::number(whole.corners))};
    } else {
      large.numbers[large.count] = number;
      large.rows[large.count++] = job.fronts.rows[i];
    }
  }
  return {room.first(small), large};
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

// A pixel of a triangle's box, by the bit of a mask.
struct Place {
  float column, row;
};
constexpr auto kPlaces = [] {
  std::array<Place, SmallMasks::kMaxSide * SmallMasks::kMaxSide> places{};
  for (std::size_t bit = 0; bit < places.size(); ++bit)
    places[bit] = {static_cast<float>(bit % SmallMasks::kMaxSide),
                   static_cast<float>(bit / SmallMasks::kMaxSide)};
  return places;
}();

constexpr Values splat(float value) {
  return Values{value, value, value, value};
}

}  // namespace

template <typename Pixel>
SmallPainter<Pixel>::SmallPainter(const render::TriangleJob& job, const render::TriangleTarget& target)
    : job_(job), target_(target), drawing_{} {
  const bool is_indexed = sizeof(Pixel) == 1;
  drawing_.most = Values{0, is_indexed ? render::kDarkestRow : render::kBrightestLight,
                         static_cast<float>(job.skin_width - 1), static_cast<float>(job.skin_height - 1)};
  drawing_.skin = job.skin;
  drawing_.colors = job.colors;
  drawing_.width = static_cast<std::size_t>(target.width);
  drawing_.skin_width = job.skin_width;
  drawing_.job = &job;
  drawing_.skin_steps[1] = drawing_.skin_steps[2] = 1;
  drawing_.skin_steps[3] = static_cast<std::int16_t>(job.skin_width);
  for (int channel = 0; channel < 3; ++channel)
    drawing_.tint[2 - channel] = static_cast<std::uint16_t>(job.tint[channel]);
}

template <typename Pixel>
typename SmallPainter<Pixel>::Corner SmallPainter<Pixel>::set_values(const SmallTriangle& triangle) {
  const std::uint32_t* index = job_.triangles + std::size_t{triangle.number} * 3;
  const render::ScreenVertex &a = job_.vertices[index[0]], &b = job_.vertices[index[1]],
                             &c = job_.vertices[index[2]];
  const auto values = [&](std::size_t corner, const render::ScreenVertex& vertex) {
    const render::TexelPoint& texel = job_.texels[index[corner]];
    return Values{vertex.depth, vertex.light, texel.s, texel.t};
  };
  const std::int32_t a_x = a.x >> 8, a_y = a.y >> 8;
  const auto bx = static_cast<float>((b.x >> 8) - a_x), by = static_cast<float>((b.y >> 8) - a_y);
  const auto cx = static_cast<float>((c.x >> 8) - a_x), cy = static_cast<float>((c.y >> 8) - a_y);
  const float scale = 1 / (bx * cy - cx * by);
  drawing_.at_a = values(0, a);
  const Values along_b = (values(1, b) - drawing_.at_a) * scale;
  const Values along_c = (values(2, c) - drawing_.at_a) * scale;
  drawing_.per_column = along_b * cy - along_c * by;
  drawing_.per_row = along_c * bx - along_b * cx;
  return {static_cast<float>(a_x - triangle.left), static_cast<float>(a_y - triangle.top)};
}

template <typename Pixel>
const SmallDrawing& SmallPainter<Pixel>::start(const SmallTriangle& triangle, std::int32_t column,
                                               std::int32_t row) {
  const Corner a = set_values(triangle);
  drawing_.right = splat(static_cast<float>(column) - a.x);
  drawing_.down = splat(static_cast<float>(row) - a.y);
  const std::size_t at = static_cast<std::size_t>(triangle.top + row - target_.first_row) * drawing_.width +
                         static_cast<std::size_t>(triangle.left + column);
  drawing_.depth = target_.depth + at;
  drawing_.pixels = static_cast<Pixel*>(target_.pixels) + at;
  return drawing_;
}

template <typename Pixel>
std::uint32_t SmallPainter<Pixel>::clip_mask(const SmallTriangle& triangle, std::uint32_t mask) const {
  for (std::uint32_t left = mask; left != 0; left &= left - 1) {
    const int bit = std::countr_zero(left);
    const std::int32_t x = triangle.left + bit % SmallMasks::kMaxSide;
    const std::int32_t y = triangle.top + bit / SmallMasks::kMaxSide;
    if (x < 0 || x >= target_.width || y < target_.row_begin || y >= target_.row_end)
      mask &= ~(std::uint32_t{1} << bit);
  }
  return mask;
}

template <typename Pixel>
void SmallPainter<Pixel>::draw_mask(const SmallTriangle& triangle, std::uint32_t mask) {
  if (!has_all_pixels(triangle)) mask = clip_mask(triangle, mask);
  if (mask == 0) return;
  const Corner a = set_values(triangle);
  const auto width = static_cast<std::ptrdiff_t>(drawing_.width);
  const std::ptrdiff_t first = (triangle.top - target_.first_row) * width + triangle.left;
  for (; mask != 0; mask &= mask - 1) {
    const int bit = std::countr_zero(mask);
    const Place& place = kPlaces[static_cast<std::size_t>(bit)];
    const std::ptrdiff_t at = first + bit / SmallMasks::kMaxSide * width + bit % SmallMasks::kMaxSide;
    const Values values =
        drawing_.at_a + drawing_.per_column * (place.column - a.x) + drawing_.per_row * (place.row - a.y);
    draw_small_pixel(drawing_, values, target_.depth[at], static_cast<Pixel*>(target_.pixels)[at]);
  }
}

template class SmallPainter<std::uint8_t>;
template class SmallPainter<std::uint32_t>;

render::FrameStages make_small_triangle_stages(std::int32_t side,
                                               std::shared_ptr<const SmallTriangleCode> code,
                                               Counter* counter) {
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
    if (counter != nullptr) counter->add({.bytes = code->size_bytes()});
    return std::span<const render::PreparedAlias>(prepared);
  };
  stages.draw_alias_models = [=](std::span<const render::PreparedAlias> models, bool simd_kernels,
                                 render::RowRange rows, render::FrameBuffer& io_frame) {
    const bool is_indexed = io_frame.format() == render::PixelFormat::kIndexed;
    for (std::size_t i = 0; i < models.size(); ++i) {
      const render::TriangleTarget target = make_model_target(models[i], rows, io_frame);
      if (target.row_begin >= target.row_end) continue;
      const SizedTriangles& own = (*sized)[i];
      code->draw(models[i].job, own.small, io_frame.format(), target);
      draw_large(models[i].job, own.large, is_indexed, simd_kernels, target);
    }
  };
  return stages;
}

}  // namespace temblor::lab
