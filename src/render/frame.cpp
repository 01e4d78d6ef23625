#include "render/frame.h"

#include <sys/mman.h>

#include <cstdlib>

#include "base/check.h"

namespace temblor::render {

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

// A picture is walked row by row for every span: large pages spare most of its address translations.
void* allocate_pixels(std::size_t bytes) {
  const std::size_t rounded = (bytes + kHugePage - 1) / kHugePage * kHugePage;
  const bool large = bytes >= kHugePage;
  void* memory = std::aligned_alloc(large ? kHugePage : 64, large ? rounded : (bytes + 63) / 64 * 64);
  CHECK(memory != nullptr, "no memory for a picture of {} bytes", bytes);
  if (large) madvise(memory, rounded, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

void FrameBuffer::Free::operator()(void* memory) const {
  std::free(memory);
}

FrameBuffer::FrameBuffer(int width, int height, PixelFormat format)
    : width_(width), height_(height), format_(format) {
  CHECK(width >= 1 && height >= 1, "{}x{}", width, height);
  if (format == PixelFormat::kIndexed)
    indexed_.reset(static_cast<std::uint8_t*>(allocate_pixels(pixel_count())));
  else
    rgb_.reset(static_cast<std::uint32_t*>(allocate_pixels(pixel_count() * sizeof(std::uint32_t))));
  depth_.reset(static_cast<float*>(allocate_pixels(pixel_count() * sizeof(float))));
}

}  // namespace temblor::render
