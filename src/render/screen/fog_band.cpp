#include "render/screen/fog_band.h"

#include <algorithm>
#include <tuple>

namespace temblor::render {

namespace {

// A span of sky and the plane of its depth.
struct SkySpan {
  Span span;
  const ScreenPlane* depth;
};

// From top to bottom and from left to right. Deferred faces are never sky.
std::span<const SkySpan> find_sky(const Band& band, const SurfaceDraws& draws, base::Arena& arena) {
  base::ArenaVector<SkySpan> found(arena, 64);
  for (std::size_t position = 0; position < band.draws.size(); ++position) {
    if (band.draws[position] >= draws.first_deferred) break;
    const SurfaceDraw& draw = draws.all[band.draws[position]];
    if (draw.kind != SurfaceKind::kSky) continue;
    for (const Span& span : band.spans_at(position)) found.push_back({span, &draw.depth});
  }
  std::sort(found.begin(), found.end(), [](const SkySpan& a, const SkySpan& b) {
    return std::tie(a.span.y, a.span.x) < std::tie(b.span.y, b.span.x);
  });
  return found.view();
}

// Applies fog to parts of rows of the frame.
class FoggedRows {
 public:
  FoggedRows(const FrameFog& fog, FrameBuffer& io_frame) : fog_(fog), frame_(io_frame) {}

  void apply(int row, int first, int end) {
    if (first < end) fog_.apply(pixels(row, first), depths(row, first, end));
  }
  // Computes the depth in the order and precision of the span kernels, so that comparisons can be exact.
  void apply_sky(const SkySpan& sky) {
    const ScreenPlane& plane = *sky.depth;
    const int x = sky.span.x, y = sky.span.y;
    fog_.apply_sky(pixels(y, x), depths(y, x, x + sky.span.count),
                   static_cast<float>(plane.at_origin + plane.dx * x + plane.dy * y),
                   static_cast<float>(plane.dx));
  }

 private:
  std::size_t index(int row, int x) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.width()) +
           static_cast<std::size_t>(x);
  }
  void* pixels(int row, int x) {
    return frame_.format() == PixelFormat::kIndexed
               ? static_cast<void*>(frame_.indexed().data() + index(row, x))
               : frame_.rgb().data() + index(row, x);
  }
  std::span<const float> depths(int row, int first, int end) const {
    return std::as_const(frame_).depth().subspan(index(row, first), static_cast<std::size_t>(end - first));
  }

  const FrameFog& fog_;
  FrameBuffer& frame_;
};

}  // namespace

// Fogs each row in parts: the spans of sky, and what lies between them.
void fog_band(const FrameFog& fog, const Band& band, const SurfaceDraws& draws, base::Arena& arena,
              FrameBuffer& io_frame) {
  if (!fog.is_on()) return;
  FoggedRows rows(fog, io_frame);
  const std::span<const SkySpan> sky = find_sky(band, draws, arena);
  auto next = sky.begin();
  for (int row = band.first_row; row < band.first_row + band.row_count; ++row) {
    int x = 0;
    for (; next != sky.end() && next->span.y == row; ++next) {
      rows.apply(row, x, next->span.x);
      rows.apply_sky(*next);
      x = next->span.x + next->span.count;
    }
    rows.apply(row, x, io_frame.width());
  }
}

}  // namespace temblor::render
