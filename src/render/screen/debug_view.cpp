#include "render/screen/debug_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/screen/painter.h"

namespace temblor::render {

namespace {

// A color for a number; consecutive numbers get clearly different colors. Never too dark to see.
formats::Rgb hash_color(std::uint32_t number) {
  std::uint32_t mixed = number * 0x9e3779b9u;
  mixed ^= mixed >> 15;
  mixed *= 0x85ebca6bu;
  mixed ^= mixed >> 13;
  const auto channel = [&](int shift) {
    return static_cast<std::uint8_t>(48 + (mixed >> shift & 255) * 207 / 255);
  };
  return {channel(0), channel(8), channel(16)};
}

formats::Rgb gray(double brightness) {
  const auto value = static_cast<std::uint8_t>(std::clamp(brightness, 0.0, 1.0) * 255);
  return {value, value, value};
}

// From mip -3 to 3. Stock textures begin at 0.
constexpr formats::Rgb kMipColors[] = {{250, 250, 250}, {250, 200, 230}, {230, 110, 190}, {220, 60, 50},
                                       {230, 180, 40},  {70, 180, 80},   {60, 100, 220}};

template <typename Body>  // Body(draw number, span)
void for_each_span(const SpanTable& spans, Body body) {
  for (const Band& band : spans.bands)
    for (std::size_t position = 0; position < band.draws.size(); ++position)
      for (std::uint32_t i = band.span_begin[position]; i < band.span_begin[position + 1]; ++i)
        body(band.draws[position], band.spans[i]);
}

std::size_t first_pixel(const FrameBuffer& frame, const Span& span) {
  return std::size_t{span.y} * static_cast<std::size_t>(frame.width()) + span.x;
}

// Fills every span with color(draw, span).
template <typename Color>
void fill_spans(const SpanTable& spans, Painter& painter, const FrameBuffer& frame, Color color) {
  for_each_span(spans, [&](std::uint32_t draw, const Span& span) {
    const formats::Rgb shown = color(draw, span);
    for (std::size_t i = 0; i < span.count; ++i) painter.put(first_pixel(frame, span) + i, shown);
  });
}

// Draws the edges over the picture: white if two surfaces share the edge, yellow if it bounds only one.
void draw_edges(const EdgeTable& table, Painter& painter, const FrameBuffer& frame) {
  for (const Edge& edge : table.edges) {
    const bool shared = edge.leading != kBackground && edge.trailing != kBackground;
    const formats::Rgb color = shared ? formats::Rgb{255, 255, 255} : formats::Rgb{255, 220, 0};
    for (std::int32_t row = edge.first_row; row <= edge.last_row; ++row) {
      const double x = std::ceil(edge.x_first + edge.step * (row - edge.first_row));
      // A flat edge covers several pixels of a row.
      const double reach = std::min(std::abs(edge.step), static_cast<double>(frame.width()));
      for (double at = x; at <= x + reach; ++at)
        if (at >= 0 && at < frame.width())
          painter.put(static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width()) +
                          static_cast<std::size_t>(at),
                      color);
    }
  }
}

// Colors faces by leaf, the unit of the potentially visible set. A face that borders several leaves gets the
// color of the first one.
void draw_leaves(const DebugViewInput& frame, Painter& painter, const FrameBuffer& io_frame) {
  const world::Level& level = frame.level;
  std::vector<std::uint32_t> leaf_of_face(level.faces.size(), 0);
  for (std::size_t leaf = level.leaves.size(); leaf-- > 1;) {
    const world::Leaf& marked = level.leaves[leaf];
    for (std::uint32_t i = 0; i < marked.marked_face_count; ++i)
      leaf_of_face[base::to_size(level.marked_faces[marked.first_marked_face + i])] =
          static_cast<std::uint32_t>(leaf);
  }
  fill_spans(frame.spans, painter, io_frame, [&](std::uint32_t draw, const Span&) {
    const ScreenSurface& surface = frame.edges.surfaces[base::to_size(frame.draws.all[draw].surface)];
    return draw == 0 ? formats::Rgb{} : hash_color(leaf_of_face[base::to_size(surface.face)]);
  });
}

// Nearer is brighter, scaled to the range of depths in the frame.
void draw_depth(Painter& painter, FrameBuffer& io_frame) {
  const float nothing = std::numeric_limits<float>::lowest();
  float least = std::numeric_limits<float>::max(), most = nothing;
  for (const float depth : io_frame.depth()) {
    if (depth == nothing) continue;
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
  const double range = std::max<double>(static_cast<double>(most) - static_cast<double>(least), 1e-12);
  for (std::size_t i = 0; i < io_frame.pixel_count(); ++i) {
    const float depth = io_frame.depth()[i];
    const double brightness =
        depth == nothing ? 0 : (static_cast<double>(depth) - static_cast<double>(least)) / range;
    painter.put(i, gray(std::sqrt(brightness)));
  }
}

}  // namespace

void draw_debug_view(Show show, const DebugViewInput& frame, const formats::Palette& palette,
                     FrameBuffer& io_frame) {
  Painter painter(palette, io_frame);
  const auto find_surface = [&](std::uint32_t draw) -> const ScreenSurface& {
    return frame.edges.surfaces[base::to_size(frame.draws.all[draw].surface)];
  };
  switch (show) {
    case Show::kPicture:
      return;
    case Show::kPvs:
      return draw_leaves(frame, painter, io_frame);
    case Show::kFaces:
      return fill_spans(frame.spans, painter, io_frame, [&](std::uint32_t draw, const Span&) {
        const ScreenSurface& surface = find_surface(draw);
        return draw == 0 ? formats::Rgb{}
                         : hash_color(static_cast<std::uint32_t>(surface.face) + surface.instance * 7919);
      });
    case Show::kSpans: {
      std::uint32_t number = 0;
      return fill_spans(frame.spans, painter, io_frame,
                        [&](std::uint32_t, const Span&) { return hash_color(++number); });
    }
    case Show::kSurfaces:
      return fill_spans(frame.spans, painter, io_frame, [&](std::uint32_t draw, const Span&) {
        return draw == 0 ? formats::Rgb{} : hash_color(draw);
      });
    case Show::kMips:
      return fill_spans(frame.spans, painter, io_frame, [&](std::uint32_t draw, const Span&) {
        return draw == 0 ? formats::Rgb{}
                         : kMipColors[frame.draws.all[draw].mip + formats::kMaxTextureDetail];
      });
    case Show::kOverdraw: {
      std::vector<std::uint8_t> writes(io_frame.pixel_count(), 0);
      for_each_span(frame.spans, [&](std::uint32_t, const Span& span) {
        for (std::size_t i = 0; i < span.count; ++i) ++writes[first_pixel(io_frame, span) + i];
      });
      for (std::size_t i = 0; i < io_frame.pixel_count(); ++i) painter.put(i, gray(writes[i] / 4.0));
      return;
    }
    case Show::kEdges:
      return draw_edges(frame.edges, painter, io_frame);
    case Show::kDepth:
      return draw_depth(painter, io_frame);
  }
}

}  // namespace temblor::render
