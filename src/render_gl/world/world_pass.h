// Draws the level and the brush models. The CPU finds the visible faces, their mip levels, and their surface
// blocks, by the stages of the CPU renderer; the graphics card draws their pixels. If their texels do not fit
// the atlas, they are drawn in portions: depth makes the order of opaque faces irrelevant, and translucent
// faces keep theirs.
//
//   SurfaceBlocks --> BlockAtlas (texels)       visible surfaces --> FaceQueue (vertices)
//                 \-> TileTable (records)                        \-> one draw call per instance
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render_gl/frame/target.h"
#include "render_gl/lit/lit_method.h"
#include "render_gl/surfaces/block_atlas.h"
#include "render_gl/surfaces/tile_table.h"
#include "render_gl/world/face_programs.h"
#include "render_gl/world/face_queue.h"
#include "render_gl/world/frame_input.h"
#include "render_gl/world/level_mesh.h"
#include "render_gl/world/skybox_texture.h"

namespace temblor::render_gl {

class WorldPass {
 public:
  // For frames of this format. The cache of indexed ones is a quarter as large.
  static base::Result<WorldPass> make(const Functions& gl, const CacheOptions& cache,
                                      render::PixelFormat format);

  // Prepares for the level, and takes the tiles that need no surface block out of the frame's requests, which
  // must live as long as the frame. Comes first in each frame. Fails if the card lacks the memory, or does
  // not accept a shader.
  base::Status take_lit_tiles(const Functions& gl, const render::FrameContext& context,
                              const DrawOptions& options, render::SurfaceRequests& io_requests);
  // Brings the frame's first portion of texels and records, and all vertices, to the graphics card. Fails if
  // the card lacks memory.
  base::Status prepare(const Functions& gl, const FrameInput& input);
  // Draws opaque faces, and those with holes, with depth. prepare() comes first. `target` is bound.
  void draw_opaque(const Functions& gl, const FrameInput& input, const Target& target);
  // Blends translucent face number `face` (DeferredFaces::translucent) into the picture, tested against
  // depth. Numbers must rise from call to call. `io_target` is the one that is drawn to. Fails if the card
  // lacks memory.
  base::Status draw_translucent(const Functions& gl, const FrameInput& input, std::uint32_t face,
                                Target& io_target);

  // Counts of the last frame: blocks, textures that repeat, and grids of light.
  CacheCounts counts() const;
  std::size_t cache_bytes() const { return atlas_.bytes() + (method_ ? method_->bytes() : 0); }

 private:
  // The queued faces whose texels are in the atlas now. The last one goes on in the next portion, with
  // `next_tile`, unless that is 0.
  struct Portion {
    std::size_t begin = 0, end = 0;
    std::uint32_t next_tile = 0;

    bool contains(std::size_t face) const { return begin <= face && face < end; }
    // Whether this portion and earlier ones have all faces before `face`.
    bool has_all_before(std::size_t face) const { return end > face || (end == face && next_tile == 0); }
  };

  WorldPass(const Functions& gl, FacePrograms programs, BlockAtlas atlas);
  base::Status set_level(const Functions& gl, const FrameInput& input);
  base::Status set_options(const Functions& gl, const DrawOptions& options, render::PixelFormat format);
  std::optional<TileRecord> place_draw(const Functions& gl, const FrameInput& input, std::uint32_t draw);
  base::Status number_instances(const Functions& gl, const FrameInput& input);
  void begin_portion(const Functions& gl, const FrameInput& input);
  bool place_face(const Functions& gl, const FrameInput& input, const QueuedFace& face);
  const FaceProgram& begin_draw(const Functions& gl, const FrameInput& input, const QueuedFace& face,
                                LitPassKind pass) const;
  void draw_faces(const Functions& gl, const FrameInput& input, const FaceProgram& program,
                  std::span<const QueuedFace> faces) const;
  void draw_lit_pass(const Functions& gl, const FrameInput& input, const LitPass& pass) const;
  void draw_opaque_portion(const Functions& gl, const FrameInput& input) const;
  base::Status draw_translucent_portion(const Functions& gl, const FrameInput& input, std::size_t number,
                                        Target& io_target) const;

  FacePrograms programs_;
  DrawOptions options_;  // of the programs
  BlockAtlas atlas_;
  std::unique_ptr<LitMethod> method_;  // null: all lit faces have surface blocks
  TileTable table_;
  std::shared_ptr<const world::LevelIdentity> level_;
  LevelMesh mesh_;
  SkyboxTexture skybox_;
  Buffer index_buffer_;
  // By instance: added to the numbers of the faces' own tiles, modulo 2^32.
  std::vector<std::uint32_t> record_offset_;
  FaceQueue faces_;
  Portion portion_;
};

}  // namespace temblor::render_gl
