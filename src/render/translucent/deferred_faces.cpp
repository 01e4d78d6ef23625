#include "render/translucent/deferred_faces.h"

#include <algorithm>

#include "render/translucent/merge_kernels.h"

namespace temblor::render {

namespace {

// What lies as far as what is there already is in front of it (a fence on a wall), rounding aside: depths
// agree to this part of themselves.
constexpr float kTouching = 1e-5f;

constexpr std::uint32_t kNoRuns = 0xffffffff;

std::uint32_t item_count(const ScreenSurface& surface) {
  return std::uint32_t{surface.tiles.s} * surface.tiles.t;
}

// Where late surfaces are seen, by late item.
std::span<const PixelSum> sum_deferred_items(const SpanTable& spans, const SurfaceDraws& items,
                                             base::Arena& arena) {
  const std::span<PixelSum> sums = arena.allocate_filled(items.items.size() - items.first_late, PixelSum{});
  for (const Band& band : spans.bands) {
    const auto late = std::lower_bound(band.items.begin(), band.items.end(), items.first_late);
    for (auto i = static_cast<std::size_t>(late - band.items.begin()); i < band.items.size(); ++i) {
      PixelSum& sum = sums[band.items[i] - items.first_late];
      sum.pixels += band.sums[i].pixels;
      sum.x += band.sums[i].x;
      sum.y += band.sums[i].y;
    }
  }
  return sums;
}

bool is_farther(const DeferredFace& a, const DeferredFace& b) {
  if (a.key != b.key) return a.key > b.key;
  if (a.depth != b.depth) return a.depth < b.depth;
  return a.surface < b.surface;
}

// The runs of each late item in one band.
class LateRuns {
 public:
  LateRuns(const Band& band, const SurfaceDraws& items, base::Arena& arena)
      : band_(band),
        first_deferred_(items.first_late),
        position_(arena.allocate_filled<std::uint32_t>(items.items.size() - items.first_late, kNoRuns)) {
    for (std::size_t i = band.items.size(); i > 0 && band.items[i - 1] >= first_deferred_; --i)
      position_[band.items[i - 1] - first_deferred_] = static_cast<std::uint32_t>(i - 1);
  }
  std::span<const SpanRun> of(std::uint32_t item) const {
    const std::uint32_t position = position_[item - first_deferred_];
    return position == kNoRuns ? std::span<const SpanRun>() : band_.runs_at(position);
  }

 private:
  const Band& band_;
  const std::uint32_t first_deferred_;
  std::span<std::uint32_t> position_;
};

// Draws runs of late faces. Each is drawn into a row of its own, by the kernels that draw everything else,
// and goes from there into the picture.
class BandDrawing {
 public:
  BandDrawing(const LateTarget& target, FrameBuffer& io_frame, base::Arena& arena)
      : target_(target), frame_(io_frame) {
    const auto width = static_cast<std::size_t>(io_frame.width());
    constexpr std::size_t kMaxTexelBytes = 4;
    texels_ = arena.allocate<std::byte>(width * kMaxTexelBytes).data();
    depth_ = arena.allocate<float>(width).data();
  }

  void draw(const DeferredFace& face, std::uint32_t item, const SpanRun& run) {
    // Rows no width apart: each falls on the same one.
    draw_runs(target_.sources, item, {&run, 1}, {texels_, depth_, 0});
    const bool indexed = frame_.format() == PixelFormat::kIndexed;
    const std::size_t texel_bytes = indexed ? 1 : 4;
    std::byte* const texels = texels_ + run.x * texel_bytes;
    const bool blends = face.opacity.opacity < 1;
    if (blends && target_.fog.is_on()) target_.fog.apply(texels, {depth_ + run.x, run.count});
    const std::size_t pixel = std::size_t{run.y} * static_cast<std::size_t>(frame_.width()) + run.x;
    MergeRow row{};
    row.texels = texels;
    row.depth = depth_ + run.x;
    row.pixels = indexed ? static_cast<void*>(frame_.indexed().data() + pixel) : frame_.rgb().data() + pixel;
    row.z = frame_.depth().data() + pixel;
    row.count = run.count;
    row.nearer = target_.view.perspective ? 1 + kTouching : 1 - kTouching;
    row.has_holes = face.opacity.has_holes;
    if (blends) {
      if (indexed) row.table = target_.tables.blends.table_for(face.opacity.opacity);
      row.opacity_256 = opacity_256(face.opacity.opacity);
    }
    merge(row, blends, indexed);
  }

