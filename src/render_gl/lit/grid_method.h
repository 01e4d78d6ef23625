// Texture times light, in one pass (WorldMethod::kLitTextures) or in several ones (kLightPass). The light is
// in grids of samples (LightGrids), which the card interpolates.
#pragma once

#include "render_gl/lit/light_grids.h"
#include "render_gl/lit/lit_method.h"

namespace temblor::render_gl {

class GridMethod : public LitMethod {
 public:
  // Fails if the card lacks the memory.
  static base::Result<std::unique_ptr<LitMethod>> make(const Functions& gl);

  void begin_portion() override { light_.begin_portion(); }
  std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                  BlockAtlas& io_atlas) override;
  void use(const Functions& gl, const FaceProgram& program, const LitLook& look) const override;
  void clear_light() override { light_.clear(); }
  CacheCounts light_counts() const override { return light_.counts(); }
  std::size_t bytes() const override { return tiles_.bytes() + light_.bytes(); }

 protected:
  explicit GridMethod(LightGrids light) : light_(std::move(light)) {}
  base::Status set_level(const Functions& gl, const render::FrameContext& context) override;
  void begin_frame() override { light_.begin_frame(); }

  LightGrids light_;
};

}  // namespace temblor::render_gl
