// Dynamic lights as polygons of their own (WorldMethod::kLightPolygons): "The lighting polygons don't even
// have to match the texture polygons, so they can represent dynamically-changing lighting" (Abrash, "Surface
// Caching Revisited"). Light is summed in the picture before textures multiply it (lit_passes.h): first that
// of light maps, then polygons add that of dynamic lights. So grids of light have only styles in them, and no
// light is uploaded again because a rocket passes; its polygons are.
//
// Translucent faces are drawn in one pass, with dynamic lights in their grids.
#pragma once

#include <array>
#include <vector>

#include "render_gl/lit/grid_method.h"
#include "render_gl/passes/light_polygons.h"

namespace temblor::render_gl {

class PolygonMethod final : public GridMethod {
 public:
  // Fails if the card lacks the memory, or does not accept the shader.
  static base::Result<std::unique_ptr<LitMethod>> make(const Functions& gl);

  void begin_portion() override;
  std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                  BlockAtlas& io_atlas) override;
  void end_portion(const Functions& gl, const FrameInput& input, const BlockAtlas& atlas) override;
  void draw_polygons(const Functions& gl, const FrameInput& input) const override;
  // Grids of light, and the polygons of a portion as one upload.
  CacheCounts light_counts() const override;

 protected:
  void begin_frame() override;
  void take_lights(std::span<render::BlockRequest> io_requests, std::uint32_t first_deferred) override;

 private:
  // The layout is that of the shader.
  struct Vertex {
    math::Vec3 position_world;
    float nearer;                     // share of the distance by which it comes nearer than its face
    std::array<float, 3> half_light;  // blue, green, red
  };

  PolygonMethod(const Functions& gl, LightGrids light, Program program);
  void add_polygons(const FrameInput& input, std::uint32_t draw, const render::FaceLight& light);

  FaceProgram program_;
  Buffer buffer_;
  VertexArray vertex_array_;
  float nearer_;  // of the world's polygons
  struct DrawLights {
    std::uint32_t draw;
    std::span<const render::FaceLight> lights;
  };
  std::vector<DrawLights> lights_;    // of the frame's tiles that have some, by draw
  std::vector<Vertex> vertices_;      // of the portion
  std::vector<LightCorner> corners_;  // scratch
  CacheCounts polygon_counts_;
};

}  // namespace temblor::render_gl
