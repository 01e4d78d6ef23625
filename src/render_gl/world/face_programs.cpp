#include "render_gl/world/face_programs.h"

#include <string>

#include "render_gl/gl/projection.h"
#include "render_gl/world/block_shaders.h"
#include "render_gl/world/world_shaders.h"

namespace temblor::render_gl {

namespace {

// The names of kinds in kWorldFragmentShader, by FaceProgramKind.
constexpr std::array<const char*, kFaceProgramKinds> kKindNames = {"kBlock",  "kBlock", "kRepeat",
                                                                   "kLiquid", "kSky",   "kSkybox"};

base::Result<Program> make_face_program(const Functions& gl, FaceProgramKind kind, bool has_fog) {
  const bool is_one_block = kind == FaceProgramKind::kOneBlock;
  const std::string vertex =
      std::string(kProjectionPart) + (is_one_block ? kBlockVertexShader : kWorldVertexShader);
  const std::string defined = std::string(has_fog ? "#define FOG\n" : "") + "#define KIND " +
                              kKindNames[static_cast<std::size_t>(kind)] + "\n";
  const std::string fragment = defined + (is_one_block ? kBlockFragmentShader : kWorldFragmentShader);
  return make_program(gl, vertex.c_str(), fragment.c_str());
}

}  // namespace

FaceProgram::FaceProgram(const Functions& gl, Program linked) : program(std::move(linked)) {
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program.name(), name); };
  model_axes = find("model_axes");
  model_origin = find("model_origin");
  first_record = find("first_record");
  eye = find("eye");
  view_axes = find("view_axes");
  projection = find("projection");
  full_range = find("full_range");
  records = find("records");
  atlas = find("atlas");
  has_color_key = find("has_color_key");
  skybox = find("skybox");
  liquid_phase = find("liquid_phase");
  sky_scroll = find("sky_scroll");
  fog_density = find("fog_density");
  fog_color = find("fog_color");
}

base::Result<FacePrograms> FacePrograms::make(const Functions& gl) {
  FacePrograms made;
  for (std::size_t kind = 0; kind < kFaceProgramKinds; ++kind)
    for (const bool has_fog : {false, true}) {
      TRY(Program program, make_face_program(gl, static_cast<FaceProgramKind>(kind), has_fog));
      made.programs_.emplace_back(gl, std::move(program));
    }
  return made;
}

}  // namespace temblor::render_gl
