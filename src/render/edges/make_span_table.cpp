#include "render/edges/make_span_table.h"

#include <algorithm>
#include <cmath>

#include "render/edges/scan_deferred_faces.h"

namespace temblor::render {

namespace {

// Texture coordinates of a face that is cut into tiles, in texels of mip 0 from the face's first texel.
struct TilePlanes {
  TileGrid tiles;
  ScreenPlane depth, s, t;
};

// By first draw of a surface; null for surfaces with one tile. Empty if no surface has more.
std::span<const TilePlanes*> make_tile_planes(const FrameContext& context, const ViewFrame& view,
                                              const EdgeTable& table) {
  base::Arena& arena = context.arena();
  std::span<const TilePlanes*> planes;
  for (const ScreenSurface& surface : table.surfaces) {
    if (surface.tiles.s == 1 && surface.tiles.t == 1) continue;
    if (planes.empty()) planes = arena.allocate_filled<const TilePlanes*>(table.draw_count, nullptr);
    const world::Level& level = context.level();
    const FacePlacement placed =
        place_face(level, level.face(surface.face), table.model_views[surface.instance]);
    std::span<TilePlanes> made = arena.allocate<TilePlanes>(1);
    made[0].tiles = surface.tiles;
    made[0].depth = depth_plane(view, placed.normal, placed.distance);
    made[0].s = coordinate_plane(view, made[0].depth, placed.s_axis, placed.s_offset);
    made[0].t = coordinate_plane(view, made[0].depth, placed.t_axis, placed.t_offset);
    planes[surface.first_draw] = made.data();
  }
  return planes;
}

// One texture coordinate along a scan line: (a + b i) / (c + d i), where i counts from the span's first
// pixel.
struct Along {
  double a, b, c, d;

