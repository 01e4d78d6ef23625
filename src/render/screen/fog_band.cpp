#include "render/screen/fog_band.h"

#include <algorithm>
#include <tuple>

namespace temblor::render {

namespace {

struct SkyRun {
  SpanRun run;
  const ScreenPlane* depth;
};

// From top to bottom and left to right.
std::span<const SkyRun> find_sky(const Band& band, const SurfaceDraws& items, base::Arena& arena) {
  base::ArenaVector<SkyRun> found(arena, 64);
  for (std::size_t position = 0; position < band.items.size(); ++position) {
    if (band.items[position] >= items.first_late) break;
    const SurfaceDraw& item = items.items[band.items[position]];
    if (item.kind != ItemKind::kSky) continue;
    for (const SpanRun& run : band.runs_at(position)) found.push_back({run, &item.depth});
  }
  std::sort(found.begin(), found.end(), [](const SkyRun& a, const SkyRun& b) {
    return std::tie(a.run.y, a.run.x) < std::tie(b.run.y, b.run.x);
  });
  return found.view();
}

class FoggedRows {
 public:
  FoggedRows(const FrameFog& fog, FrameBuffer& io_frame) : fog_(fog), frame_(io_frame) {}

  void apply(int row, int first, int end) {
    if (first < end) fog_.apply(pixels(row, first), depths(row, first, end));
  }
  // In the order and precision of the span kernels.
  void apply_sky(const SkyRun& sky) {
    const ScreenPlane& plane = *sky.depth;
    const int x = sky.run.x, y = sky.run.y;
    fog_.apply_sky(pixels(y, x), depths(y, x, x + sky.run.count),
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

// Rows are fogged whole, but for the runs of sky in them.
void fog_band(const FrameFog& fog, const Band& band, const SurfaceDraws& items, base::Arena& arena,
              FrameBuffer& io_frame) {
  if (!fog.is_on()) return;
  FoggedRows rows(fog, io_frame);
  const std::span<const SkyRun> sky = find_sky(band, items, arena);
  auto next = sky.begin();
  for (int row = band.first_row; row < band.first_row + band.row_count; ++row) {
    int x = 0;
    for (; next != sky.end() && next->run.y == row; ++next) {
      rows.apply(row, x, next->run.x);
      rows.apply_sky(*next);
      x = next->run.x + next->run.count;
    }
    rows.apply(row, x, io_frame.width());
  }
}

}  // namespace temblor::render
