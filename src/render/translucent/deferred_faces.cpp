#include "render/translucent/deferred_faces.h"

#include <algorithm>

#include "render/translucent/merge_added.h"
#include "render/translucent/merge_kernels.h"

namespace temblor::render {

namespace {

// A face at the same distance as what is there is drawn in front of it (a fence on a wall). Depths count as
// equal if they differ by less than this, relative to themselves.
constexpr float kTouching = 1e-5f;

constexpr std::uint32_t kNoSpans = 0xffffffff;

std::uint32_t draw_count(const ScreenSurface& surface) {
  return std::uint32_t{surface.tiles.s} * surface.tiles.t;
}

// The pixels of each deferred draw, summed over all bands. Deferred draws are the last ones of each band.
std::span<const PixelSum> sum_deferred_draws(const SpanTable& spans, const SurfaceDraws& draws,
                                             base::Arena& arena) {
  const std::span<PixelSum> sums = arena.allocate_filled(draws.all.size() - draws.first_deferred, PixelSum{});
  for (const Band& band : spans.bands) {
    const auto deferred = std::lower_bound(band.draws.begin(), band.draws.end(), draws.first_deferred);
    for (auto i = static_cast<std::size_t>(deferred - band.draws.begin()); i < band.draws.size(); ++i) {
      PixelSum& sum = sums[band.draws[i] - draws.first_deferred];
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

// The spans of each deferred draw in one band.
class DeferredSpans {
 public:
  DeferredSpans(const Band& band, const SurfaceDraws& draws, base::Arena& arena)
      : band_(band),
        first_deferred_(draws.first_deferred),
        position_(arena.allocate_filled<std::uint32_t>(draws.all.size() - draws.first_deferred, kNoSpans)) {
    for (std::size_t i = band.draws.size(); i > 0 && band.draws[i - 1] >= first_deferred_; --i)
      position_[band.draws[i - 1] - first_deferred_] = static_cast<std::uint32_t>(i - 1);
  }
  std::span<const Span> spans_for(std::uint32_t draw) const {
    const std::uint32_t position = position_[draw - first_deferred_];
    return position == kNoSpans ? std::span<const Span>() : band_.spans_at(position);
  }

 private:
  const Band& band_;
  const std::uint32_t first_deferred_;
  std::span<std::uint32_t> position_;
};

// Draws spans of deferred faces. Each span is drawn into a row buffer by the ordinary span kernels, and is
// merged into the picture from there:
//
//   span kernel -> texels_, depth_ -> color, fog -> merge kernel (depth test, holes, blending) -> frame
class BandDrawing {
 public:
  BandDrawing(const WorldPicture& world, FrameBuffer& io_frame, base::Arena& arena)
      : world_(world), frame_(io_frame) {
    const auto width = static_cast<std::size_t>(io_frame.width());
    constexpr std::size_t kMaxTexelBytes = 4;
    texels_ = arena.allocate<std::byte>(width * kMaxTexelBytes).data();
    depth_ = arena.allocate<float>(width).data();
  }

  void draw(const DeferredFace& face, std::uint32_t draw, const Span& span) {
    // A row distance of 0, so that every row is drawn into the same buffer.
    draw_spans(world_.sources, draw, {&span, 1}, {texels_, depth_, 0});
    const bool indexed = frame_.format() == PixelFormat::kIndexed;
    const std::size_t texel_bytes = indexed ? 1 : 4;
    std::byte* const texels = texels_ + span.x * texel_bytes;
    const FaceOpacity& opacity = face.opacity;
    const bool blends = opacity.is_translucent();
    if (opacity.color) fill_texels(*opacity.color, opacity.has_holes, span.count, texels);
    if (blends && !opacity.is_additive && world_.fog.is_on())
      world_.fog.apply(texels, {depth_ + span.x, span.count});
    const std::size_t pixel = std::size_t{span.y} * static_cast<std::size_t>(frame_.width()) + span.x;
    MergeRow row{};
    row.texels = texels;
    row.depth = depth_ + span.x;
    row.pixels = indexed ? static_cast<void*>(frame_.indexed().data() + pixel) : frame_.rgb().data() + pixel;
    row.z = frame_.depth().data() + pixel;
    row.count = span.count;
    row.nearer = world_.view.perspective ? 1 + kTouching : 1 - kTouching;
    row.has_holes = opacity.has_holes;
    row.opacity_256 = opacity_256(opacity.opacity);
    if (opacity.is_additive) {
      add(row, opacity.opacity, indexed);
      return;
    }
    if (blends && indexed) row.table = world_.colors.blends.table_for(opacity.opacity);
    merge(row, blends, indexed);
  }

 private:
  // Replaces texels by a color, except holes. No light changes it later, so full-bright entries may be used.
  void fill_texels(formats::Rgb color, bool has_holes, std::size_t count, std::byte* io_texels) const {
    const auto fill = [&](auto* texels, auto clear, auto filled) {
      for (std::size_t i = 0; i < count; ++i)
        if (!has_holes || texels[i] != clear) texels[i] = filled;
    };
    if (frame_.format() == PixelFormat::kIndexed)
      fill(reinterpret_cast<std::uint8_t*>(io_texels), std::uint8_t{255}, world_.colors.match(color, true));
    else
      fill(reinterpret_cast<std::uint32_t*>(io_texels), std::uint32_t{0}, to_rgb(color));
  }

  void add(MergeRow row, float opacity, bool indexed) const {
    const BlendTables& blends = world_.colors.blends;
    if (!indexed) {
      merge_added_u32(row);
      return;
    }
    row.table = blends.sums();
    merge_added_u8(row, opacity < 1 ? blends.table_for(opacity) + world_.colors.black : nullptr);
  }

  void merge(const MergeRow& row, bool blends, bool indexed) const {
    const bool simd = world_.sources.simd_kernels;
    if (blends && indexed)
      simd ? merge_blend_u8_simd(row) : merge_blend_u8_scalar(row);
    else if (blends)
      simd ? merge_blend_u32_simd(row) : merge_blend_u32_scalar(row);
    else if (indexed)
      simd ? merge_opaque_u8_simd(row) : merge_opaque_u8_scalar(row);
    else
      simd ? merge_opaque_u32_simd(row) : merge_opaque_u32_scalar(row);
  }

  const WorldPicture& world_;
  FrameBuffer& frame_;
  std::byte* texels_;
  float* depth_;
};

}  // namespace

DeferredFaces sort_deferred_faces(const FrameContext& context, const WorldPicture& world,
                                  const VisibleFaces& visible) {
  const Scene& scene = context.scene;
  const EdgeTable& edges = world.edges;
  const SurfaceDraws& draws = world.sources.draws;
  base::Arena& arena = context.arena();
  const std::size_t count = edges.deferred_count();
  if (count == 0) return {};
  const std::span<const PixelSum> sums = sum_deferred_draws(world.spans, draws, arena);
  base::ArenaVector<DeferredFace> opaque(arena, count), translucent(arena, count);
  for (std::size_t number = edges.first_deferred(); number < edges.surfaces.size(); ++number) {
    const ScreenSurface& surface = edges.surfaces[number];
    PixelSum seen;
    const SurfaceDraw* drawn = nullptr;
    for (std::uint32_t i = surface.first_draw; i < surface.first_draw + draw_count(surface); ++i) {
      const PixelSum& sum = sums[i - draws.first_deferred];
      if (sum.pixels == 0) continue;
      drawn = &draws.all[i];
      seen.pixels += sum.pixels;
      seen.x += sum.x;
      seen.y += sum.y;
    }
    if (drawn == nullptr) continue;
    const world::TextureIndex texture = scene.level->face(surface.face).texture;
    const FaceOpacity opacity = surface.instance == 0
                                    ? visible.opacities[base::to_size(texture)]
                                    : brush_face_opacity(visible.opacities, *scene.level, texture,
                                                         scene.brush_models[surface.instance - 1]);
    const double pixels = static_cast<double>(seen.pixels);
    const double depth =
        drawn->depth.at(static_cast<double>(seen.x) / pixels, static_cast<double>(seen.y) / pixels);
    (opacity.is_translucent() ? translucent : opaque)
        .push_back({base::to_index<SurfaceIndex>(number), opacity, surface.key, depth, seen.pixels});
  }
  std::sort(translucent.begin(), translucent.end(), is_farther);
  return {opaque.view(), translucent.view()};
}

void draw_deferred_faces(std::span<const DeferredFace> faces, const WorldPicture& world, const Band& band,
                         base::Arena& arena, FrameBuffer& io_frame) {
  if (faces.empty()) return;
  const DeferredSpans spans(band, world.sources.draws, arena);
  BandDrawing drawing(world, io_frame, arena);
  for (const DeferredFace& face : faces) {
    const ScreenSurface& surface = world.edges.surfaces[base::to_size(face.surface)];
    for (std::uint32_t i = surface.first_draw; i < surface.first_draw + draw_count(surface); ++i)
      for (const Span& span : spans.spans_for(i)) drawing.draw(face, i, span);
  }
}

}  // namespace temblor::render
