#include "render_gl/lit/grid_method.h"

namespace temblor::render_gl {

base::Result<std::unique_ptr<LitMethod>> GridMethod::make(const Functions& gl) {
  TRY(LightGrids light, LightGrids::make(gl));
  return std::unique_ptr<LitMethod>(new GridMethod(std::move(light)));
}

base::Status GridMethod::set_level(const Functions& gl, const render::FrameContext& context) {
  light_.clear();
  return LitMethod::set_level(gl, context);
}

std::optional<TileRecord> GridMethod::place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                            BlockAtlas&) {
  const world::Level& level = input.context.level();
  const auto grid = light_.place(gl, level, tiles_.request(draw));
  if (!grid) return std::nullopt;
  TileRecord record = tiles_.make_record(level, draw, grid->texels_power);
  record.place = pack_halves(grid->place.x, grid->place.y);
  record.flags |= std::uint32_t{grid->place.layer};
  return record;
}

void GridMethod::use(const Functions& gl, const FaceProgram& program, const LitLook& look) const {
  LitMethod::use(gl, program, look);
  gl.ActiveTexture(GL_TEXTURE0 + face_units::kLightGrids);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, light_.texture());
}

}  // namespace temblor::render_gl
