#include "render/frame/resolve_settings.h"

#include <algorithm>

namespace temblor::render {

namespace {

// The pixels and depth of a band should fit a core's second-level cache, and every thread should get several
// bands, since bands take unequal time.
int choose_band_rows(const Settings& settings, const FrameBuffer& frame) {
  const int height = frame.height();
  if (settings.band_rows > 0) return std::min(settings.band_rows, height);
  constexpr int kBandBytes = 768 << 10;
  constexpr int kBandsPerThread = 6;
  constexpr int kMinRows = 8, kMaxRows = 256;
  // One or four bytes per pixel, and four for depth.
  const int row_bytes = frame.width() * (frame.format() == PixelFormat::kIndexed ? 5 : 8);
  int rows = std::clamp(kBandBytes / row_bytes, kMinRows, kMaxRows);
  if (settings.threads > 1)
    rows = std::min(rows, std::max(kMinRows, height / (settings.threads * kBandsPerThread)));
  return std::min(rows, height);
}

}  // namespace

Settings resolve_settings(const Settings& asked, const Scene& scene, const FrameBuffer& frame) {
  constexpr int kMaxMip = 3;
  Settings settings = asked;
  settings.threads = std::max(1, asked.threads);
  settings.force_mip = std::min(asked.force_mip, kMaxMip);
  settings.band_rows = choose_band_rows(settings, frame);
  settings.fill_depth |= asked.show == Show::kDepth || scene.fog.density > 0;
  return settings;
}

}  // namespace temblor::render
