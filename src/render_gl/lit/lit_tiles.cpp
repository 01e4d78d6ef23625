#include "render_gl/lit/lit_tiles.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/edges/face_outlines.h"

namespace temblor::render_gl {

namespace {

// Makes other bits those of a normal number: cards may turn smaller ones into 0.
constexpr std::uint32_t kNormalBit = 1u << 30;

std::uint32_t wrap(std::int64_t texel, std::uint32_t size) {
  const std::int64_t period = size;
  return static_cast<std::uint32_t>((texel % period + period) % period);
}

}  // namespace

base::Status LitTiles::set_level(const Functions& gl, const world::Level& level,
                                 const render::ColorTables& colors) {
  textures_ = {};  // before the memory for the next ones is needed
  TRY(textures_, TextureArrays::make(gl, level, colors));
  return base::Ok{};
}

void LitTiles::set_filter(const Functions& gl, render::TextureFilter filter) {
  textures_.set_filter(gl, filter);
}

// All tiles of a face have the same textures and marks, so it never has both kinds.
bool LitTiles::has_texture(const world::Level& level, const render::BlockRequest& request) const {
  return request.marks.empty() && request.contents.light_view != render::LightView::kLightOnly &&
         level.face(request.face).kind != world::FaceKind::kLiquid &&
         textures_.find(request.contents.texture).has_value();
}

std::span<render::BlockRequest> LitTiles::take(const world::Level& level, const CanLight& can_light,
                                               render::SurfaceRequests& io_requests) {
  const auto needs_block = [&](const render::BlockRequest& request) {
    return !has_texture(level, request) || !can_light(request);
  };
  by_draw_.assign(io_requests.draws.size(), nullptr);
  const auto first_lit =
      std::stable_partition(io_requests.blocks.begin(), io_requests.blocks.end(), needs_block);
  const auto blocks = static_cast<std::size_t>(first_lit - io_requests.blocks.begin());
  const std::span<render::BlockRequest> lit = io_requests.blocks.subspan(blocks);
  for (const render::BlockRequest& request : lit) by_draw_[request.draw] = &request;
  io_requests.blocks = io_requests.blocks.first(blocks);
  return lit;
}

TileRecord LitTiles::make_record(const world::Level& level, std::uint32_t draw, int texels_power) const {
  const render::BlockRequest& request = *by_draw_[draw];
  const world::Face& face = level.face(request.face);
  const world::Texture& texture = level.texture(request.contents.texture);
  const TextureArrays::Place texture_place = place(draw);
  const render::SurfaceShape shape = render::surface_shape(face, request.tile_s, request.tile_t, request.mip);
  const std::int32_t tile_s = request.tile_s * render::kTileTexels,
                     tile_t = request.tile_t * render::kTileTexels;
  const auto first = [&](std::int32_t texel, std::uint32_t side) {
    const auto size =
        static_cast<std::uint32_t>(std::max(1, render::at_mip(static_cast<std::int32_t>(side), request.mip)));
    return wrap(render::at_mip(std::int64_t{texel}, request.mip), size);
  };
  const auto level_number = static_cast<std::uint32_t>(
      std::clamp(request.mip - int{texture_place.finest_mip}, 0, int{texture_place.levels} - 1));
  TileRecord record;
  record.size =
      pack_halves(static_cast<std::uint32_t>(shape.width), static_cast<std::uint32_t>(shape.height));
  record.flags = static_cast<std::uint32_t>(TileKind::kLit) << 16 | 0xff000000u;
  record.second_place = pack_halves(first(face.texture_mins[0] + tile_s, texture.width),
                                    first(face.texture_mins[1] + tile_t, texture.height));
  record.origin_s = -static_cast<float>(tile_s);
  record.origin_t = -static_cast<float>(tile_t);
  record.scale_s = std::ldexp(1.0f, -request.mip);
  record.scale_t = std::bit_cast<float>(std::uint32_t{texture_place.layer} | level_number << 16 |
                                        static_cast<std::uint32_t>(texels_power) << 24 | kNormalBit);
  return record;
}

}  // namespace temblor::render_gl
