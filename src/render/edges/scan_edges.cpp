#include <algorithm>
#include <cmath>

#include "render/edges/scan_band.h"
#include "render/edges/scan_deferred_faces.h"
#include "render/edges/span_table.h"

namespace temblor::render {

namespace {

// Texture coordinates of a face that is cut into tiles, in texels of mip 0 from its first one.
struct TilePlanes {
  TileGrid tiles;
  ScreenPlane depth, s, t;
};

// By a surface's first item; null for surfaces of one tile. Empty when all are.
std::span<const TilePlanes*> make_tile_planes(const EdgeTable& table, const Scene& scene,
                                              const ViewFrame& view, base::Arena& arena) {
  std::span<const TilePlanes*> planes;
  for (const ScreenSurface& surface : table.surfaces) {
    if (surface.tiles.s == 1 && surface.tiles.t == 1) continue;
    if (planes.empty()) planes = arena.allocate_filled<const TilePlanes*>(table.item_count, nullptr);
    const FacePlacement placed =
        place_face(*scene.level, scene.level->face(surface.face), table.model_views[surface.instance]);
    std::span<TilePlanes> room = arena.allocate<TilePlanes>(1);
    room[0].tiles = surface.tiles;
    room[0].depth = depth_plane(view, placed.normal, placed.distance);
    room[0].s = coordinate_plane(view, room[0].depth, placed.s_axis, placed.s_offset);
    room[0].t = coordinate_plane(view, room[0].depth, placed.t_axis, placed.t_offset);
    planes[surface.first_item] = room.data();
  }
  return planes;
}

// One texture coordinate along a scan line, as (a + b i) / (c + d i), i counting from the span's first pixel.
struct Along {
  double a, b, c, d;

