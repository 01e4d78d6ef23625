#include "render/screen/warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "base/check.h"

namespace temblor::render {

namespace {

// Stock Quake's values, for a picture 200 pixels high: an amplitude of 3 pixels and a period of 128 pixels,
// moving by 20 pixels per second.
constexpr double kPictureSize = 200, kAmplitude = 3, kTurn = 128, kPhase_s = 20;

// One axis: where pixels are taken from without displacement, and the largest displacement.
struct Axis {
  std::int32_t size, margin;

  Axis(int pixels, double amplitude)
      : size(pixels), margin(std::min((pixels - 1) / 2, static_cast<int>(std::ceil(amplitude)))) {}
  // Scales the picture so that `margin` pixels are cut off at either end.
  std::int32_t place(std::int32_t i) const {
    if (size == 1) return 0;
    return margin + (2 * i * (size - 1 - 2 * margin) + size - 1) / (2 * (size - 1));
  }
  std::int32_t bounded(double sway) const {
    return std::clamp(static_cast<std::int32_t>(std::lround(sway)), -margin, margin);
  }
};

// The size of a tile in pixels. At 1080 rows, a pixel comes from one of 33 rows around its own. Whole rows
// would need 250 KB in an unpredictable order; a tile needs 50 KB, most of which fits the first-level cache.
constexpr std::size_t kTileColumns = 128, kTileRows = 64;

}  // namespace

// A pixel's horizontal displacement depends only on its row and the vertical one only on its column, so the
// source of a pixel is the sum of a number per row and a number per column.
void find_warp_sources(int width, int height, double time_s, WarpSources& out_sources) {
  const double pixels = std::min(width, height) / kPictureSize;
  const Axis across(width, kAmplitude * pixels), down(height, kAmplitude * pixels);
  const double phase = std::fmod(time_s * kPhase_s, kTurn) / kTurn;
  const auto sway = [&](int along) {
    return kAmplitude * pixels * std::sin(2 * std::numbers::pi * (along / (kTurn * pixels) + phase));
  };
  out_sources.column.resize(static_cast<std::size_t>(width));
  out_sources.row.resize(static_cast<std::size_t>(height));
  for (int x = 0; x < width; ++x)
    out_sources.column[static_cast<std::size_t>(x)] = across.place(x) + down.bounded(sway(x)) * width;
  for (int y = 0; y < height; ++y)
    out_sources.row[static_cast<std::size_t>(y)] = down.place(y) * width + across.bounded(sway(y));
}

void Warp::apply(double time_s, const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame) {
  find_warp_sources(io_frame.width(), io_frame.height(), time_s, sources_);
  if (io_frame.format() == PixelFormat::kIndexed)
    move_pixels<std::uint8_t>(io_frame.indexed(), indexed_spare_, tint, jobs, io_frame);
  else
    move_pixels<std::uint32_t>(io_frame.rgb(), rgb_spare_, tint, jobs, io_frame);
}

void Warp::prepare(const FrameBuffer& frame) {
  sources_.column.reserve(static_cast<std::size_t>(frame.width()));
  sources_.row.reserve(static_cast<std::size_t>(frame.height()));
  if (frame.format() == PixelFormat::kIndexed)
    reserve(frame.pixel_count(), indexed_spare_);
  else
    reserve(frame.pixel_count(), rgb_spare_);
}

template <typename Pixel>
void Warp::reserve(std::size_t count, Spare<Pixel>& io_spare) {
  if (io_spare.count == count) return;
  io_spare = {base::allocate_large<Pixel>(count), count};
  CHECK(io_spare.pixels != nullptr, "no memory for {} pixels", count);
  std::fill_n(io_spare.pixels.get(), count, Pixel{});
}

// Hot loop.
template <typename Pixel>
void Warp::move_pixels(std::span<const Pixel> pixels, Spare<Pixel>& io_spare, const PictureTint& tint,
                       base::Jobs& jobs, FrameBuffer& io_frame) {
  const std::size_t width = sources_.column.size(), height = sources_.row.size();
  reserve(pixels.size(), io_spare);
  const std::size_t across = (width + kTileColumns - 1) / kTileColumns;
  const std::size_t down = (height + kTileRows - 1) / kTileRows;
  jobs.parallel_for(across * down, [&](std::size_t tile) {
    const std::size_t first_x = tile % across * kTileColumns, end_x = std::min(first_x + kTileColumns, width);
    const std::size_t first_y = tile / across * kTileRows, end_y = std::min(first_y + kTileRows, height);
    for (std::size_t y = first_y; y < end_y; ++y) {
      const Pixel* const from = pixels.data() + sources_.row[y];
      Pixel* const row = &io_spare.pixels[y * width];
      for (std::size_t x = first_x; x < end_x; ++x) row[x] = from[sources_.column[x]];
      if constexpr (std::is_same_v<Pixel, std::uint32_t>)
        if (tint.changes_pixels()) tint.apply(std::span(row + first_x, end_x - first_x));
    }
  });
  io_frame.exchange(io_spare.pixels);
}

}  // namespace temblor::render
