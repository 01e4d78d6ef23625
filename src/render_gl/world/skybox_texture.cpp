#include "render_gl/world/skybox_texture.h"

#include <vector>

#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

constexpr int kSides = 6;

// The first texel of the row or column that texel number `at` of a smaller side stands for. Borders, of which
// each side has one at either end, stay borders.
int find_source(int at, int small_size, int size, int halvings) {
  if (at == 0) return 0;
  return at > small_size ? size + 1 : ((at - 1) << halvings) + 1;
}

template <typename Texel>
std::vector<Texel> shrink_sides(const Texel* texels, int size, int halvings) {
  const int small_size = halve(size, halvings), row = size + 2;
  std::vector<Texel> out;
  for (int side = 0; side < kSides; ++side)
    for (int y = 0; y < small_size + 2; ++y)
      for (int x = 0; x < small_size + 2; ++x)
        out.push_back(texels[(std::ptrdiff_t{side} * row + find_source(y, small_size, size, halvings)) * row +
                             find_source(x, small_size, size, halvings)]);
  return out;
}

// `source`: the sides as the CPU has them, with `size` texels each way, and their borders.
template <typename Texel>
void upload_sides(const Functions& gl, const void* source, int size, int halvings) {
  constexpr bool kIsIndexed = sizeof(Texel) == 1;
  const auto* texels = static_cast<const Texel*>(source);
  std::vector<Texel> smaller;
  if (halvings > 0) {
    smaller = shrink_sides(texels, size, halvings);
    texels = smaller.data();
  }
  const int row = halve(size, halvings) + 2;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, row, row, kSides, kIsIndexed ? GL_RED : GL_RGBA,
                   GL_UNSIGNED_BYTE, texels);
}

}  // namespace

base::Status SkyboxTexture::update(const Functions& gl, const render::SpanSources& sources) {
  if (!sources.skybox || sources.skybox_version == version_) return base::Ok{};
  const int full_size = sources.skybox->size;
  const int halvings = count_halvings(full_size, full_size, find_texture_limits(gl).side - 2);
  const int size = halve(full_size, halvings), row = size + 2;
  const bool is_indexed = sources.format == render::PixelFormat::kIndexed;
  if (size != size_) {
    TRY(texture_, make_texture(gl, is_indexed ? GL_R8 : GL_RGBA8, {row, row, kSides}));
    size_ = size;
  }
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  const auto upload = is_indexed ? upload_sides<std::uint8_t> : upload_sides<std::uint32_t>;
  upload(gl, sources.skybox->texels, full_size, halvings);
  TRY_STATUS(gl.check("loading the skybox"));
  version_ = sources.skybox_version;
  return base::Ok{};
}

}  // namespace temblor::render_gl
