#include "render_gl/world/face_programs.h"

#include <algorithm>
#include <string>

#include "render_gl/gl/projection.h"
#include "render_gl/lit/light_texel.h"
#include "render_gl/lit/lit_shaders.h"
#include "render_gl/styles/style_shaders.h"
#include "render_gl/vertex_light/vertex_shaders.h"
#include "render_gl/world/block_shaders.h"
#include "render_gl/world/face_vertex_part.h"
#include "render_gl/world/world_shaders.h"

namespace temblor::render_gl {

namespace {

// The names of kinds in kWorldFragmentShader, by FaceProgramKind.
constexpr std::array<const char*, kFaceProgramKinds> kKindNames = {"kBlock", "kBlock",  "kRepeat", "kLiquid",
                                                                   "kSky",   "kSkybox", "kLit",    "kLit"};

// The definitions of a pass for kLitColorPart and the shaders that follow it; kWhole: nothing.
constexpr std::array<const char*, kLitPassKinds> kPassNames = {
    "", "#define TEXTURE_PASS\n", "#define LIGHT_PASS\n", "#define BRIGHT_PASS\n", "#define FOG_PASS\n", ""};

// Fragment shaders' find_light(). Other kinds do not call it.
const char* find_light_part(FaceProgramKind kind, WorldMethod method) {
  if (is_lit(kind) && method == WorldMethod::kGouraud) return kVertexLightPart;
  return is_lit(kind) && method == WorldMethod::kStyleLayers ? kStyleLightPart : kGridLightPart;
}

bool has_lit_faces(WorldMethod method) {
  using enum WorldMethod;
  return method != kBlocks && method != kExpandedBlocks && method != kCardBlocks;
}

}  // namespace

StyleUniforms::StyleUniforms(const Functions& gl, const Program& program) {
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program.name(), name); };
  samples = find("style_samples");
  faces = find("style_faces");
  values = find("style_values");
  is_colored = find("has_colored_light");
  lights = find("dynamic_lights");
  light_count = find("light_count");
}

FaceProgram::FaceProgram(const Functions& gl, Program linked)
    : program(std::move(linked)), styles(gl, program), index(gl, program) {
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
  vertex_lights = find("vertex_lights");
  first_light = find("first_light");
  has_color_key = find("has_color_key");
  skybox = find("skybox");
  liquid_phase = find("liquid_phase");
  sky_scroll = find("sky_scroll");
  fog_density = find("fog_density");
  fog_color = find("fog_color");
  gl.UseProgram(program.name());
  gl.Uniform1i(records, face_units::kRecords);
  gl.Uniform1i(atlas, face_units::kAtlas);
  gl.Uniform1i(skybox, face_units::kSkybox);
  gl.Uniform1i(textures, face_units::kTextures);
  gl.Uniform1i(light_grids, face_units::kLightGrids);
  gl.Uniform1i(vertex_lights, face_units::kVertexLights);
  gl.Uniform1i(styles.samples, face_units::kSamples);
  gl.Uniform1i(styles.faces, face_units::kFaces);
  gl.Uniform1i(styles.lights, face_units::kLights);
}

// Several passes are for opaque faces only, and kOneLit is, too.
bool FacePrograms::is_needed(const Variant& variant, const DrawOptions& options) {
  using enum FaceProgramKind;
  if (!is_lit(variant.kind))
    return variant.pass == LitPassKind::kWhole &&
           (variant.kind != kOneBlock || options.filter == render::TextureFilter::kNearest);
  if (!has_lit_faces(options.method)) return false;
  if (variant.pass == LitPassKind::kWhole && variant.kind == kLit) return true;
  return (variant.pass == LitPassKind::kWhole || !variant.has_fog) &&
         std::ranges::any_of(find_lit_passes(options.method), [&](const LitPass& pass) {
           return pass.kind == variant.pass && pass.kind != LitPassKind::kPolygons;
         });
}

base::Result<Program> FacePrograms::make_program(const Functions& gl, const Variant& variant,
                                                 const DrawOptions& options, ShaderLook look) {
  using enum FaceProgramKind;
  const FaceProgramKind kind = variant.kind;
  std::string vertex = std::string(kProjectionPart) + kFaceVertexPart, fragment = look_part(look);
  // Passes meet where depth is equal, to the last bit.
  if (variant.pass != LitPassKind::kWhole) vertex = "invariant gl_Position;\n" + vertex;
  if (variant.has_fog || variant.pass == LitPassKind::kFog) fragment += "#define FOG\n";
  fragment += kPassNames[static_cast<std::size_t>(variant.pass)];
  fragment += std::string("#define KIND ") + kKindNames[static_cast<std::size_t>(kind)] + "\n";
  fragment += "#define FILTER " + std::to_string(static_cast<int>(options.filter)) + "\n";
  if (options.sharp_texels) fragment += "#define SHARP\n";
  if (kind == kOneLit) vertex += kLitTilePart;
  if (is_lit(kind) && options.method == WorldMethod::kGouraud)
    vertex += std::string(kLightScalePart) + kLightVertexPart;
  vertex += kind == kOneBlock ? kBlockVertexShader : kind == kOneLit ? kLitVertexShader : kWorldVertexShader;
  fragment +=
      std::string(kLightScalePart) + kLitTilePart + find_light_part(kind, options.method) + kLitColorPart;
  fragment += kind == kOneBlock ? kBlockFragmentShader
              : kind == kOneLit ? kLitFragmentShader
                                : kWorldFragmentShader;
  return render_gl::make_program(gl, vertex.c_str(), fragment.c_str());
}

base::Result<FacePrograms::Programs> FacePrograms::make_programs(const Functions& gl,
                                                                 const DrawOptions& options,
                                                                 ShaderLook look) {
  Programs made;
  for (std::size_t pass = 0; pass < kLitPassKinds; ++pass)
    for (std::size_t kind = 0; kind < kFaceProgramKinds; ++kind)
      for (const bool has_fog : {false, true}) {
        const Variant variant{static_cast<FaceProgramKind>(kind), has_fog, static_cast<LitPassKind>(pass)};
        made.emplace_back();
        if (!is_needed(variant, options)) continue;
        TRY(Program program, make_program(gl, variant, options, look));
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
