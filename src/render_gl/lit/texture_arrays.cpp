#include "render_gl/lit/texture_arrays.h"

#include <algorithm>
#include <bit>
#include <span>

#include "render/color/own_colors.h"
#include "render/surfaces/surface_block.h"
#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// The extension EXT_texture_filter_anisotropic, which nearly every driver has.
constexpr GLenum kMaxAnisotropy = 0x84fe, kMaxMaxAnisotropy = 0x84ff;
constexpr int kWantedAnisotropy = 16;

constexpr int kLastMip = 3;

int side_at(std::uint32_t side, int mip) {
  return std::max(1, render::at_mip(static_cast<int>(side), mip));
}

bool can_be_lit(const world::Texture& texture) {
  return texture.kind == world::TextureKind::kOpaque && (!texture.colors || texture.colors->glow.empty());
}

// 0xAARRGGBB, row by row; alpha 0: full-bright.
std::vector<std::uint32_t> read_mip(const world::Texture& texture, int mip,
                                    const render::ColorTables& colors) {
  const std::vector<std::uint8_t>& indices = texture.indices(mip);
  std::vector<std::uint32_t> texels(indices.size());
  if (const std::uint32_t* const own = render::own_colors(texture, mip).colors)
    std::copy_n(own, indices.size(), texels.begin());
  else
    std::ranges::transform(indices, texels.begin(),
                           [&](std::uint8_t index) { return colors.surface_rgb[index]; });
  return texels;
}

// The next smaller mip level: means of up to 2 x 2 texels.
std::vector<std::uint32_t> halve_level(std::span<const std::uint32_t> texels, int width, int height) {
  std::vector<std::uint32_t> out;
  const int step_x = width > 1 ? 2 : 1, step_y = height > 1 ? 2 : 1;
  const auto count = static_cast<std::uint32_t>(step_x * step_y);
  for (int y = 0; y + step_y <= height; y += step_y)
    for (int x = 0; x + step_x <= width; x += step_x) {
      std::uint32_t mean = 0;
      for (int shift = 0; shift < 32; shift += 8) {
        std::uint32_t sum = count / 2;
        for (int row = y; row < y + step_y; ++row)
          for (int column = x; column < x + step_x; ++column)
            sum += texels[static_cast<std::size_t>(row * width + column)] >> shift & 255;
        mean |= sum / count << shift;
      }
      out.push_back(mean);
    }
  return out;
}

}  // namespace

std::optional<TextureArrays::Place> TextureArrays::find(world::TextureIndex texture) const {
  return places_.empty() ? std::nullopt : places_[base::to_size(texture)];
}

std::optional<TextureArrays::Place> TextureArrays::add(const world::Texture& texture, int max_side,
                                                       int max_layers) {
  const int finest = texture.finest_mip();
  const int width = side_at(texture.width, finest), height = side_at(texture.height, finest);
  if (!can_be_lit(texture) || width > max_side || height > max_side) return std::nullopt;
  auto array = std::ranges::find_if(arrays_, [&](const Array& other) {
    return other.width == width && other.height == height && other.finest_mip == finest &&
           other.layers < max_layers;
  });
  const int levels = std::bit_width(static_cast<unsigned>(std::max(width, height)));
  if (array == arrays_.end()) {
    arrays_.push_back({{}, width, height, finest, levels, 0});
    array = std::prev(arrays_.end());
  }
  return Place{static_cast<std::uint16_t>(array - arrays_.begin()),
               static_cast<std::uint16_t>(array->layers++), static_cast<std::int8_t>(finest),
               static_cast<std::int8_t>(levels)};
}

base::Status TextureArrays::allocate(const Functions& gl) {
  for (Array& array : arrays_) {
    TRY(array.texture, make_texture(gl, GL_RGBA8, {array.width, array.height, array.layers, array.levels}));
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
    for (int level = 0; level < array.levels; ++level)
      bytes_ += std::size_t{4} * static_cast<std::size_t>(halve(array.width, level)) *
                static_cast<std::size_t>(halve(array.height, level)) * static_cast<std::size_t>(array.layers);
  }
  return base::Ok{};
}

base::Result<TextureArrays> TextureArrays::make(const Functions& gl, const world::Level& level,
                                                const render::ColorTables& colors) {
  const TextureLimits limits = find_texture_limits(gl);
  TextureArrays made;
  for (const world::Texture& texture : level.textures)
    made.places_.push_back(made.add(texture, limits.side, limits.layers));
  TRY_STATUS(made.allocate(gl));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t number = 0; number < level.textures.size(); ++number) {
    const world::Texture& texture = level.textures[number];
    std::optional<Place>& place = made.places_[number];
    if (!place) continue;
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, made.texture(place->array));
    std::vector<std::uint32_t> texels;
    for (int i = 0; i < place->levels; ++i) {
      const int mip = place->finest_mip + i;
      const int width = side_at(texture.width, mip), height = side_at(texture.height, mip);
      texels = mip <= kLastMip
                   ? read_mip(texture, mip, colors)
                   : halve_level(texels, side_at(texture.width, mip - 1), side_at(texture.height, mip - 1));
      place->has_bright |=
          std::ranges::any_of(texels, [](std::uint32_t texel) { return texel >> 24 != 255; });
      gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, i, 0, 0, place->layer, width, height, 1, GL_RGBA,
                       GL_UNSIGNED_BYTE, texels.data());
    }
  }
  TRY_STATUS(gl.check("loading the level's textures"));
  return made;
}

void TextureArrays::set_filter(const Functions& gl, render::TextureFilter filter) {
  const bool is_anisotropic = filter == render::TextureFilter::kAnisotropic;
  const bool is_nearest = filter == render::TextureFilter::kNearest;
  const GLint smaller = is_nearest                                   ? GL_NEAREST_MIPMAP_NEAREST
                        : filter == render::TextureFilter::kBilinear ? GL_LINEAR_MIPMAP_NEAREST
                                                                     : GL_LINEAR_MIPMAP_LINEAR;
  GLint anisotropy = 0;  // stays 0 without the extension
  if (gl.has_anisotropy) gl.GetIntegerv(kMaxMaxAnisotropy, &anisotropy);
  for (const Array& array : arrays_) {
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, array.texture.name());
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, smaller);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, is_nearest ? GL_NEAREST : GL_LINEAR);
    if (anisotropy > 0)
      gl.TexParameteri(GL_TEXTURE_2D_ARRAY, kMaxAnisotropy,
                       is_anisotropic ? std::min(anisotropy, kWantedAnisotropy) : 1);
  }
}

}  // namespace temblor::render_gl