  static Along make(const ScreenPlane& coordinate, const ScreenPlane& depth, bool perspective, int x, int y) {
    if (!perspective) return {coordinate.at(x, y), coordinate.dx, 1, 0};
    return {coordinate.at(x, y), coordinate.dx, depth.at(x, y), depth.dx};
  }
  int tile(int i, int tiles) const {
    const double tile = std::floor((a + b * i) / (c + d * i) / kTileTexels);
    if (!(tile > 0)) return 0;  // also NaN, on a face whose corners are off its plane
    return static_cast<int>(std::min(tile, tiles - 1.0));
  }
  // The first pixel after i that is not in tile number `tile`, which i is in; `end` if there is none.
  int tile_end(int i, int tile, int tiles, int end) const {
    const bool rising = b * c - a * d > 0;  // the sign of the derivative, constant along the line
    if (rising ? tile + 1 >= tiles : tile == 0) return end;
    const double border = (rising ? tile + 1 : tile) * static_cast<double>(kTileTexels);
    const double slope = b - border * d;
    const double at = std::ceil((border * c - a) / slope);
    if (!(at < end)) return end;
    return std::max(i + 1, static_cast<int>(std::max(at, 0.0)));
  }
};

// Cuts a span where the tile changes in s or t. Always advances by at least one pixel, whatever rounding
// does.
void split_at_tiles(const DrawSpan& span, const TilePlanes& planes, bool perspective,
                    base::ArenaVector<DrawSpan>& io_spans) {
  const Span& pixels = span.span;
  const Along s = Along::make(planes.s, planes.depth, perspective, pixels.x, pixels.y);
  const Along t = Along::make(planes.t, planes.depth, perspective, pixels.x, pixels.y);
  for (int i = 0; i < pixels.count;) {
    const int tile_s = s.tile(i, planes.tiles.s), tile_t = t.tile(i, planes.tiles.t);
    const int end = std::min({s.tile_end(i, tile_s, planes.tiles.s, pixels.count),
                              t.tile_end(i, tile_t, planes.tiles.t, pixels.count), int{pixels.count}});
    const std::uint32_t tile =
        static_cast<std::uint32_t>(tile_t) * planes.tiles.s + static_cast<std::uint32_t>(tile_s);
    io_spans.push_back(
        {span.draw + tile,
         {static_cast<std::uint16_t>(pixels.x + i), pixels.y, static_cast<std::uint16_t>(end - i)}});
    i = end;
  }
}

std::span<const DrawSpan> split_at_tiles(std::span<const DrawSpan> spans,
                                         std::span<const TilePlanes* const> tile_planes, bool perspective,
                                         base::Arena& arena) {
  base::ArenaVector<DrawSpan> split(arena, spans.size() + 64);
  for (const DrawSpan& span : spans) {
    const TilePlanes* const planes = tile_planes[span.draw];
    if (planes != nullptr)
      split_at_tiles(span, *planes, perspective, split);
    else
      split.push_back(span);
  }
  return split.view();
}

PixelSum sum_pixels(std::span<const Span> spans) {
  std::uint64_t pixels = 0, twice_x = 0, y = 0;
  for (const Span& span : spans) {
    const std::uint64_t count = span.count;
    pixels += count;
    twice_x += count * (2u * span.x + count - 1);
    y += count * span.y;
  }
  return {pixels, twice_x / 2, y};
}

// A counting sort by draw. Within a draw, spans keep their order: by row, then from left to right.
Band group_by_draw(std::span<const DrawSpan> unsorted, std::uint32_t draw_count, RowRange rows,
                   base::Arena& arena) {
  std::span<std::uint32_t> count = arena.allocate_filled<std::uint32_t>(draw_count, 0);
  for (const DrawSpan& span : unsorted) ++count[span.draw];
  const std::size_t max_used = std::min(unsorted.size(), count.size());
  std::span<std::uint32_t> draws = arena.allocate<std::uint32_t>(max_used);
  std::span<std::uint32_t> span_begin = arena.allocate<std::uint32_t>(max_used + 1);
  std::uint32_t position = 0, spans_before = 0;
  for (std::uint32_t draw = 0; draw < draw_count; ++draw) {
    if (count[draw] == 0) continue;
    draws[position] = draw;
    span_begin[position++] = spans_before;
    spans_before += std::exchange(count[draw], spans_before);  // from now on: where its next span goes
  }
  span_begin[position] = spans_before;
  const std::size_t used = position;
  std::span<Span> spans = arena.allocate<Span>(unsorted.size());
  for (const DrawSpan& span : unsorted) spans[count[span.draw]++] = span.span;
  std::span<PixelSum> sums = arena.allocate<PixelSum>(used);
  for (std::size_t i = 0; i < used; ++i)
    sums[i] = sum_pixels(spans.subspan(span_begin[i], span_begin[i + 1] - span_begin[i]));
  return {rows.first, rows.end - rows.first, spans, draws.first(used), span_begin.first(used + 1), sums};
}

}  // namespace

SpanTable make_span_table(const FrameContext& context, const ViewFrame& view, const EdgeTable& table,
                          FindSpans find_spans) {
  base::Arena& arena = context.arena();
  std::vector<base::Arena>& band_arenas = context.arenas.bands;
  const int band_rows = context.settings.band_rows;
  const std::size_t band_count = static_cast<std::size_t>((view.height + band_rows - 1) / band_rows);
  FrameArenas::grow(band_arenas, band_count);
  const std::span<const TilePlanes*> tile_planes = make_tile_planes(context, view, table);
  std::span<Band> bands = arena.allocate<Band>(band_count);
  context.jobs.parallel_for(band_count, [&](std::size_t i) {
    base::Arena& band_arena = band_arenas[i];
    band_arena.reset();
    const int first_row = static_cast<int>(i) * band_rows;
    const RowRange rows{first_row, std::min(first_row + band_rows, view.height)};
    std::span<const DrawSpan> spans = find_spans(rows, band_arena);
    if (table.deferred_count() > 0) spans = add_deferred_faces(spans, table, rows, view.width, band_arena);
    if (!tile_planes.empty()) spans = split_at_tiles(spans, tile_planes, view.perspective, band_arena);
    bands[i] = group_by_draw(spans, table.draw_count, rows, band_arena);
  });
  return {bands};
}

}  // namespace temblor::render
