// Draws the level and the brush models. The CPU finds the visible faces, their mip levels, and their surface
// blocks, by the stages of the CPU renderer; the graphics card draws their pixels.
//
//   SurfaceBlocks --> BlockAtlas (texels)       visible surfaces --> one list of vertices per instance
//                 \-> TileTable (records)                        \-> one draw call per instance
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/frame/render_frame.h"
#include "render/spans/span_sources.h"
#include "render/translucent/translucent_layers.h"
#include "render_gl/surfaces/block_atlas.h"
#include "render_gl/surfaces/tile_table.h"
#include "render_gl/world/level_mesh.h"
#include "render_gl/world/skybox_texture.h"

namespace temblor::render_gl {

// The results of the CPU's stages that a frame is drawn from.
struct FrameInput {
  const render::FrameContext& context;
  const render::FrameRecord& record;
  const render::SpanSources& sources;
  const render::TranslucentOrder& order;
  const render::LevelData& level_data;

  const render::Scene& scene() const { return context.scene; }
};

class WorldPass {
 public:
  // `format` is that of the frames.
  static base::Result<WorldPass> make(const Functions& gl, render::PixelFormat format,
                                      std::size_t atlas_bytes);

  // Brings the frame's texels, records, and vertices to the graphics card. Fails if the card lacks memory for
  // what one frame shows.
  base::Status prepare(const Functions& gl, const FrameInput& input);
  // Draws opaque faces, and those with holes, with depth. prepare() comes first.
  void draw_opaque(const Functions& gl, const FrameInput& input) const;
  // Blends translucent face number `face` (DeferredFaces::translucent) into the picture, tested against
  // depth.
  void draw_translucent(const Functions& gl, const FrameInput& input, std::uint32_t face) const;

  const AtlasCounts& counts() const { return atlas_.counts(); }

 private:
  // Triangles of one instance: the world's (0), or those of Scene::brush_models[instance - 1].
  struct Batch {
    std::uint32_t instance;
    std::size_t first_index, index_count;
  };
  // A program, and the locations of its variables; -1 for those that it lacks.
  struct Shader {
    Shader(const Functions& gl, Program linked);
    Program program;
    GLint model_axes, model_origin, first_record, eye, view_axes, projection, full_range;
    GLint records, atlas, skybox, liquid_phase, sky_scroll, fog_density, fog_color;
  };

  WorldPass(const Functions& gl, Shader any_face, Shader block, Shader fogged_block, BlockAtlas atlas);
  base::Status set_level(const Functions& gl, const FrameInput& input);
  base::Status number_instances(const Functions& gl, const FrameInput& input);
  bool place_images(const Functions& gl, const FrameInput& input);
  bool place_draw(const Functions& gl, const FrameInput& input, std::uint32_t draw);
  void set_records(const FrameInput& input);
  void collect_triangles(const Functions& gl, const FrameInput& input);
  void add_surface(const FrameInput& input, render::SurfaceIndex surface, std::vector<Batch>& io_batches);
  void begin_draw(const Functions& gl, const FrameInput& input, const Shader& shader) const;
  void draw_batch(const Functions& gl, const FrameInput& input, const Shader& shader,
                  const Batch& batch) const;

  // For faces of all kinds, and for those that show one surface block, without and with fog.
  Shader any_face_, block_, fogged_block_;
  BlockAtlas atlas_;
  TileTable table_;
  std::shared_ptr<const world::LevelIdentity> level_;
  LevelMesh mesh_;
  SkyboxTexture skybox_;
  Buffer index_buffer_;
  // By instance: added to the numbers of the faces' own tiles, modulo 2^32.
  std::vector<std::uint32_t> record_offset_;
  std::vector<TileRecord> draw_records_;  // by draw number
  // The vertices of the frame's triangles, in batches: opaque faces, faces with holes, and one batch
  // for each translucent face.
  std::vector<std::uint32_t> indices_;
  std::vector<Batch> blocks_, others_, with_holes_, translucent_;
};

}  // namespace temblor::render_gl
