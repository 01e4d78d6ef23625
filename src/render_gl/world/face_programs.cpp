#include "render_gl/world/face_programs.h"

#include <string>

#include "render_gl/gl/projection.h"
#include "render_gl/lit/lit_shaders.h"
#include "render_gl/world/block_shaders.h"
#include "render_gl/world/face_vertex_part.h"
#include "render_gl/world/world_shaders.h"

namespace temblor::render_gl {

namespace {

// The names of kinds in kWorldFragmentShader, by FaceProgramKind.
constexpr std::array<const char*, kFaceProgramKinds> kKindNames = {"kBlock", "kBlock",  "kRepeat", "kLiquid",
                                                                   "kSky",   "kSkybox", "kLit",    "kLit"};

bool is_needed(FaceProgramKind kind, const DrawOptions& options) {
  if (kind == FaceProgramKind::kOneLit || kind == FaceProgramKind::kLit)
    return options.method == WorldMethod::kLitTextures;
  return kind != FaceProgramKind::kOneBlock || options.filter == render::TextureFilter::kNearest;
}

base::Result<Program> make_face_program(const Functions& gl, FaceProgramKind kind, bool has_fog,
                                        const DrawOptions& options, ShaderLook look) {
  using enum FaceProgramKind;
  std::string vertex = std::string(kProjectionPart) + kFaceVertexPart, fragment = look_part(look);
  if (has_fog) fragment += "#define FOG\n";
  fragment += std::string("#define KIND ") + kKindNames[static_cast<std::size_t>(kind)] + "\n";
  fragment += "#define FILTER " + std::to_string(static_cast<int>(options.filter)) + "\n";
  if (options.sharp_texels) fragment += "#define SHARP\n";
  if (kind == kOneLit) vertex += kLitTilePart;
  vertex += kind == kOneBlock ? kBlockVertexShader : kind == kOneLit ? kLitVertexShader : kWorldVertexShader;
  fragment += std::string(kLitTilePart) + kLitColorPart;
  fragment += kind == kOneBlock ? kBlockFragmentShader
              : kind == kOneLit ? kLitFragmentShader
                                : kWorldFragmentShader;
  return make_program(gl, vertex.c_str(), fragment.c_str());
}

}  // namespace

FaceProgram::FaceProgram(const Functions& gl, Program linked)
    : program(std::move(linked)), index(gl, program) {
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program.name(), name); };
  model_axes = find("model_axes");
  model_origin = find("model_origin");
  nearer = find("nearer");
  first_record = find("first_record");
  eye = find("eye");
  view_axes = find("view_axes");
  projection = find("projection");
  full_range = find("full_range");
  records = find("records");
  atlas = find("atlas");
  textures = find("textures");
  light_grids = find("light_grids");
  has_color_key = find("has_color_key");
  skybox = find("skybox");
  liquid_phase = find("liquid_phase");
  sky_scroll = find("sky_scroll");
  fog_density = find("fog_density");
  fog_color = find("fog_color");
}

base::Result<FacePrograms::Programs> FacePrograms::make_programs(const Functions& gl,
                                                                 const DrawOptions& options,
                                                                 ShaderLook look) {
  Programs made;
  for (std::size_t number = 0; number < kFaceProgramKinds; ++number)
    for (const bool has_fog : {false, true}) {
      const auto kind = static_cast<FaceProgramKind>(number);
      made.emplace_back();
      if (!is_needed(kind, options)) continue;
      TRY(Program program, make_face_program(gl, kind, has_fog, options, look));
      made.back().emplace(gl, std::move(program));
    }
  return made;
}

base::Result<FacePrograms> FacePrograms::make(const Functions& gl, const DrawOptions& options,
                                              render::PixelFormat format) {
  FacePrograms made;
  TRY(made.programs_, make_programs(gl, options, find_look(format)));
  if (format == render::PixelFormat::kIndexed) {
    TRY(made.blended_, make_programs(gl, options, ShaderLook::kBlendedIndices));
  }
  return made;
}

}  // namespace temblor::render_gl
