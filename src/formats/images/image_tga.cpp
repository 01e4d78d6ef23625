// TGA after the Truevision specification of 1991. Interleaved rows are read as ordinary ones, as other
// engines do: no known tool writes them, but some set their bits. Faults that leave most of the picture
// intact are passed over: pixels after the end of a truncated file are transparent, colors outside of the map
// are black, and a run may be longer than the picture.
//
//   header, 18 bytes    0  id size u8             bytes after the header, skipped
//                       1  has color map u8
//                       2  type u8                1 color-mapped, 2 true-color, 3 gray; +8: run-length coded
//                       3  color map: first entry u16, number of entries u16, bits of an entry u8
//                       8  position on a screen u16 x2
//                      12  width u16, height u16
//                      16  bits of a pixel u8
//                      17  descriptor u8          bits 0-3 alpha bits, 4 right to left, 5 top to bottom, 6-7
//                                                 interleaving, ignored
//   id | color map | pixels
//
// Coded pixels are packets: a byte with the number of pixels - 1 in its low 7 bits, then one pixel that
// repeats if bit 7 is set, otherwise as many pixels as the number says.
#include <algorithm>
#include <span>

#include "base/check.h"
#include "formats/images/image.h"

namespace temblor::formats {
namespace {

using base::ErrorCode;

constexpr std::size_t kTgaHeaderBytes = 18;
constexpr std::uint8_t kRunLengthCoded = 8;  // flag of the image type
constexpr std::uint8_t kAlphaBits = 0x0f, kRightToLeft = 0x10, kTopToBottom = 0x20;
constexpr std::size_t kMaxPacketPixels = 128;

enum class Colors : std::uint8_t { kMapped = 1, kTrue = 2, kGray = 3 };

struct TgaHeader {
  Colors colors = Colors::kTrue;
  bool coded = false;
  std::uint8_t id_bytes = 0;
  bool has_map = false;
  std::uint16_t map_first = 0, map_entries = 0;
  std::uint8_t map_bits = 0;
  std::uint16_t width = 0, height = 0;
  std::uint8_t pixel_bits = 0, descriptor = 0;

