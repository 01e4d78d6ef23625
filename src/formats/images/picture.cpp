#include "formats/images/picture.h"

#include <algorithm>
#include <span>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kPictureHeaderBytes = 8;
constexpr std::uint32_t kConcharsSide = 128;  // pixels
constexpr std::uint8_t kTransparent = 255;

bool is_picture_side(std::uint32_t side) {
  return side >= 1 && side <= kMaxPictureSide;
}

}  // namespace

base::Result<Picture> read_picture(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  const std::uint32_t width = reader.u32();
  const std::uint32_t height = reader.u32();
  if (!reader.ok())
    return base::malformed("picture header needs {} bytes, the file has {}", kPictureHeaderBytes,
                           bytes.size());
  if (!is_picture_side(width) || !is_picture_side(height))
    return base::malformed("picture of {} x {} pixels, sides are 1 to {}", width, height, kMaxPictureSide);
  const auto pixels = base::as_u8(reader.take(std::size_t{width} * height));
  if (!reader.ok())
    return base::malformed("picture of {} x {} pixels: only {} bytes follow its header", width, height,
                           bytes.size() - kPictureHeaderBytes);
  return Picture{width, height, {pixels.begin(), pixels.end()}};
}

base::ByteVector write_picture(const Picture& picture) {
  CHECK(is_picture_side(picture.width) && is_picture_side(picture.height), "{} x {}", picture.width,
        picture.height);
  CHECK(picture.pixels.size() == std::size_t{picture.width} * picture.height, "{}", picture.pixels.size());
  base::ByteWriter writer;
  writer.u32(picture.width);
  writer.u32(picture.height);
  writer.bytes(std::as_bytes(std::span(picture.pixels)));
  return std::move(writer).take();
}

base::Result<Picture> read_conchars(base::Bytes lump) {
  constexpr std::size_t kPixels = std::size_t{kConcharsSide} * kConcharsSide;
  if (lump.size() < kPixels)
    return base::malformed("conchars lump has {} bytes, expected {}", lump.size(), kPixels);
  const auto pixels = base::as_u8(lump.first(kPixels));
  Picture picture{kConcharsSide, kConcharsSide, {pixels.begin(), pixels.end()}};
  std::replace(picture.pixels.begin(), picture.pixels.end(), std::uint8_t{0}, kTransparent);
  return picture;
}

}  // namespace temblor::formats
