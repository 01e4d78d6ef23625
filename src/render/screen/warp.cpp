#include "render/screen/warp.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

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

// Rows and columns that are moved together: what they come from lies close together too, and stays in the
// nearest caches.
constexpr std::size_t kRowsAJob = 64, kColumnsAStrip = 128;

}  // namespace

// How far a pixel sways along its row depends on its row alone, and down its column on the column alone: a
// number for each row and one for each column add up to where a pixel comes from.
void Warp::apply(double time_s, base::Jobs& jobs, FrameBuffer& io_frame) {
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
    move_pixels(io_frame.indexed(), indexed_copy_, jobs);
  else
    move_pixels(io_frame.rgb(), rgb_copy_, jobs);
}

template <typename Pixel>
void Warp::move_pixels(std::span<Pixel> io_pixels, std::vector<Pixel>& io_copy, base::Jobs& jobs) const {
  const std::size_t width = column_.size(), height = row_.size();
  io_copy.resize(io_pixels.size());
  const std::size_t job_count = (height + kRowsAJob - 1) / kRowsAJob;
  jobs.parallel_for(job_count, [&](std::size_t job) {
    const std::size_t first = job * kRowsAJob * width, last = std::min((job + 1) * kRowsAJob, height) * width;
    std::memcpy(&io_copy[first], &io_pixels[first], (last - first) * sizeof(Pixel));
  });
  jobs.parallel_for(job_count, [&](std::size_t job) {
    const std::size_t end = std::min((job + 1) * kRowsAJob, height);
    for (std::size_t left = 0; left < width; left += kColumnsAStrip)
      for (std::size_t y = job * kRowsAJob; y < end; ++y) {
        Pixel* const out = &io_pixels[y * width];
        const Pixel* const from = io_copy.data();
        const std::int32_t row = row_[y];
        const std::int32_t* const column = column_.data();
        const std::size_t right = std::min(left + kColumnsAStrip, width);
        for (std::size_t x = left; x < right; ++x) out[x] = from[row + column[x]];
      }
  });
}

}  // namespace temblor::render
