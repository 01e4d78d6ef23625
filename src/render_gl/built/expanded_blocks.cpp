#include "render_gl/built/expanded_blocks.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "render_gl/surfaces/block_record.h"
#include "render_gl/world/tile_images.h"

namespace temblor::render_gl {

namespace {

// Two layers: what a portion uploads. A frame that uploads more has several.
constexpr CacheOptions kStaging{.bytes = std::size_t{8} << 20, .format = TexelFormat::k8Bit};
constexpr int kPaletteColors = 256;

// One block per instance, as a strip of two triangles.
constexpr const char* kExpandVertexShader = R"(
layout(location = 0) in uvec3 staged;  // x | y << 16; width | height << 16; layer | has holes << 16
layout(location = 1) in uvec2 stored;  // x | y << 16; width | height << 16

uniform float side;  // texels of a layer

flat out vec3 first;   // staged texel, and its layer
flat out uint has_holes;
flat out vec4 picture;  // the block's begin in the atlas; staged texels for each texel there

vec2 unpack(uint two) { return vec2(two & 0xffffu, two >> 16); }

void main() {
  vec2 begin = unpack(stored.x), size = unpack(stored.y);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4((begin + corner * size) / side * 2.0 - 1.0, 0.0, 1.0);
  first = vec3(unpack(staged.x), staged.z & 0xffffu);
  has_holes = staged.z >> 16;
  picture = vec4(begin, unpack(staged.y) / size);
}
)";

constexpr const char* kExpandFragmentShader = R"(
uniform sampler2DArray staging;
uniform sampler2D palette;

flat in vec3 first;
flat in uint has_holes;
flat in vec4 picture;
out vec4 color;

void main() {
  vec2 at = first.xy + floor(gl_FragCoord.xy - picture.xy) * picture.zw + 0.25;
  int index = int(texelFetch(staging, ivec3(at, first.z), 0).r * 255.0 + 0.5);
  bool is_clear = has_holes != 0u && index == 255;
  color = round_color(is_clear ? vec4(0) : texelFetch(palette, ivec2(index, 0), 0));
}
)";

}  // namespace

ExpandedBlocks::ExpandedBlocks(Program program, AtlasPainter painter, Texture palette, BlockAtlas staging)
    : program_(std::move(program)),
      painter_(std::move(painter)),
      palette_(std::move(palette)),
      staging_(std::move(staging)) {}

base::Result<std::unique_ptr<LitMethod>> ExpandedBlocks::make(const Functions& gl, const BlockAtlas& atlas) {
  std::string fragment = kAtlasColorPart;
  fragment += kExpandFragmentShader;
  TRY(Program program, make_program(gl, kExpandVertexShader, fragment.c_str()));
  TRY(AtlasPainter painter, AtlasPainter::make(gl, atlas));
  TRY(Texture palette, make_texture(gl, GL_RGBA8, {kPaletteColors, 1}));
  TRY(BlockAtlas staging, BlockAtlas::make(gl, kStaging));
  return std::unique_ptr<LitMethod>(
      new ExpandedBlocks(std::move(program), std::move(painter), std::move(palette), std::move(staging)));
}

// The palette comes with the first level, and stays the same.
base::Status ExpandedBlocks::set_level(const Functions& gl, const render::FrameContext& context) {
  gl.BindTexture(GL_TEXTURE_2D, palette_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kPaletteColors, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                   context.colors.rgb.data());
  return base::Ok{};
}

bool ExpandedBlocks::has_tile(const FrameInput& input, std::uint32_t draw) const {
  return input.record.surfaces.draws.all[draw].kind == render::SurfaceKind::kBlock;
}

void ExpandedBlocks::begin_portion() {
  staging_.clear();
  staging_.begin_portion();
}

std::optional<TileRecord> ExpandedBlocks::place(const Functions& gl, const FrameInput& input,
                                                std::uint32_t draw, BlockAtlas& io_atlas) {
  const render::SurfaceDraw& drawn = input.record.surfaces.draws.all[draw];
  const render::ScreenSurface& surface = input.record.edges.surfaces[base::to_size(drawn.surface)];
  const std::uint32_t tile = draw - surface.first_draw;
  const render::SurfaceShape shape = drawn.block.shape;
  const TileBlock block{shape, drawn.mip, tile % surface.tiles.s, tile / surface.tiles.s};
  const AtlasKey key = block_key(drawn.block);
  if (const auto stored = io_atlas.reuse(key)) return make_block_record(*stored, block);
  const auto staged = staging_.place(gl, {key, drawn.block.texels, shape});
  if (!staged) return std::nullopt;
  const auto stored = io_atlas.reserve(key, shape);
  if (!stored) return std::nullopt;
  const TileRecord record = make_block_record(*stored, block);
  const std::uint32_t has_holes = drawn.texture->kind == world::TextureKind::kCutout;
  jobs_.push_back({stored->place.layer, pack_halves(staged->place.x, staged->place.y),
                   pack_halves(static_cast<std::uint32_t>(staged->shape.width),
                               static_cast<std::uint32_t>(staged->shape.height)),
                   pack_halves(staged->place.layer, has_holes), record.place, record.size});
  return record;
}

// One call for all blocks of a layer.
void ExpandedBlocks::end_portion(const Functions& gl, const FrameInput&, const BlockAtlas& atlas) {
  constexpr GLenum kStagingUnit = 3, kPaletteUnit = 4;
  if (jobs_.empty()) return;
  std::ranges::stable_sort(jobs_, {}, &Job::layer);
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program_.name(), name); };
  gl.UseProgram(program_.name());
  gl.Uniform1i(find("staging"), kStagingUnit);
  gl.Uniform1i(find("palette"), kPaletteUnit);
  gl.Uniform1i(find("has_color_key"), atlas.format() == TexelFormat::k16Bit);
  gl.Uniform1f(find("side"), static_cast<float>(atlas.side()));
  gl.ActiveTexture(GL_TEXTURE0 + kStagingUnit);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, staging_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + kPaletteUnit);
  gl.BindTexture(GL_TEXTURE_2D, palette_.name());
  painter_.begin(gl, atlas, jobs_.data(), jobs_.size(), sizeof(Job));
  for (std::size_t begin = 0, end = 0; begin < jobs_.size(); begin = end) {
    while (end < jobs_.size() && jobs_[end].layer == jobs_[begin].layer) ++end;
    painter_.draw(gl, atlas, {begin, end - begin, sizeof(Job), static_cast<int>(jobs_[begin].layer)},
                  {{0, 3, offsetof(Job, staged)}, {1, 2, offsetof(Job, place)}});
  }
  painter_.end(gl);
  jobs_.clear();
}

CacheCounts ExpandedBlocks::light_counts() const {
  CacheCounts counts = staging_.counts();
  counts.portions = 0;
  return counts;
}

}  // namespace temblor::render_gl
