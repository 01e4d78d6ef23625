#include "lab/models/edges/row_painter.h"

namespace temblor::lab {

namespace {

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

}  // namespace

RowPainter::RowPainter(const RowKernels& kernels, const render::TriangleTarget& target, base::Arena& arena)
    : kernels_(kernels), target_(target), rows_(arena.allocate<render::RowList>(1).front()) {
  rows_.size = rows_.ordered = rows_.groups = 0;
}

void RowPainter::begin_model(const render::TriangleJob& job) {
  draw();
  job_ = job;
  job_.has_short_rows = false;
}

void RowPainter::add(const render::TriangleSpan& span) {
  if (!kernels_.simd) {
    kernels_.format == render::PixelFormat::kIndexed ? draw_span<std::uint8_t>(job_, span, target_)
                                                     : draw_span<std::uint32_t>(job_, span, target_);
    return;
  }
  append(span, target_.width, rows_);
  if (rows_.size == render::RowList::kCapacity) draw();
}

void RowPainter::draw() {
  if (rows_.size == 0) return;
  kernels_.format == render::PixelFormat::kIndexed ? render::draw_rows_u8_simd(job_, rows_, target_)
                                                   : render::draw_rows_u32_simd(job_, rows_, target_);
  rows_.size = rows_.ordered = 0;
}

}  // namespace temblor::lab
