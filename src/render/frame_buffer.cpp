#include "render/frame_buffer.h"

#include "base/check.h"

namespace temblor::render {

namespace {

// LargeMemory takes large pages, if the system has them, and does not initialize.
template <typename T>
base::LargeMemory<T> allocate_pixels(std::size_t count) {
  base::LargeMemory<T> pixels = base::allocate_large<T>(count);
  CHECK(pixels != nullptr, "no memory for a picture of {} bytes", count * sizeof(T));
  return pixels;
}

}  // namespace

FrameBuffer::FrameBuffer(int width, int height, PixelFormat format)
    : width_(width), height_(height), format_(format) {
  CHECK(width >= 1 && height >= 1, "{}x{}", width, height);
  if (format == PixelFormat::kIndexed)
    indexed_ = allocate_pixels<std::uint8_t>(pixel_count());
  else
    rgb_ = allocate_pixels<std::uint32_t>(pixel_count());
  depth_ = allocate_pixels<float>(pixel_count());
}

}  // namespace temblor::render
