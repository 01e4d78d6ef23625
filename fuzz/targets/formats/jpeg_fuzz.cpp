// Feeds arbitrary bytes to the JPEG reader. It must return an error, or an opaque image of the size that it
// says. Frame headers are changed to at most 255 x 255 pixels: larger pictures would take all of the fuzzer's
// time.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/images/image.h"
#include "fuzz/targets.h"

namespace {

// FF C0 to FF CF begins a frame header: length u16, precision u8, height u16, width u16. The high bytes of
// the sizes become 0, also where other data looks like a frame header.
temblor::base::ByteVector with_small_sizes(temblor::base::Bytes bytes) {
  temblor::base::ByteVector small(bytes.begin(), bytes.end());
  for (std::size_t i = 0; i + 7 < small.size(); ++i)
    if (small[i] == std::byte{0xff} && (small[i + 1] & std::byte{0xf0}) == std::byte{0xc0})
      small[i + 5] = small[i + 7] = std::byte{0};
  return small;
}

}  // namespace

int temblor::fuzz::fuzz_jpeg(const std::uint8_t* data, std::size_t size) {
  const auto image = temblor::formats::read_jpeg(with_small_sizes(std::as_bytes(std::span(data, size))));
  if (!image.ok()) return 0;
  CHECK(image->width > 0 && image->height > 0);
  CHECK(image->pixels.size() == std::size_t{image->width} * image->height);
  CHECK(image->pixels.size() <= size * 4096);
  CHECK(std::ranges::all_of(image->pixels, [](std::uint32_t pixel) { return pixel >> 24 == 255; }));
  return 0;
}
