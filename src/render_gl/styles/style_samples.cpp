#include "render_gl/styles/style_samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "render/surfaces/light/face_lights.h"
#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// These two are in the shader, too.
constexpr std::size_t kSamplesPerRow = 2048, kFacesPerRow = 400;
constexpr std::size_t kTexelsPerFace = 5;

using FaceTexel = std::array<std::uint32_t, 4>;

FaceTexel make_texel(const math::Vec3d& axis, double offset) {
  const auto bits = [](double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); };
  return {bits(axis.x), bits(axis.y), bits(axis.z), bits(offset)};
}

// The face's light map, and its plane in model space.
std::array<FaceTexel, kTexelsPerFace> describe_face(const world::Level& level, const world::Face& face) {
  const render::FacePlacement placed = render::place_face(level, face, render::ModelView{});
  std::uint32_t styles = 0;
  for (std::size_t i = 0; i < face.style_count; ++i) styles |= std::uint32_t{face.styles[i]} << 8 * i;
  // A light at the plane reaches it, and has the units of its texels.
  const auto probe = render::light_on_face(
      {.origin_world = math::Vec3(placed.normal * placed.distance), .radius = render::kMaxLight}, placed,
      false);
  return {FaceTexel{face.light,
                    static_cast<std::uint32_t>(face.light_width()) |
                        static_cast<std::uint32_t>(face.light_height()) << 16,
                    styles, face.style_count},
          make_texel(placed.normal, placed.distance), make_texel(placed.s_axis, placed.s_offset),
          make_texel(placed.t_axis, placed.t_offset),
          make_texel({probe ? probe->units_per_s : 0, probe ? probe->units_per_t : 0, 0}, 0)};
}

std::uint32_t pack_stored(const world::Level& level, std::size_t sample) {
  const std::uint32_t gray = level.light[sample];
  if (level.light_rgb.empty()) return gray * 0x01010101u;
  const std::uint8_t* const rgb = &level.light_rgb[sample * 3];
  return std::uint32_t{rgb[2]} | std::uint32_t{rgb[1]} << 8 | std::uint32_t{rgb[0]} << 16 | gray << 24;
}

// Rows that hold `count` things, as far as the card allows.
std::size_t count_rows(const Functions& gl, std::size_t count, std::size_t per_row) {
  const auto limit = static_cast<std::size_t>(find_texture_limits(gl).side);
  return std::clamp((count + per_row - 1) / per_row, std::size_t{1}, limit);
}

}  // namespace

bool StyleSamples::contains(const world::Face& face, std::size_t number) const {
  const std::size_t samples = static_cast<std::size_t>(face.light_width()) *
                              static_cast<std::size_t>(face.light_height()) * face.style_count;
  return number < face_count_ && (face.style_count == 0 || (face.light_map_grid == world::kStockGrid &&
                                                            face.light + samples <= sample_count_));
}

base::Status StyleSamples::upload_samples(const Functions& gl, const world::Level& level) {
  const std::size_t rows = count_rows(gl, level.light.size(), kSamplesPerRow);
  TRY(samples_, make_texture(gl, GL_RGBA8, {static_cast<int>(kSamplesPerRow), static_cast<int>(rows)}));
  sample_count_ = std::min(level.light.size(), rows * kSamplesPerRow);
  bytes_ += rows * kSamplesPerRow * sizeof(std::uint32_t);
  std::vector<std::uint32_t> texels(kSamplesPerRow);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < kSamplesPerRow; ++i) {
      const std::size_t sample = row * kSamplesPerRow + i;
      texels[i] = sample < sample_count_ ? pack_stored(level, sample) : 0;
    }
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(kSamplesPerRow), 1,
                     GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
  return base::Ok{};
}

base::Status StyleSamples::upload_faces(const Functions& gl, const world::Level& level) {
  constexpr std::size_t kTexelsPerRow = kFacesPerRow * kTexelsPerFace;
  const std::size_t rows = count_rows(gl, level.faces.size(), kFacesPerRow);
  TRY(faces_, make_texture(gl, GL_RGBA32UI, {static_cast<int>(kTexelsPerRow), static_cast<int>(rows)}));
  face_count_ = std::min(level.faces.size(), rows * kFacesPerRow);
  bytes_ += rows * kTexelsPerRow * sizeof(FaceTexel);
  std::vector<FaceTexel> texels(kTexelsPerRow);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < kFacesPerRow && row * kFacesPerRow + i < face_count_; ++i)
      std::ranges::copy(describe_face(level, level.faces[row * kFacesPerRow + i]),
                        &texels[i * kTexelsPerFace]);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(kTexelsPerRow), 1,
                     GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
  }
  return base::Ok{};
}

base::Result<StyleSamples> StyleSamples::make(const Functions& gl, const world::Level& level) {
  StyleSamples made;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  TRY_STATUS(made.upload_samples(gl, level));
  TRY_STATUS(made.upload_faces(gl, level));
  TRY_STATUS(gl.check("loading the level's light"));
  return made;
}

}  // namespace temblor::render_gl
