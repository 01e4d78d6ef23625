#include "render_gl/world/tile_images.h"

#include <cmath>

#include "render/color/blend_tables.h"
#include "render/color/warped_rows.h"
#include "render_gl/surfaces/block_record.h"

namespace temblor::render_gl {

namespace {

using render::SurfaceDraw;
using render::SurfaceKind;

// Addresses are below 2^63, so textures are numbered from there.
enum class TexturePart : std::uint64_t { kWhole, kClouds, kBackground };
AtlasKey texture_key(const SurfaceDraw& draw, TexturePart part) {
  const auto texture = static_cast<std::uint64_t>(draw.texture_index);
  const auto mip = static_cast<std::uint64_t>(draw.mip + 8);
  return std::uint64_t{1} << 63 | texture << 24 | mip << 16 | std::uint64_t{draw.light_row} << 8 |
         static_cast<std::uint64_t>(part);
}

// `size` is the image's own, in texels of which the record's scale counts the stored ones.
void set_scale(std::int32_t stored, double size, float& out_scale) {
  out_scale = static_cast<float>(stored / size);
}

// Moves texture coordinates from the face's first texel to where a repeating texture begins; a liquid also
// to where its waves do.
float repeat_origin(std::int32_t first, std::uint32_t texels) {
  const std::int64_t period = std::int64_t{texels} * static_cast<std::int64_t>(render::kTurn_texels);
  return static_cast<float>(first % period);
}

std::optional<TileRecord> place_block(const Functions& gl, const SurfaceDraw& draw, std::uint32_t tile,
                                      render::TileGrid tiles, BlockAtlas& io_atlas) {
  const render::SurfaceShape shape = draw.block.shape;
  const auto stored = io_atlas.place(gl, {block_key(draw.block), draw.block.texels, shape});
  if (!stored) return std::nullopt;
  return make_block_record(*stored, {shape, draw.mip, tile % tiles.s, tile / tiles.s});
}

std::optional<TileRecord> place_sky(const Functions& gl, const SurfaceDraw& draw, const render::SkySpans& sky,
                                    BlockAtlas& io_atlas) {
  const render::SurfaceShape shape{sky.width, sky.height};
  const auto clouds = io_atlas.place(gl, {texture_key(draw, TexturePart::kClouds), sky.clouds, shape});
  const auto back = io_atlas.place(gl, {texture_key(draw, TexturePart::kBackground), sky.back, shape});
  if (!clouds || !back) return std::nullopt;
  TileRecord record;
  set_image(TileKind::kSky, *clouds, record);
  record.second_place = back->place.x / 8u | back->place.y / 8u << 8 | std::uint32_t{back->place.layer} << 16;
  return record;
}

std::optional<TileRecord> place_texture(const Functions& gl, const SurfaceDraw& draw,
                                        const render::RepeatSpans& repeat, const world::Face& face,
                                        BlockAtlas& io_atlas) {
  const auto stored = io_atlas.place(
      gl, {texture_key(draw, TexturePart::kWhole), repeat.texels, {repeat.width, repeat.height}});
  if (!stored) return std::nullopt;
  TileRecord record;
  set_image(draw.kind == SurfaceKind::kLiquid ? TileKind::kLiquid : TileKind::kRepeat, *stored, record);
  record.origin_s = repeat_origin(face.texture_mins[0], draw.texture->width);
  record.origin_t = repeat_origin(face.texture_mins[1], draw.texture->height);
  set_scale(stored->shape.width, draw.texture->width, record.scale_s);
  set_scale(stored->shape.height, draw.texture->height, record.scale_t);
  return record;
}

}  // namespace

AtlasKey block_key(const render::SurfaceBlock& block) {
  return reinterpret_cast<std::uintptr_t>(block.texels);
}

void set_opacity(const render::FrameContext& context, const render::FaceOpacity& opacity,
                 TileRecord& io_record) {
  const auto alpha = static_cast<std::uint32_t>(std::lround(opacity.opacity * 255.0f));
  io_record.flags = (io_record.flags & 0x00ffffffu) | alpha << 24;
  if (opacity.has_holes) io_record.flags |= kHasHoles;
  if (opacity.is_additive) io_record.flags |= kHasNoFog;
  if (opacity.color) {
    io_record.flags |= kHasColor;
    io_record.second_place = context.is_indexed() ? context.colors.match(*opacity.color, true)
                                                  : render::to_rgb(*opacity.color) & 0xffffffu;
  }
}

std::optional<TileRecord> place_tile(const Functions& gl, const FrameInput& input, std::uint32_t number,
                                     BlockAtlas& io_atlas) {
  const SurfaceDraw& draw = input.record.surfaces.draws.all[number];
  const render::ScreenSurface& surface = input.record.edges.surfaces[base::to_size(draw.surface)];
  if (draw.kind == SurfaceKind::kBlock)
    return place_block(gl, draw, number - surface.first_draw, surface.tiles, io_atlas);
  if (draw.kind != SurfaceKind::kSky)
    return place_texture(gl, draw, *input.sources.repeating[number], input.context.level().face(surface.face),
                         io_atlas);
  if (!input.sources.skybox) return place_sky(gl, draw, *input.sources.skies[number], io_atlas);
  TileRecord record;
  const std::int32_t size = input.sources.skybox->size;
  set_image(TileKind::kSkybox, {{}, {size, size}}, record);
  return record;
}

}  // namespace temblor::render_gl
