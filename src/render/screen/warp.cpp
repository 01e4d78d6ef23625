#include "render/screen/warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"

namespace temblor::render {

namespace {

// The original's: of a picture 200 pixels high, 3 pixels either way, a turn every 128, 20 of which pass each
// second.
constexpr double kPictureSize = 200, kAmplitude = 3, kTurn = 128, kPhase_s = 20;

// Along one axis: where pixels are taken from while nothing sways, and by how many they do at most.
struct Axis {
  std::int32_t size, margin;

  Axis(int pixels, double amplitude)
      : size(pixels), margin(std::min((pixels - 1) / 2, static_cast<int>(std::ceil(amplitude)))) {}
  // `margin` pixels are cut off at either end.
  std::int32_t place(std::int32_t i) const {
    if (size == 1) return 0;
    return margin + (2 * i * (size - 1 - 2 * margin) + size - 1) / (2 * (size - 1));
  }
  std::int32_t bounded(double sway) const {
    return std::clamp(static_cast<std::int32_t>(std::lround(sway)), -margin, margin);
  }
};

constexpr std::size_t kRowsAJob = 16;

}  // namespace

// How far a pixel sways along its row depends on its row alone, and down its column on the column alone: a
// number for each row and one for each column add up to where a pixel comes from.
void Warp::apply(double time_s, const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame) {
  const int width = io_frame.width(), height = io_frame.height();
  const double pixels = std::min(width, height) / kPictureSize;
  const Axis across(width, kAmplitude * pixels), down(height, kAmplitude * pixels);
  const double phase = std::fmod(time_s * kPhase_s, kTurn) / kTurn;
  const auto sway = [&](int along) {
    return kAmplitude * pixels * std::sin(2 * std::numbers::pi * (along / (kTurn * pixels) + phase));
  };
  column_.resize(static_cast<std::size_t>(width));
  row_.resize(static_cast<std::size_t>(height));
  for (int x = 0; x < width; ++x)
    column_[static_cast<std::size_t>(x)] = across.place(x) + down.bounded(sway(x)) * width;
  for (int y = 0; y < height; ++y)
    row_[static_cast<std::size_t>(y)] = down.place(y) * width + across.bounded(sway(y));
  if (io_frame.format() == PixelFormat::kIndexed)
    move_pixels<std::uint8_t>(io_frame.indexed(), indexed_spare_, tint, jobs, io_frame);
  else
    move_pixels<std::uint32_t>(io_frame.rgb(), rgb_spare_, tint, jobs, io_frame);
}

void Warp::prepare(const FrameBuffer& frame) {
  column_.reserve(static_cast<std::size_t>(frame.width()));
  row_.reserve(static_cast<std::size_t>(frame.height()));
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
  const std::size_t width = column_.size(), height = row_.size();
  reserve(pixels.size(), io_spare);
  jobs.parallel_for((height + kRowsAJob - 1) / kRowsAJob, [&](std::size_t job) {
    for (std::size_t y = job * kRowsAJob; y < std::min((job + 1) * kRowsAJob, height); ++y) {
      const Pixel* const from = pixels.data() + row_[y];
      Pixel* const row = &io_spare.pixels[y * width];
      for (std::size_t x = 0; x < width; ++x) row[x] = from[column_[x]];
      if (tint.changes_pixels()) tint.apply(std::span(row, width));
    }
  });
  io_frame.exchange(io_spare.pixels);
}

}  // namespace temblor::render
