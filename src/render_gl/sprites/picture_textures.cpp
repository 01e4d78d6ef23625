#include "render_gl/sprites/picture_textures.h"

#include "render/sprites/sprite_kernels.h"
#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// All sprites of stock Quake have 100,000.
constexpr std::size_t kMaxTexels = std::size_t{8} << 20;

std::vector<std::uint32_t> color_texels(const formats::SprPicture& picture,
                                        const render::ColorTables& colors) {
  std::vector<std::uint32_t> out;
  out.reserve(picture.texels.size());
  for (const std::uint8_t texel : picture.texels)
    out.push_back(texel == render::kClearTexel ? 0 : colors.rgb[texel]);
  return out;
}

}  // namespace

void PictureTextures::begin_frame() {
  if (texel_count_ > kMaxTexels) clear();
}

void PictureTextures::clear() {
  entries_.clear();
  texel_count_ = 0;
}

base::Result<PictureTextures::Found> PictureTextures::find(const Functions& gl,
                                                           const formats::SprPicture& picture,
                                                           const render::ColorTables& colors) {
  Entry& entry = entries_[picture.texels.data()];
  const bool same_size = entry.width == picture.width && entry.height == picture.height;
  const auto found = [&] { return Found{entry.texture.name(), entry.scale_s, entry.scale_t}; };
  if (same_size && entry.texels == picture.texels) return found();
  const int full_width = static_cast<int>(picture.width), full_height = static_cast<int>(picture.height);
  const int halvings = count_halvings(full_width, full_height, find_texture_limits(gl).side);
  const int width = halve(full_width, halvings), height = halve(full_height, halvings);
  const bool is_indexed = format_ == render::PixelFormat::kIndexed;
  TRY(entry.texture, make_texture(gl, is_indexed ? GL_R8 : GL_RGBA8, {width, height}));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto upload = [&](const auto* texels) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, is_indexed ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE,
                     halve_picture(texels, full_width, full_height, halvings).data());
  };
  if (is_indexed)
    upload(picture.texels.data());
  else
    upload(color_texels(picture, colors).data());
  entry.scale_s = static_cast<double>(width) / full_width;
  entry.scale_t = static_cast<double>(height) / full_height;
  texel_count_ += picture.texels.size();
  texel_count_ -= entry.texels.size();
  entry.width = picture.width;
  entry.height = picture.height;
  entry.texels = picture.texels;
  return found();
}

}  // namespace temblor::render_gl
