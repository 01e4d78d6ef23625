#include "render_gl/world/face_blend.h"

#include <algorithm>

namespace temblor::render_gl {

namespace {

// First pixels, and the ends.
struct Extent {
  int left, top, right, bottom;
};

void include_spans(std::span<const render::Span> spans, Extent& io_extent) {
  for (const render::Span& span : spans) {
    io_extent.left = std::min<int>(io_extent.left, span.x);
    io_extent.right = std::max<int>(io_extent.right, span.x + span.count);
    io_extent.top = std::min<int>(io_extent.top, span.y);
    io_extent.bottom = std::max<int>(io_extent.bottom, span.y + 1);
  }
}

}  // namespace

IndexBlend choose_blend(const render::ColorTables& colors, const render::FaceOpacity& opacity) {
  if (!opacity.is_additive) return {.table = colors.blends.table_for(opacity.opacity)};
  return {.table = colors.blends.sums(),
          .dims = opacity.opacity < 1 ? colors.blends.table_for(opacity.opacity) : nullptr,
          .dim_column = colors.black};
}

std::optional<PixelRect> find_face_rect(const FrameInput& input, const QueuedFace& face) {
  constexpr int kRounding = 2;
  const int width = input.record.view.width, height = input.record.view.height;
  Extent extent{width, height, 0, 0};
  for (std::uint32_t number = 0; number < face.fragments; ++number) {
    const std::uint32_t first = input.record.edges.surfaces[face.surface + number].first_draw;
    for (const render::Band& band : input.record.spans.bands)
      for (auto draw = std::ranges::lower_bound(band.draws, first);
           draw != band.draws.end() && *draw < first + face.tiles; ++draw)
        include_spans(band.spans_at(static_cast<std::size_t>(draw - band.draws.begin())), extent);
  }
  if (extent.left >= extent.right) return std::nullopt;
  const int left = std::max(extent.left - kRounding, 0), top = std::max(extent.top - kRounding, 0);
  return PixelRect{left, top, std::min(extent.right + kRounding, width) - left,
                   std::min(extent.bottom + kRounding, height) - top};
}

}  // namespace temblor::render_gl