  static Along of(const ScreenPlane& coordinate, const ScreenPlane& depth, bool perspective, int x, int y) {
    if (!perspective) return {coordinate.at(x, y), coordinate.dx, 1, 0};
    return {coordinate.at(x, y), coordinate.dx, depth.at(x, y), depth.dx};
  }
  int tile(int i, int tiles) const {
    const double tile = std::floor((a + b * i) / (c + d * i) / kTileTexels);
    if (!(tile > 0)) return 0;  // nor a number, on a face that strays from its plane
    return static_cast<int>(std::min(tile, tiles - 1.0));
  }
  // The first pixel after i that lies in another tile than i's, `tile`; `end` when that is never.
  int tile_end(int i, int tile, int tiles, int end) const {
    const bool rising = b * c - a * d > 0;  // of constant sign along a line
    if (rising ? tile + 1 >= tiles : tile == 0) return end;
    const double border = (rising ? tile + 1 : tile) * static_cast<double>(kTileTexels);
    const double slope = b - border * d;
    const double at = std::ceil((border * c - a) / slope);
    if (!(at < end)) return end;
    return std::max(i + 1, static_cast<int>(std::max(at, 0.0)));
  }
};

void split_at_tiles(const ItemSpan& span, const TilePlanes& planes, bool perspective,
                    base::ArenaVector<ItemSpan>& io_spans) {
  const SpanRun& run = span.run;
  const Along s = Along::of(planes.s, planes.depth, perspective, run.x, run.y);
  const Along t = Along::of(planes.t, planes.depth, perspective, run.x, run.y);
  for (int i = 0; i < run.count;) {
    const int tile_s = s.tile(i, planes.tiles.s), tile_t = t.tile(i, planes.tiles.t);
    const int end = std::min({s.tile_end(i, tile_s, planes.tiles.s, run.count),
                              t.tile_end(i, tile_t, planes.tiles.t, run.count), int{run.count}});
    const std::uint32_t tile =
        static_cast<std::uint32_t>(tile_t) * planes.tiles.s + static_cast<std::uint32_t>(tile_s);
    io_spans.push_back({span.item + tile,
                        {static_cast<std::uint16_t>(run.x + i), run.y, static_cast<std::uint16_t>(end - i)}});
    i = end;
  }
}

std::span<const ItemSpan> split_at_tiles(std::span<const ItemSpan> spans,
                                         std::span<const TilePlanes* const> tile_planes, bool perspective,
                                         base::Arena& arena) {
  base::ArenaVector<ItemSpan> split(arena, spans.size() + 64);
  for (const ItemSpan& span : spans) {
    const TilePlanes* const planes = tile_planes[span.item];
    if (planes != nullptr)
      split_at_tiles(span, *planes, perspective, split);
    else
      split.push_back(span);
  }
  return split.view();
}

PixelSum sum_pixels(std::span<const SpanRun> runs) {
  std::uint64_t pixels = 0, twice_x = 0, y = 0;
  for (const SpanRun& run : runs) {
    const std::uint64_t count = run.count;
    pixels += count;
    twice_x += count * (2u * run.x + count - 1);
    y += count * run.y;
  }
  return {pixels, twice_x / 2, y};
}

// Counting sort by item; within one, spans keep their order: by row, then from the left.
Band group_by_item(std::span<const ItemSpan> spans, std::uint32_t item_count, int first_row, int row_count,
                   base::Arena& arena) {
  std::span<std::uint32_t> count = arena.allocate_filled<std::uint32_t>(item_count, 0);
  for (const ItemSpan& span : spans) ++count[span.item];
  const std::size_t most_used = std::min(spans.size(), count.size());
  std::span<std::uint32_t> items = arena.allocate<std::uint32_t>(most_used);
  std::span<std::uint32_t> run_begin = arena.allocate<std::uint32_t>(most_used + 1);
  std::uint32_t position = 0, runs_before = 0;
  for (std::uint32_t item = 0; item < item_count; ++item) {
    if (count[item] == 0) continue;
    items[position] = item;
    run_begin[position++] = runs_before;
    runs_before += std::exchange(count[item], runs_before);  // from now on: where its next run goes
  }
  run_begin[position] = runs_before;
  const std::size_t used = position;
  std::span<SpanRun> runs = arena.allocate<SpanRun>(spans.size());
  for (const ItemSpan& span : spans) runs[count[span.item]++] = span.run;
  std::span<PixelSum> sums = arena.allocate<PixelSum>(used);
  for (std::size_t i = 0; i < used; ++i)
    sums[i] = sum_pixels(runs.subspan(run_begin[i], run_begin[i + 1] - run_begin[i]));
  return {first_row, row_count, runs, items.first(used), run_begin.first(used + 1), sums};
}

}  // namespace

SpanTable scan_edges(const EdgeTable& table, const Scene& scene, const ViewFrame& view, int band_rows,
                     base::Jobs& jobs, base::Arena& arena, std::vector<base::Arena>& io_band_arenas) {
  const std::size_t band_count = static_cast<std::size_t>((view.height + band_rows - 1) / band_rows);
  if (io_band_arenas.size() < band_count) io_band_arenas.resize(band_count);
  const std::span<const TilePlanes*> tile_planes = make_tile_planes(table, scene, view, arena);
  const SurfaceRanks ranks = rank_surfaces(table.surfaces.first(table.first_late()), arena);
  std::span<Band> bands = arena.allocate<Band>(band_count);
  jobs.parallel_for(band_count, [&](std::size_t i) {
    base::Arena& band_arena = io_band_arenas[i];
    band_arena.reset();
    const int first_row = static_cast<int>(i) * band_rows;
    const int row_count = std::min(band_rows, view.height - first_row);
    std::span<const ItemSpan> spans = scan_band(table, ranks, first_row, row_count, view.width, band_arena);
    if (table.deferred_count() > 0)
      spans = with_deferred_faces(spans, table, first_row, row_count, view.width, band_arena);
    if (!tile_planes.empty()) spans = split_at_tiles(spans, tile_planes, view.perspective, band_arena);
    bands[i] = group_by_item(spans, table.item_count, first_row, row_count, band_arena);
  });
  return {bands};
}

}  // namespace temblor::render
