// The programs that draw faces: one for each way in which a face gets its texels, without and with fog.
// Drivers in software (llvmpipe) run all branches of a shader for every pixel, so each program has only what
// its faces need.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "render_gl/draw_options.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

// In the order in which opaque faces are drawn. kOneBlock: faces that show one surface block, without holes.
// kBlocks: those that may have holes, several tiles, or hidden ones. kOneLit and kLit: the same for tiles
// that show a texture times its light.
enum class FaceProgramKind : std::uint8_t {
  kOneBlock,
  kBlocks,
  kTexture,
  kLiquid,
  kSky,
  kSkybox,
  kOneLit,
  kLit
};
constexpr std::size_t kFaceProgramKinds = 8;

// A program, and the locations of its variables; -1 for those that it lacks.
struct FaceProgram {
  FaceProgram(const Functions& gl, Program linked);
  Program program;
  GLint model_axes, model_origin, first_record, eye, view_axes, projection, full_range;
  GLint records, atlas, textures, light_grids, has_color_key, skybox, liquid_phase, sky_scroll, fog_density,
      fog_color;
};

class FacePrograms {
 public:
  // Those that the options need. Fails as make_program() does.
  static base::Result<FacePrograms> make(const Functions& gl, const DrawOptions& options);

  const FaceProgram& get(FaceProgramKind kind, bool has_fog) const {
    return *programs_[static_cast<std::size_t>(kind) * 2 + has_fog];
  }

 private:
  FacePrograms() = default;
  std::vector<std::optional<FaceProgram>> programs_;  // by kind, without and with fog
};

}  // namespace temblor::render_gl
