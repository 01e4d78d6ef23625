// Light that is never built (WorldMethod::kStyleLayers): the level's light maps are on the card as they are
// stored (StyleSamples), and the shader adds their styles and the dynamic lights for each pixel, at the four
// samples around it. When torches flicker and rockets fly, nothing is rebuilt, and nothing is uploaded but
// the values of the styles and the places of the lights. Abrash names the rebuilding as the weak point of
// surface caching ("Quake's Lighting Model: Surface Caching").
//
// The CPU's blocks remain for tiles with caustics, for faces whose light maps are not stock, and for the
// laboratory's views of light.
#pragma once

#include <array>

#include "render_gl/lit/lit_method.h"
#include "render_gl/styles/style_samples.h"

namespace temblor::render_gl {

class StyleMethod final : public LitMethod {
 public:
  base::Status prepare(const Functions& gl, const FrameInput& input) override;
  std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                  BlockAtlas& io_atlas) override;
  bool separates_lights() const override { return true; }
  void use(const Functions& gl, const FaceProgram& program, const LitLook& look) const override;
  // The level's samples in its first frame.
  CacheCounts light_counts() const override { return counts_; }
  std::size_t bytes() const override { return tiles_.bytes() + samples_.bytes(); }

 protected:
  base::Status set_level(const Functions& gl, const render::FrameContext& context) override;
  void begin_frame() override { counts_ = {}; }
  bool can_light(const world::Level& level, const render::BlockRequest& request) const override;

 private:
  StyleSamples samples_;
  std::array<float, world::kLightStyles> style_values_{};  // 1: the light as stored
  bool is_colored_ = false;
  Texture lights_;  // two texels for each: place in the world, radius | blue, green, red, least light
  int light_count_ = 0, light_capacity_ = 0;
  CacheCounts counts_;
};

}  // namespace temblor::render_gl