 private:
  void merge(const MergeRow& row, bool blends, bool indexed) const {
    const bool vector = target_.sources.vector_kernels;
    if (blends && indexed)
      vector ? merge_blend_u8_simd(row) : merge_blend_u8_scalar(row);
    else if (blends)
      vector ? merge_blend_u32_simd(row) : merge_blend_u32_scalar(row);
    else if (indexed)
      vector ? merge_opaque_u8_simd(row) : merge_opaque_u8_scalar(row);
    else
      vector ? merge_opaque_u32_simd(row) : merge_opaque_u32_scalar(row);
  }

  const LateTarget& target_;
  FrameBuffer& frame_;
  std::byte* texels_;
  float* depth_;
};

}  // namespace

DeferredFaces sort_deferred_faces(const Scene& scene, const VisibleFaces& visible, const EdgeTable& edges,
                                  const SpanTable& spans, const SurfaceDraws& items, base::Arena& arena) {
  const std::size_t count = edges.deferred_count();
  if (count == 0) return {};
  const std::span<const PixelSum> sums = sum_deferred_items(spans, items, arena);
  base::ArenaVector<DeferredFace> opaque(arena, count), translucent(arena, count);
  for (std::size_t number = edges.first_late(); number < edges.surfaces.size(); ++number) {
    const ScreenSurface& surface = edges.surfaces[number];
    PixelSum seen;
    const SurfaceDraw* drawn = nullptr;
    for (std::uint32_t i = surface.first_item; i < surface.first_item + item_count(surface); ++i) {
      const PixelSum& sum = sums[i - items.first_late];
      if (sum.pixels == 0) continue;
      drawn = &items.items[i];
      seen.pixels += sum.pixels;
      seen.x += sum.x;
      seen.y += sum.y;
    }
    if (drawn == nullptr) continue;
    const world::TextureIndex texture = scene.level->face(surface.face).texture;
    const FaceOpacity opacity = surface.instance == 0 ? visible.opacities[base::to_size(texture)]
                                                      : opacity_on(visible.opacities, *scene.level, texture,
                                                                   scene.brush_models[surface.instance - 1]);
    const double pixels = static_cast<double>(seen.pixels);
    const double depth =
        drawn->depth.at(static_cast<double>(seen.x) / pixels, static_cast<double>(seen.y) / pixels);
    (opacity.opacity < 1 ? translucent : opaque)
        .push_back({base::to_index<SurfaceIndex>(number), opacity, surface.key, depth});
  }
  std::sort(translucent.begin(), translucent.end(), is_farther);
  return {opaque.view(), translucent.view()};
}

void draw_deferred_faces(std::span<const DeferredFace> faces, const LateTarget& target, const Band& band,
                         base::Arena& arena, FrameBuffer& io_frame) {
  if (faces.empty()) return;
  const LateRuns runs(band, target.sources.items, arena);
  BandDrawing drawing(target, io_frame, arena);
  for (const DeferredFace& face : faces) {
    const ScreenSurface& surface = target.edges.surfaces[base::to_size(face.surface)];
    for (std::uint32_t i = surface.first_item; i < surface.first_item + item_count(surface); ++i)
      for (const SpanRun& run : runs.of(i)) drawing.draw(face, i, run);
  }
}

void draw_deferred_faces(std::span<const DeferredFace> faces, const LateTarget& target, base::Jobs& jobs,
                         std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame) {
  if (faces.empty()) return;
  const std::span<const Band> bands = target.spans.bands;
  if (io_arenas.size() < bands.size()) io_arenas.resize(bands.size());
  jobs.parallel_for(bands.size(), [&](std::size_t number) {
    io_arenas[number].reset();
    draw_deferred_faces(faces, target, bands[number], io_arenas[number], io_frame);
  });
}

}  // namespace temblor::render
