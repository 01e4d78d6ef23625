#include "render_gl/styles/style_method.h"

#include <algorithm>
#include <cmath>

namespace temblor::render_gl {

namespace {

// A light as light_on_face() takes it.
std::array<float, 8> describe_light(const render::DynamicLight& light, bool is_colored) {
  const auto channel = [&](int number) {
    const float factor = is_colored ? light.color[number] : 1.0f;
    return factor > 0 ? std::min(factor, render::kMaxColor) : 0.0f;
  };
  return {light.origin_world.x, light.origin_world.y,
          light.origin_world.z, std::min(light.radius, render::kMaxLight),
          channel(2),           channel(1),
          channel(0),           std::max(0.0f, light.least)};
}

bool is_finite(const std::array<float, 8>& numbers) {
  return std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); });
}

}  // namespace

base::Status StyleMethod::set_level(const Functions& gl, const render::FrameContext& context) {
  samples_ = {};  // before the memory for the next ones is needed
  TRY_STATUS(LitMethod::set_level(gl, context));
  TRY(samples_, StyleSamples::make(gl, context.level()));
  ++counts_.uploads;
  counts_.bytes_uploaded += samples_.bytes();
  return base::Ok{};
}

// A record has 8 bits for each number of the tile.
bool StyleMethod::can_light(const world::Level& level, const render::BlockRequest& request) const {
  const render::BlockContents& contents = request.contents;
  return contents.light_view == render::LightView::kLit && contents.caustic_step == 0 &&
         request.tile_s < 256 && request.tile_t < 256 &&
         samples_.contains(level.face(request.face), base::to_size(request.face));
}

base::Status StyleMethod::prepare(const Functions& gl, const FrameInput& input) {
  const render::Scene& scene = input.scene();
  const bool shows_color = input.context.settings.colored_light;
  is_colored_ = shows_color && !input.context.level().light_rgb.empty();
  for (std::size_t style = 0; style < style_values_.size(); ++style)
    style_values_[style] = static_cast<float>(scene.light_styles[style]) / 256.0f;
  std::vector<std::array<float, 8>> lights;
  for (const render::DynamicLight& light : scene.lights) {
    const std::array<float, 8> described = describe_light(light, shows_color);
    if (is_finite(described)) lights.push_back(described);
  }
  light_count_ = static_cast<int>(lights.size());
  if (light_count_ > light_capacity_ || !lights_) {
    light_capacity_ = std::max(16, 2 * light_count_);
    TRY(lights_, make_texture(gl, GL_RGBA32F, {2, light_capacity_}));
  }
  gl.BindTexture(GL_TEXTURE_2D, lights_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (light_count_ > 0)
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, light_count_, GL_RGBA, GL_FLOAT, lights.data());
  return base::Ok{};
}

std::optional<TileRecord> StyleMethod::place(const Functions&, const FrameInput& input, std::uint32_t draw,
                                             BlockAtlas&) {
  constexpr int kSamplePower = 4;  // 16 texels of mip 0
  const render::BlockRequest& request = tiles_.request(draw);
  TileRecord record = tiles_.make_record(input.context.level(), draw, kSamplePower - request.mip);
  record.place = static_cast<std::uint32_t>(request.face);
  record.flags |= std::uint32_t{request.tile_s} | std::uint32_t{request.tile_t} << 8;
  return record;
}

void StyleMethod::use(const Functions& gl, const FaceProgram& program, const LitLook& look) const {
  LitMethod::use(gl, program, look);
  const auto bind = [&](GLint unit, GLuint texture) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, texture);
  };
  bind(face_units::kSamples, samples_.sample_texture());
  bind(face_units::kFaces, samples_.face_texture());
  bind(face_units::kLights, lights_.name());
  static_assert(world::kLightStyles == 64, "style_values in style_shaders.h has as many");
  gl.Uniform4fv(program.styles.values, static_cast<GLsizei>(style_values_.size() / 4), style_values_.data());
  gl.Uniform1i(program.styles.is_colored, is_colored_);
  gl.Uniform1i(program.styles.light_count, look.has_lights ? light_count_ : 0);
}

}  // namespace temblor::render_gl