  std::size_t pixel_count() const { return std::size_t{width} * height; }
  std::size_t pixel_bytes() const { return (pixel_bits + 7u) / 8; }
  std::size_t map_bytes() const { return map_entries * ((map_bits + 7u) / 8); }
};

std::uint32_t pack_argb(std::uint32_t a, std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return a << 24 | r << 16 | g << 8 | b;
}

bool are_color_bits(std::uint8_t bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

bool are_pixel_bits(Colors colors, std::uint8_t bits) {
  return colors == Colors::kTrue ? are_color_bits(bits) : bits == 8 || bits == 16;
}

// Converts a pixel or color map entry. In 16 bits the top bit is alpha, if the header declares alpha.
std::uint32_t read_color(base::ByteReader& io_reader, std::uint8_t bits, bool has_alpha) {
  if (bits <= 16) {
    const std::uint32_t value = io_reader.u16();
    const auto channel = [&](std::uint32_t shift) { return ((value >> shift & 31) * 255 + 15) / 31; };
    const bool transparent = bits == 16 && has_alpha && (value & 0x8000) == 0;
    return pack_argb(transparent ? 0 : 255, channel(10), channel(5), channel(0));
  }
  const std::uint32_t b = io_reader.u8(), g = io_reader.u8(), r = io_reader.u8();
  return pack_argb(bits == 32 ? io_reader.u8() : 255u, r, g, b);
}

std::uint32_t read_gray(base::ByteReader& io_reader, std::uint8_t bits) {
  const std::uint32_t level = io_reader.u8();
  return pack_argb(bits == 16 ? io_reader.u8() : 255u, level, level, level);
}

base::Result<TgaHeader> read_header(base::ByteReader& io_reader) {
  if (io_reader.remaining() < kTgaHeaderBytes)
    return base::malformed("TGA header needs {} bytes, the file has {}", kTgaHeaderBytes,
                           io_reader.remaining());
  TgaHeader header;
  header.id_bytes = io_reader.u8();
  header.has_map = io_reader.u8() != 0;
  const std::uint8_t type = io_reader.u8();
  header.coded = (type & kRunLengthCoded) != 0;
  header.colors = static_cast<Colors>(type & ~kRunLengthCoded);
  header.map_first = io_reader.u16();
  header.map_entries = io_reader.u16();
  header.map_bits = io_reader.u8();
  io_reader.take(4);  // position on a screen
  header.width = io_reader.u16();
  header.height = io_reader.u16();
  header.pixel_bits = io_reader.u8();
  header.descriptor = io_reader.u8();
  if (header.colors < Colors::kMapped || header.colors > Colors::kGray)
    return base::error(ErrorCode::kUnsupported, "TGA of unknown type {} (supported: 1, 2, 3, 9, 10, 11)",
                       type);
  if (!are_pixel_bits(header.colors, header.pixel_bits))
    return base::error(ErrorCode::kUnsupported, "TGA of type {} with {} bits per pixel", type,
                       header.pixel_bits);
  if (header.width == 0 || header.height == 0 || header.width > kMaxImageSide ||
      header.height > kMaxImageSide)
    return base::malformed("TGA of {} x {} pixels, sides are 1 to {}", header.width, header.height,
                           kMaxImageSide);
  if (header.colors == Colors::kMapped && !header.has_map)
    return base::malformed("TGA of type {} without a color map", type);
  if (header.colors == Colors::kMapped && !are_color_bits(header.map_bits))
    return base::error(ErrorCode::kUnsupported, "TGA with a color map of {} bits per entry", header.map_bits);
  return header;
}

bool has_alpha(const TgaHeader& header) {
  return (header.descriptor & kAlphaBits) != 0;
}

base::Result<std::vector<std::uint32_t>> read_map(base::ByteReader& io_reader, const TgaHeader& header) {
  std::vector<std::uint32_t> map;
  if (!header.has_map) return map;
  if (io_reader.remaining() < header.map_bytes())
    return base::malformed("TGA: the color map at offset {:#x} needs {} bytes, only {} are left",
                           io_reader.offset(), header.map_bytes(), io_reader.remaining());
  if (header.colors != Colors::kMapped) {
    io_reader.take(header.map_bytes());
    return map;
  }
  map.reserve(header.map_entries);
  for (std::size_t i = 0; i < header.map_entries; ++i)
    map.push_back(read_color(io_reader, header.map_bits, has_alpha(header)));
  return map;
}

// Reads the next pixel. Returns transparent black past the end; the caller checks the reader.
std::uint32_t read_pixel(base::ByteReader& io_reader, const TgaHeader& header,
                         std::span<const std::uint32_t> map) {
  if (io_reader.remaining() < header.pixel_bytes()) {
    io_reader.take(header.pixel_bytes());
    return 0;
  }
  switch (header.colors) {
    case Colors::kTrue:
      return read_color(io_reader, header.pixel_bits, has_alpha(header));
    case Colors::kGray:
      return read_gray(io_reader, header.pixel_bits);
    case Colors::kMapped:
      break;
  }
  const std::uint32_t index = header.pixel_bits == 8 ? io_reader.u8() : io_reader.u16();
  const bool is_in_map = index >= header.map_first && index - header.map_first < map.size();
  return is_in_map ? map[index - header.map_first] : pack_argb(255, 0, 0, 0);
}

// Returns the minimum size of the pixel data.
std::size_t min_pixel_bytes(const TgaHeader& header) {
  if (!header.coded) return header.pixel_count() * header.pixel_bytes();
  return (header.pixel_count() + kMaxPacketPixels - 1) / kMaxPacketPixels * (1 + header.pixel_bytes());
}

// Returns the pixels in file order. An image without run-length coding is read as packets of one pixel. At
// least half of the data must be there, so that a short file cannot request a large image.
base::Result<std::vector<std::uint32_t>> read_pixels(base::ByteReader& io_reader, const TgaHeader& header,
                                                     std::span<const std::uint32_t> map) {
  if (io_reader.remaining() < (min_pixel_bytes(header) + 1) / 2)
    return base::malformed(
        "TGA of {} x {} pixels: more than half of the data at offset {:#x} is missing, only {} bytes remain",
        header.width, header.height, io_reader.offset(), io_reader.remaining());
  std::vector<std::uint32_t> pixels;
  pixels.reserve(header.pixel_count());
  while (io_reader.ok() && pixels.size() < header.pixel_count()) {
    const std::uint8_t head = header.coded ? io_reader.u8() : std::uint8_t{0};
    const bool repeated = (head & 0x80) != 0;
    const std::size_t count = std::min<std::size_t>((head & 0x7fu) + 1, header.pixel_count() - pixels.size());
    for (std::size_t i = 0; i < (repeated ? 1 : count); ++i)
      pixels.insert(pixels.end(), repeated ? count : 1, read_pixel(io_reader, header, map));
  }
  pixels.resize(header.pixel_count());
  return pixels;
}

// Reorders the pixels to rows from the top, each from the left. Most files are stored bottom to top.
void flip_to_top_left(const TgaHeader& header, std::span<std::uint32_t> io_pixels) {
  const auto row = [&](std::size_t y) { return io_pixels.subspan(y * header.width, header.width); };
  if ((header.descriptor & kRightToLeft) != 0)
    for (std::size_t y = 0; y < header.height; ++y) std::ranges::reverse(row(y));
  if ((header.descriptor & kTopToBottom) == 0)
    for (std::size_t y = 0; y < header.height / 2u; ++y)
      std::ranges::swap_ranges(row(y), row(header.height - 1u - y));
}

}  // namespace

base::Result<Image> read_tga(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  TRY(const TgaHeader header, read_header(reader));
  reader.take(header.id_bytes);
  TRY(const std::vector<std::uint32_t> map, read_map(reader, header));
  TRY(std::vector<std::uint32_t> pixels, read_pixels(reader, header, map));
  flip_to_top_left(header, pixels);
  return Image{header.width, header.height, std::move(pixels)};
}

base::ByteVector write_tga(const Image& image) {
  CHECK(
      image.width >= 1 && image.height >= 1 && image.width <= kMaxImageSide && image.height <= kMaxImageSide,
      "{} x {}", image.width, image.height);
  CHECK(image.pixels.size() == std::size_t{image.width} * image.height, "{}", image.pixels.size());
  constexpr std::uint8_t kBits = 32, kEightAlphaBits = 8;
  base::ByteWriter writer;
  writer.u8(0);  // no id
  writer.u8(0);  // no color map
  writer.u8(static_cast<std::uint8_t>(Colors::kTrue));
  for (int map_byte = 0; map_byte < 5; ++map_byte) writer.u8(0);
  writer.u32(0);  // position on a screen
  writer.u16(static_cast<std::uint16_t>(image.width));
  writer.u16(static_cast<std::uint16_t>(image.height));
  writer.u8(kBits);
  writer.u8(kTopToBottom | kEightAlphaBits);
  for (const std::uint32_t pixel : image.pixels) writer.u32(pixel);  // B, G, R, A in the file
  return std::move(writer).take();
}

}  // namespace temblor::formats
