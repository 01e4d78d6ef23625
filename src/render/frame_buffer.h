// The picture that a frame is drawn into: pixels in one of two formats, and a depth value for each pixel.
//
// Stock Quake draws 8-bit palette indices and keeps 16-bit 1/z. Here depth is a float, and a 32-bit format
// allows colored light, smooth translucency, and fog.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/large_memory.h"
#include "formats/images/palette.h"
#include "render/tint.h"

namespace temblor::render {

// kIndexed: one byte per pixel, an index into the palette. kRgb: four bytes per pixel, 0xffRRGGBB.
enum class PixelFormat { kIndexed, kRgb };

// Packs a color as 0xffRRGGBB.
constexpr std::uint32_t to_rgb(formats::Rgb color) {
  return 0xff000000u | static_cast<std::uint32_t>(color.r) << 16 | static_cast<std::uint32_t>(color.g) << 8 |
         color.b;
}

// Owns pixels and depth. Both are uninitialized until a frame is drawn; a frame writes every pixel, so they
// are never cleared. Row y begins at element y * width(): there are no gaps between rows.
class FrameBuffer {
 public:
  FrameBuffer() = default;  // 0 x 0 pixels
  // CHECKs that both sizes are at least 1, and that there is enough memory.
  FrameBuffer(int width, int height, PixelFormat format);

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat format() const { return format_; }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  // The pixels. Only the span of the frame's own format has elements; the other one is empty.
  std::span<std::uint8_t> indexed() {
    return {indexed_.get(), format_ == PixelFormat::kIndexed ? pixel_count() : 0};
  }
  std::span<std::uint32_t> rgb() { return {rgb_.get(), format_ == PixelFormat::kRgb ? pixel_count() : 0}; }
  std::span<const std::uint8_t> indexed() const { return const_cast<FrameBuffer*>(this)->indexed(); }
  std::span<const std::uint32_t> rgb() const { return const_cast<FrameBuffer*>(this)->rgb(); }
  // Swaps the pixels' memory with the caller's, which must have room for pixel_count() pixels: a stage that
  // moves pixels (the underwater warp) writes to a second buffer and then exchanges the two. Invalidates the
  // spans above.
  void exchange(base::LargeMemory<std::uint8_t>& io_indexed) { indexed_.swap(io_indexed); }
  void exchange(base::LargeMemory<std::uint32_t>& io_rgb) { rgb_.swap(io_rgb); }
  // One value per pixel; larger is nearer. Perspective: 1/z, with z in units along the view. Orthographic:
  // -z. The background has the lowest float.
  std::span<float> depth() { return {depth_.get(), pixel_count()}; }
  std::span<const float> depth() const { return const_cast<FrameBuffer*>(this)->depth(); }

  // Indexed frames are tinted through their palette when they are shown (present.h). Rgb frames: no tint.
  void set_palette_tint(const Tint& tint) { palette_tint_ = tint; }
  const Tint& palette_tint() const { return palette_tint_; }

 private:
  int width_ = 0, height_ = 0;
  PixelFormat format_ = PixelFormat::kIndexed;
  base::LargeMemory<std::uint8_t> indexed_;
  base::LargeMemory<std::uint32_t> rgb_;
  base::LargeMemory<float> depth_;
  Tint palette_tint_;
};

// Rows [first, end) of a frame.
struct RowRange {
  int first = 0, end = 0;
};

}  // namespace temblor::render
