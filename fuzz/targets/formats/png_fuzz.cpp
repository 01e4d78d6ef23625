// Feeds arbitrary bytes to the PNG reader, with the checksums of the chunks corrected so that damage gets
// past them. It must return an error, or an image whose colors are written and read back unchanged.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "formats/images/image.h"
#include "formats/images/png.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kChunkBytes = 12;  // length, type, and checksum; without the data

// PNG's CRC-32, bit by bit.
std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = ~0u;
  for (const std::uint8_t byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1) * 0xedb88320u;
  }
  return ~sum;
}

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes.first(4)) value = value << 8 | byte;
  return value;
}

void mend_checksums(std::span<std::uint8_t> io_png) {
  std::size_t at = kSignatureBytes;
  while (io_png.size() >= at && io_png.size() - at >= kChunkBytes) {
    const std::size_t length = big_endian(io_png.subspan(at));
    if (length > io_png.size() - at - kChunkBytes) return;
    const std::uint32_t sum = checksum(io_png.subspan(at + 4, 4 + length));
    for (std::size_t i = 0; i < 4; ++i)
      io_png[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += length + kChunkBytes;
  }
}

}  // namespace

int temblor::fuzz::fuzz_png(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> png(data, data + size);
  mend_checksums(png);
  auto image = formats::read_png(std::as_bytes(std::span(png)));
  if (!image.ok()) return 0;
  for (std::uint32_t& pixel : image->pixels) pixel |= 0xff000000u;
  const auto written =
      formats::write_png(image->pixels, static_cast<int>(image->width), static_cast<int>(image->height));
  CHECK(written.ok(), "{}", written.error().message());
  const auto back = formats::read_png(*written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *image);
  return 0;
}
