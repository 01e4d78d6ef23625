#include "render_gl/screen/depth_reader.h"

#include <bit>

#include "base/check.h"
#include "render/alias/place_alias.h"
#include "render_gl/frame/screen_space.h"
#include "render_gl/screen/whole_picture.h"

namespace temblor::render_gl {

namespace {

static_assert(std::endian::native == std::endian::little, "bytes of a color are those of a number");

// The view weapon is in the half of the depths that nothing hides (kWorldDepthEnd).
constexpr const char* kDepthFragmentShader = R"(
uniform highp sampler2D depth;
uniform vec2 depth_scale;  // the card's depth is x + y * depth
uniform float weapon_scale;

out vec4 color;

void main() {
  float drawn = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x;
  bool is_weapon = drawn > 0.5;
  float card_depth = 2.0 * (is_weapon ? drawn - 0.5 : drawn);
  float cpu_depth = (is_weapon ? weapon_scale : 1.0) * (card_depth - depth_scale.x) / depth_scale.y;
  uint bits = drawn > 0.0 ? floatBitsToUint(cpu_depth) : 0xff7fffffu;
  color = vec4(uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u) / 255.0;
}
)";

}  // namespace

DepthReader::DepthReader(const Functions& gl, Program program)
    : program_(std::move(program)),
      depth_(gl.GetUniformLocation(program_.name(), "depth")),
      depth_scale_(gl.GetUniformLocation(program_.name(), "depth_scale")),
      weapon_scale_(gl.GetUniformLocation(program_.name(), "weapon_scale")),
      no_vertices_(make_vertex_array(gl)) {}

base::Result<DepthReader> DepthReader::make(const Functions& gl) {
  TRY(Program program, make_program(gl, kWholePictureShader, kDepthFragmentShader));
  return DepthReader(gl, std::move(program));
}

base::Status DepthReader::read(const Functions& gl, const render::ViewFrame& view, const Target& target,
                               std::span<float> out_depth) const {
  CHECK(out_depth.size() ==
        static_cast<std::size_t>(target.width()) * static_cast<std::size_t>(target.height()));
  TRY(const Texture bits, make_texture(gl, GL_RGBA8, {target.width(), target.height()}));
  const Framebuffer framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, bits.name(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return base::error(base::ErrorCode::kUnsupported, "the graphics card cannot draw into a texture");
  gl.UseProgram(program_.name());
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, target.depth_texture());
  gl.Uniform1i(depth_, 0);
  const math::Vec2 scale = find_depth_scale(view);
  gl.Uniform2f(depth_scale_, scale.x, scale.y);
  gl.Uniform1f(weapon_scale_, render::kWeaponDepthScale);
  draw_whole_picture(gl, no_vertices_);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, target.width(), target.height(), GL_RGBA, GL_UNSIGNED_BYTE, out_depth.data());
  target.bind(gl);
  return gl.check("reading the depth");
}

}  // namespace temblor::render_gl
