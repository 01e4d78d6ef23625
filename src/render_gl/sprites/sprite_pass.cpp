#include "render_gl/sprites/sprite_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "render/color/blend_tables.h"
#include "render/sprites/draw_sprites.h"
#include "render_gl/sprites/sprite_shaders.h"

namespace temblor::render_gl {

namespace {

// A plane as the shader reads it, from another origin, and scaled. Near it, little precision is lost in
// floats.
void copy_plane(const render::ScreenPlane& plane, double x, double y, double scale, float (&out)[3]) {
  out[0] = static_cast<float>(plane.at(x, y) * scale);
  out[1] = static_cast<float>(plane.dx * scale);
  out[2] = static_cast<float>(plane.dy * scale);
}

// Contains all pixels of the quad; nothing if none is in the picture.
std::optional<PixelRect> find_sprite_rect(const render::SpriteQuad& quad, const render::ViewFrame& view) {
  const auto corners = std::span(quad.outline.corners).first(quad.outline.count);
  if (corners.empty()) return std::nullopt;
  const auto [left, right] = std::ranges::minmax(corners, {}, &math::Vec2d::x);
  const auto [top, bottom] = std::ranges::minmax(corners, {}, &math::Vec2d::y);
  const auto bounded = [](double place, int size) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(size)));
  };
  const int x = bounded(left.x - 2, view.width), y = bounded(top.y - 2, view.height);
  const PixelRect rect{x, y, bounded(right.x + 3, view.width) - x, bounded(bottom.y + 3, view.height) - y};
  if (rect.width <= 0 || rect.height <= 0) return std::nullopt;
  return rect;
}

}  // namespace

SpritePass::SpritePass(const Functions& gl, Programs programs, render::PixelFormat format)
    : programs_(std::move(programs)),
      vertex_array_(make_vertex_array(gl)),
      buffer_(make_buffer(gl)),
      textures_(format) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  struct Field {
    GLint size;
    std::size_t offset;
  };
  constexpr std::array<Field, 6> kFields = {{{2, offsetof(Corner, x)},
                                             {2, offsetof(Corner, origin_x)},
                                             {3, offsetof(Corner, depth)},
                                             {3, offsetof(Corner, s)},
                                             {3, offsetof(Corner, t)},
                                             {2, offsetof(Corner, opacity)}}};
  for (GLuint location = 0; location < kFields.size(); ++location) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, kFields[location].size, GL_FLOAT, GL_FALSE, sizeof(Corner),
                           reinterpret_cast<const void*>(kFields[location].offset));
  }
  gl.BindVertexArray(0);
}

base::Result<SpritePass::Programs> SpritePass::make_programs(const Functions& gl, render::PixelFormat format,
                                                             const TexelBlend& blend) {
  const std::string fragment =
      texel_blend_defines(blend) + kSpriteTexelPart + kTexelBlendPart + kSpriteFragmentShader;
  const auto make = [&](ShaderLook look) {
    return ScreenProgram::make(gl, kSpriteVertexShader, fragment.c_str(), look);
  };
  TRY(ScreenProgram program, make(find_look(format)));
  Programs programs{std::move(program), std::nullopt};
  if (format == render::PixelFormat::kIndexed) {
    TRY(programs.blended, make(ShaderLook::kBlendedIndices));
  }
  return programs;
}

base::Result<SpritePass> SpritePass::make(const Functions& gl, render::PixelFormat format) {
  TRY(Programs programs, make_programs(gl, format, {}));
  return SpritePass(gl, std::move(programs), format);
}

base::Status SpritePass::prepare(const Functions& gl, const FrameInput& input) {
  corners_.clear();
  opaque_.clear();
  translucent_.clear();
  // Most pictures of another level have gone with it.
  if (level_ != input.context.level().identity) {
    textures_.clear();
    level_ = input.context.level().identity;
  }
  if (!input.sources.fill_depth || input.scene().sprites.empty()) return base::Ok{};
  if (const TexelBlend wanted = find_texel_blend(input.options); wanted != blend_) {
    TRY(programs_, make_programs(gl, input.context.format, wanted));
    blend_ = wanted;
  }
  textures_.begin_frame();
  for (const render::SpriteQuad& quad :
       render::place_sprites(input.scene(), input.record.view, input.context.arena())) {
    TRY(const Batch batch, add_sprite(gl, input, quad));
    if (!opaque_.empty() && opaque_.back().texture == batch.texture)
      opaque_.back().count += batch.count;
    else
      opaque_.push_back(batch);
  }
  for (const render::SpriteQuad& quad : input.order.sprites) {
    TRY(const Batch batch, add_sprite(gl, input, quad));
    translucent_.push_back(batch);
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)), corners_.data(),
                GL_STREAM_DRAW);
  return gl.check("loading sprites");
}

