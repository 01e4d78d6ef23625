// Feeds arbitrary bytes to the JPEG reader. It must return an error, or an opaque image of the size that it
// says.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/images/image.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_jpeg(const std::uint8_t* data, std::size_t size) {
  const auto image = temblor::formats::read_jpeg(std::as_bytes(std::span(data, size)));
  if (!image.ok()) return 0;
  CHECK(image->width > 0 && image->height > 0);
  CHECK(image->pixels.size() == std::size_t{image->width} * image->height);
  CHECK(image->pixels.size() <= size * 4096);
  CHECK(std::ranges::all_of(image->pixels, [](std::uint32_t pixel) { return pixel >> 24 == 255; }));
  return 0;
}
