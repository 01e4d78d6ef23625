#include "render_gl/surfaces/block_atlas.h"

#include <algorithm>

namespace temblor::render_gl {

namespace {

// The largest texture that is repeated, and the largest block of a texture with fine mip levels.
constexpr int kLayerPower = 11;
constexpr int kLayerTexels = 1 << kLayerPower;

std::size_t texel_bytes(render::PixelFormat format) {
  return format == render::PixelFormat::kIndexed ? 1 : 4;
}

}  // namespace

BlockAtlas::BlockAtlas(Texture texture, render::PixelFormat format, int layers)
    : texture_(std::move(texture)), format_(format), rectangles_(kLayerPower, layers) {}

base::Result<BlockAtlas> BlockAtlas::make(const Functions& gl, render::PixelFormat format,
                                          std::size_t bytes) {
  const std::size_t layer_bytes = std::size_t{kLayerTexels} * kLayerTexels * texel_bytes(format);
  const int layers = static_cast<int>(std::clamp<std::size_t>(bytes / layer_bytes, 1, 256));
  const GLenum gl_format = format == render::PixelFormat::kIndexed ? GL_R8 : GL_RGBA8;
  TRY(Texture texture, make_texture(gl, gl_format, {kLayerTexels, kLayerTexels, layers}));
  return BlockAtlas(std::move(texture), format, layers);
}

void BlockAtlas::clear() {
  cells_.clear();
  rectangles_.clear();
  ++counts_.flushes;
}

std::optional<AtlasPlace> BlockAtlas::place(const Functions& gl, const AtlasImage& image) {
  const RectAllocator::Size size = RectAllocator::fit(image.shape.width, image.shape.height);
  auto found = cells_.find(image.key);
  // The CPU's cache may have reused the memory of a block for one of another size.
  if (found != cells_.end() &&
      (found->second.size.width != size.width || found->second.size.height != size.height)) {
    rectangles_.free(found->second.size, found->second.place);
    cells_.erase(found);
    found = cells_.end();
  }
  if (found != cells_.end() && !image.changed) return found->second.place;
  if (found == cells_.end()) {
    const std::optional<AtlasPlace> place = rectangles_.allocate(size);
    if (!place) return std::nullopt;
    found = cells_.emplace(image.key, Cell{*place, size}).first;
  }
  upload(gl, image, found->second.place);
  return found->second.place;
}

void BlockAtlas::upload(const Functions& gl, const AtlasImage& image, AtlasPlace place) {
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, place.x, place.y, place.layer, image.shape.width,
                   image.shape.height, 1, format_ == render::PixelFormat::kIndexed ? GL_RED : GL_RGBA,
                   GL_UNSIGNED_BYTE, image.texels);
  ++counts_.uploads;
  counts_.bytes_uploaded += image.shape.texels() * texel_bytes(format_);
}

}  // namespace temblor::render_gl
