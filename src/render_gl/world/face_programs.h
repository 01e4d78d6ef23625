// The programs that draw faces: one for each way in which a face gets its texels, without and with fog, and
// for indexed frames once more for translucent faces.
// Drivers in software (llvmpipe) run all branches of a shader for every pixel, so each program has only what
// its faces need.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "render_gl/draw_options.h"
#include "render_gl/frame/index_tables.h"
#include "render_gl/gl/objects.h"
#include "render_gl/gl/shader_look.h"
#include "render_gl/passes/lit_passes.h"

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

constexpr bool is_lit(FaceProgramKind kind) {
  return kind == FaceProgramKind::kOneLit || kind == FaceProgramKind::kLit;
}
// The kind for faces of several tiles that shows the same.
constexpr FaceProgramKind without_one_tile(FaceProgramKind kind) {
  if (kind == FaceProgramKind::kOneBlock) return FaceProgramKind::kBlocks;
  return kind == FaceProgramKind::kOneLit ? FaceProgramKind::kLit : kind;
}

// The units of the card that the programs' textures are bound to. Samplers of different types must never
// share one, whether they are used or not. IndexTables has those from 8 on.
namespace face_units {
constexpr GLint kRecords = 0, kAtlas = 1, kSkybox = 2, kTextures = 3, kLightGrids = 4, kVertexLights = 5,
                kSamples = 6, kFaces = 7, kLights = 12;
}  // namespace face_units

// Locations of the variables of kStyleLightPart; -1 for those that a program lacks.
struct StyleUniforms {
  StyleUniforms(const Functions& gl, const Program& program);
  GLint samples, faces, values, is_colored, lights, light_count;
};

// A program, and the locations of its variables; -1 for those that it lacks.
struct FaceProgram {
  FaceProgram(const Functions& gl, Program linked);
  Program program;
  GLint model_axes, model_origin, nearer, first_record, eye, view_axes, projection, full_range;
  GLint vertex_lights, first_light;
  StyleUniforms styles;
  GLint records, atlas, textures, light_grids, has_color_key, skybox, liquid_phase, sky_scroll, fog_density,
      fog_color;
  IndexUniforms index;
};

class FacePrograms {
 public:
  // Those that the options need. Fails as make_program() does.
  static base::Result<FacePrograms> make(const Functions& gl, const DrawOptions& options,
                                         render::PixelFormat format);

  // `is_translucent`: never kOneBlock and kOneLit. `pass`: one of the method's; kWhole if the kind is not
  // lit, or is_translucent.
  const FaceProgram& get(FaceProgramKind kind, bool has_fog, bool is_translucent, LitPassKind pass) const {
    const Programs& programs = is_translucent && !blended_.empty() ? blended_ : programs_;
    return *programs[find_number({kind, pass == LitPassKind::kWhole ? has_fog : false, pass})];
  }

 private:
  FacePrograms() = default;
  // All that distinguishes the programs of one look.
  struct Variant {
    FaceProgramKind kind;
    bool has_fog;  // kWhole only: LitPassKind::kFog draws nothing else
    LitPassKind pass;
  };
  static std::size_t find_number(const Variant& variant) {
    return (static_cast<std::size_t>(variant.pass) * kFaceProgramKinds +
            static_cast<std::size_t>(variant.kind)) *
               2 +
           variant.has_fog;
  }
  using Programs = std::vector<std::optional<FaceProgram>>;  // by find_number()
  static bool is_needed(const Variant& variant, const DrawOptions& options);
  static base::Result<Program> make_program(const Functions& gl, const Variant& variant,
                                            const DrawOptions& options, ShaderLook look);
  static base::Result<Programs> make_programs(const Functions& gl, const DrawOptions& options,
                                              ShaderLook look);

  Programs programs_;
  Programs blended_;  // for translucent faces of indexed frames
};

}  // namespace temblor::render_gl