base::Result<SpritePass::Batch> SpritePass::add_sprite(const Functions& gl, const FrameInput& input,
                                                       const render::SpriteQuad& quad) {
  TRY(const PictureTextures::Found found, textures_.find(gl, *quad.picture, input.context.colors));
  const std::size_t first = corners_.size();
  add_corners(quad, found, input.record.view);
  return Batch{found.texture, first, corners_.size() - first};
}

void SpritePass::add_corners(const render::SpriteQuad& quad, const PictureTextures::Found& found,
                             const render::ViewFrame& view) {
  const auto& outline = quad.outline;
  const double x = std::clamp(outline.corners[0].x, 0.0, view.width - 1.0);
  const double y = std::clamp(outline.corners[0].y, 0.0, view.height - 1.0);
  Corner corner{};
  corner.origin_x = static_cast<float>(x);
  corner.origin_y = static_cast<float>(y);
  // Where the floats are, rather than where they should be.
  copy_plane(quad.depth, double{corner.origin_x}, double{corner.origin_y}, 1, corner.depth);
  copy_plane(quad.s, double{corner.origin_x}, double{corner.origin_y}, found.scale_s, corner.s);
  copy_plane(quad.t, double{corner.origin_x}, double{corner.origin_y}, found.scale_t, corner.t);
  corner.opacity = static_cast<float>(render::opacity_256(quad.alpha)) / render::kOpaque256;
  corner.affine = quad.affine ? 1.0f : 0.0f;
  for (std::size_t i = 2; i < outline.count; ++i)
    for (const std::size_t number : {std::size_t{0}, i - 1, i}) {
      corner.x = static_cast<float>(outline.corners[number].x);
      corner.y = static_cast<float>(outline.corners[number].y);
      corners_.push_back(corner);
    }
}

// A sprite is drawn if it is as near as what is there. Elsewhere it must be nearer. Its picture is in unit 0,
// where variables begin.
void SpritePass::begin_draw(const Functions& gl, const FrameInput& input,
                            const ScreenProgram& program) const {
  program.use(gl, input.record.view, input.scene().fog, input.index_tables);
  gl.BindVertexArray(vertex_array_.name());
  gl.DepthFunc(GL_GEQUAL);
}

void SpritePass::draw_batch(const Functions& gl, const Batch& batch) const {
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, batch.texture);
  gl.DrawArrays(GL_TRIANGLES, static_cast<GLint>(batch.first), static_cast<GLsizei>(batch.count));
}

void SpritePass::draw_opaque(const Functions& gl, const FrameInput& input) const {
  if (opaque_.empty()) return;
  begin_draw(gl, input, programs_.program);
  for (const Batch& batch : opaque_) draw_batch(gl, batch);
  gl.DepthFunc(GL_GREATER);
  gl.BindVertexArray(0);
}

base::Status SpritePass::draw_translucent(const Functions& gl, const FrameInput& input, std::uint32_t sprite,
                                          Target& io_target) const {
  const render::SpriteQuad& quad = input.order.sprites[sprite];
  const std::optional<PixelRect> rect = find_sprite_rect(quad, input.record.view);
  if (!rect) return base::Ok{};
  const ScreenProgram& program = programs_.blended ? *programs_.blended : programs_.program;
  begin_draw(gl, input, program);
  if (input.index_tables != nullptr) {
    const IndexBlend blend{.table = input.context.colors.blends.table_for(quad.alpha)};
    TRY_STATUS(input.index_tables->use_blend(gl, program.index_uniforms(), blend, *rect, io_target));
  } else {
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  gl.DepthMask(GL_FALSE);
  draw_batch(gl, translucent_[sprite]);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.DepthFunc(GL_GREATER);
  gl.BindVertexArray(0);
  return base::Ok{};
}

}  // namespace temblor::render_gl
