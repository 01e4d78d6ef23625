#include "render_gl/surfaces/block_record.h"

#include <cmath>

#include "render/edges/face_outlines.h"

namespace temblor::render_gl {

void set_image(TileKind kind, const StoredImage& image, TileRecord& out_record) {
  const render::SurfaceShape shape = image.shape;
  out_record.place = pack_halves(image.place.x, image.place.y);
  out_record.size =
      pack_halves(static_cast<std::uint32_t>(shape.width), static_cast<std::uint32_t>(shape.height));
  out_record.flags = std::uint32_t{image.place.layer} | static_cast<std::uint32_t>(kind) << 16 | 0xff000000u;
}

TileRecord make_block_record(const StoredImage& stored, const TileBlock& block) {
  TileRecord record;
  set_image(TileKind::kBlock, stored, record);
  record.origin_s = -static_cast<float>(block.tile_s * render::kTileTexels);
  record.origin_t = -static_cast<float>(block.tile_t * render::kTileTexels);
  record.scale_s = static_cast<float>(stored.shape.width / std::ldexp(block.shape.width, block.mip));
  record.scale_t = static_cast<float>(stored.shape.height / std::ldexp(block.shape.height, block.mip));
  return record;
}

}  // namespace temblor::render_gl
