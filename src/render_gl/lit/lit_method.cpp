#include "render_gl/lit/lit_method.h"

#include "render_gl/built/card_blocks.h"
#include "render_gl/built/expanded_blocks.h"
#include "render_gl/lit/grid_method.h"
#include "render_gl/passes/polygon_method.h"
#include "render_gl/styles/style_method.h"
#include "render_gl/vertex_light/vertex_method.h"

namespace temblor::render_gl {

void LitMethod::set_filter(const Functions& gl, render::TextureFilter filter) {
  filter_ = filter;
  tiles_.set_filter(gl, filter);
}

base::Status LitMethod::set_level(const Functions& gl, const render::FrameContext& context) {
  return tiles_.set_level(gl, context.level(), context.colors);
}

base::Status LitMethod::take(const Functions& gl, const render::FrameContext& context,
                             render::SurfaceRequests& io_requests) {
  const world::Level& level = context.level();
  begin_frame();
  if (level_ != level.identity) {
    level_ = {};
    TRY_STATUS(set_level(gl, context));
    tiles_.set_filter(gl, filter_);
    level_ = level.identity;
  }
  const auto can_light_tile = [&](const render::BlockRequest& request) { return can_light(level, request); };
  take_lights(tiles_.take(level, can_light_tile, io_requests), io_requests.first_deferred);
  return base::Ok{};
}

void LitMethod::use(const Functions& gl, const FaceProgram&, const LitLook& look) const {
  gl.ActiveTexture(GL_TEXTURE0 + face_units::kTextures);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, tiles_.array_texture(look.array));
}

base::Result<std::unique_ptr<LitMethod>> make_lit_method(const Functions& gl, WorldMethod method,
                                                         const BlockAtlas& atlas) {
  switch (method) {
    case WorldMethod::kBlocks:
      return std::unique_ptr<LitMethod>();
    case WorldMethod::kExpandedBlocks:
      return ExpandedBlocks::make(gl, atlas);
    case WorldMethod::kCardBlocks:
      return CardBlocks::make(gl, atlas);
    case WorldMethod::kLitTextures:
    case WorldMethod::kLightPass:
      return GridMethod::make(gl);
    case WorldMethod::kLightPolygons:
      return PolygonMethod::make(gl);
    case WorldMethod::kGouraud:
      return std::unique_ptr<LitMethod>(new VertexMethod);
    case WorldMethod::kStyleLayers:
      return std::unique_ptr<LitMethod>(new StyleMethod);
  }
  return std::unique_ptr<LitMethod>();
}

}  // namespace temblor::render_gl
