#include "render_gl/world/skybox_texture.h"

namespace temblor::render_gl {

base::Status SkyboxTexture::update(const Functions& gl, const render::SpanSources& sources) {
  constexpr int kSides = 6;
  if (!sources.skybox || sources.skybox_version == version_) return base::Ok{};
  const int row = sources.skybox->size + 2;
  if (sources.skybox->size != size_) {
    TRY(texture_, make_texture(gl, GL_RGBA8, {row, row, kSides}));
    size_ = sources.skybox->size;
  }
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, row, row, kSides, GL_RGBA, GL_UNSIGNED_BYTE,
                   sources.skybox->texels);
  TRY_STATUS(gl.check("loading the skybox"));
  version_ = sources.skybox_version;
  return base::Ok{};
}

}  // namespace temblor::render_gl
