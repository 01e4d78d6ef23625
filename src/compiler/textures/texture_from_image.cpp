#include "compiler/textures/texture_from_image.h"

#include <utility>

namespace temblor::compiler {
namespace {

// Dull: not full-bright. A full-bright color must be asked for exactly, or textures would glow in places.
std::uint8_t find_palette_index(std::uint32_t argb, bool has_holes, const formats::MipColors& colors) {
  const auto byte = [argb](int shift) { return static_cast<std::uint8_t>(argb >> shift); };
  constexpr std::uint8_t kHalfOpaque = 128;
  if (has_holes && byte(24) < kHalfOpaque) return formats::kTransparentIndex;
  const formats::Rgb color{byte(16), byte(8), byte(0)};
  const std::uint8_t dull = colors.dull.find(color);
  if (colors.palette[dull] == color) return dull;
  const std::uint8_t bright = colors.bright.find(color);
  return colors.palette[bright] == color ? bright : dull;
}

}  // namespace

base::Result<formats::WadTexture> texture_from_image(std::string_view name, const formats::Image& image,
                                                     const formats::MipColors& colors) {
  constexpr std::uint32_t kSideMultiple = 16;
  if (image.width % kSideMultiple != 0 || image.height % kSideMultiple != 0)
    return base::error(base::ErrorCode::kUsage, "{} x {} pixels: width and height must be multiples of {}",
                       image.width, image.height, kSideMultiple);
  const bool has_holes = name.starts_with('{');
  std::vector<std::uint8_t> indices;
  indices.reserve(image.pixels.size());
  for (const std::uint32_t pixel : image.pixels)
    indices.push_back(find_palette_index(pixel, has_holes, colors));
  return formats::WadTexture{
      std::string(name), image.width, image.height,
      formats::build_mips(std::move(indices), image.width, image.height, has_holes, colors)};
}

}  // namespace temblor::compiler
