#include "render_gl/built/card_blocks.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <string>
#include <tuple>

#include "base/hash.h"
#include "render_gl/lit/light_texel.h"
#include "render_gl/lit/lit_shaders.h"
#include "render_gl/surfaces/block_record.h"

namespace temblor::render_gl {

namespace {

constexpr GLenum kTexturesUnit = 3, kLightUnit = 4;

// One block per instance, as a strip of two triangles.
constexpr const char* kBuildVertexShader = R"(
layout(location = 0) in uvec4 lit;
layout(location = 1) in uvec3 stored;  // mapping.w of the tile; x | y << 16; width | height << 16

uniform float side;  // texels of a layer

flat out vec4 texels;   // LitTile: last, first
flat out vec4 light;    // light_first, light_layer, samples_per_texel
flat out vec4 picture;  // texture_layer, level; the block's texels per stored texel
flat out vec2 begin;    // of the block in the atlas

void main() {
  LitTile tile = read_lit_tile(lit, vec4(0, 0, 0, uintBitsToFloat(stored.x)));
  vec2 size = vec2(stored.z & 0xffffu, stored.z >> 16);
  begin = vec2(stored.y & 0xffffu, stored.y >> 16);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4((begin + corner * size) / side * 2.0 - 1.0, 0.0, 1.0);
  texels = vec4(tile.last, tile.first);
  light = vec4(tile.light_first, tile.light_layer, tile.samples_per_texel);
  picture = vec4(tile.texture_layer, tile.level, (tile.last + 1.0) / size);
}
)";

constexpr const char* kBuildFragmentShader = R"(
flat in vec4 texels;
flat in vec4 light;
flat in vec4 picture;
flat in vec2 begin;
out vec4 color;

void main() {
  LitTile tile = LitTile(texels.xy, texels.zw, light.xy, light.z, picture.x, picture.y, light.w);
  vec2 at = floor(gl_FragCoord.xy - begin) * picture.zw + 0.25;
  color = round_color(vec4(find_lit_color(tile, at, vec2(0), vec2(0)), 1.0));
}
)";

// Addresses of the CPU's blocks are below 2^62, and keys of textures below 3 * 2^62.
AtlasKey card_block_key(const world::Level& level, const render::BlockRequest& request) {
  AtlasKey key = LightGrids::find_key(level, request);
  key = base::hash_with(key, base::to_size(request.contents.texture));
  key = base::hash_with(key, static_cast<std::uint64_t>(request.mip + 8));
  return key | std::uint64_t{3} << 62;
}

}  // namespace

CardBlocks::CardBlocks(LightGrids light, Program program, AtlasPainter painter)
    : GridMethod(std::move(light)), program_(std::move(program)), painter_(std::move(painter)) {}

base::Result<std::unique_ptr<LitMethod>> CardBlocks::make(const Functions& gl, const BlockAtlas& atlas) {
  const std::string vertex = std::string(kLitTilePart) + kBuildVertexShader;
  std::string fragment = "#define FILTER 0\n";
  for (const char* part :
       {kLightScalePart, kLitTilePart, kGridLightPart, kLitColorPart, kAtlasColorPart, kBuildFragmentShader})
    fragment += part;
  TRY(Program program, make_program(gl, vertex.c_str(), fragment.c_str()));
  TRY(AtlasPainter painter, AtlasPainter::make(gl, atlas));
  TRY(LightGrids light, LightGrids::make(gl));
  return std::unique_ptr<LitMethod>(new CardBlocks(std::move(light), std::move(program), std::move(painter)));
}

// A block that is there needs no light, so its grid may make room for others. A new one asks for its light
// first: room in the atlas without it would stay empty.
std::optional<TileRecord> CardBlocks::place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                            BlockAtlas& io_atlas) {
  const world::Level& level = input.context.level();
  const render::BlockRequest& request = tiles_.request(draw);
  const render::SurfaceShape shape =
      render::surface_shape(level.face(request.face), request.tile_s, request.tile_t, request.mip);
  const TileBlock block{shape, request.mip, request.tile_s, request.tile_t};
  const AtlasKey key = card_block_key(level, request);
  if (const auto stored = io_atlas.reuse(key)) return make_block_record(*stored, block);
  const auto lit = GridMethod::place(gl, input, draw, io_atlas);
  if (!lit) return std::nullopt;
  const auto stored = io_atlas.reserve(key, shape);
  if (!stored) return std::nullopt;
  const TileRecord record = make_block_record(*stored, block);
  jobs_.push_back({stored->place.layer,
                   tiles_.array(draw),
                   {lit->place, lit->size, lit->flags, lit->second_place},
                   std::bit_cast<std::uint32_t>(lit->scale_t),
                   record.place,
                   record.size});
  return record;
}

void CardBlocks::bind(const Functions& gl, const BlockAtlas& atlas) const {
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program_.name(), name); };
  gl.UseProgram(program_.name());
  gl.Uniform1i(find("textures"), kTexturesUnit);
  gl.Uniform1i(find("light_grids"), kLightUnit);
  gl.Uniform1i(find("has_color_key"), atlas.format() == TexelFormat::k16Bit);
  gl.Uniform1f(find("side"), static_cast<float>(atlas.side()));
  gl.ActiveTexture(GL_TEXTURE0 + kLightUnit);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, light_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + kTexturesUnit);
}

// One call for all blocks of a layer with textures of one array.
void CardBlocks::end_portion(const Functions& gl, const FrameInput&, const BlockAtlas& atlas) {
  if (jobs_.empty()) return;
  const auto group = [](const Job& job) { return std::tuple(job.layer, job.array); };
  std::ranges::stable_sort(jobs_, {}, group);
  bind(gl, atlas);
  painter_.begin(gl, atlas, jobs_.data(), jobs_.size(), sizeof(Job));
  for (std::size_t begin = 0, end = 0; begin < jobs_.size(); begin = end) {
    while (end < jobs_.size() && group(jobs_[end]) == group(jobs_[begin])) ++end;
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, tiles_.array_texture(jobs_[begin].array));
    painter_.draw(gl, atlas, {begin, end - begin, sizeof(Job), jobs_[begin].layer},
                  {{0, 4, offsetof(Job, lit)}, {1, 3, offsetof(Job, mapping)}});
  }
  painter_.end(gl);
  jobs_.clear();
}

}  // namespace temblor::render_gl
