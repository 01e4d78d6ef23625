// How the card gets the texels of lit tiles: one class for each WorldMethod that does without the CPU's
// surface blocks. A method takes its tiles out of the frame's requests, and makes their records in the
// TileTable. Tiles that only the CPU can compose keep their blocks.
//
//   LitMethod --> GridMethod         light in grids that the CPU sums: kLitTextures, kLightPass
//             |   |--> CardBlocks      the product is drawn into surface blocks: kCardBlocks
//             |   \--> PolygonMethod   dynamic lights are polygons: kLightPolygons
//             |--> VertexMethod       light at vertices: kGouraud
//             |--> StyleMethod        light maps as they are stored: kStyleLayers
//             \--> ExpandedBlocks     blocks of palette indices: kExpandedBlocks
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "render_gl/lit/lit_tiles.h"
#include "render_gl/surfaces/block_atlas.h"
#include "render_gl/surfaces/tile_table.h"
#include "render_gl/world/face_programs.h"
#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

// A lit face's textures and light, as far as faces with others are drawn by another call.
struct LitLook {
  std::uint16_t array = 0;  // of the texture
  bool has_lights = false;  // whether dynamic lights reach a visible tile; false if the method does not care
  bool operator==(const LitLook&) const = default;
  auto operator<=>(const LitLook&) const = default;
};

class LitMethod {
 public:
  virtual ~LitMethod() = default;
  LitMethod(const LitMethod&) = delete;
  LitMethod& operator=(const LitMethod&) = delete;

  void set_filter(const Functions& gl, render::TextureFilter filter);
  // Prepares for the level, and takes the tiles that need no surface block out of the frame's requests, which
  // must live as long as the frame. Comes first in each frame. Fails if the card lacks the memory.
  base::Status take(const Functions& gl, const render::FrameContext& context,
                    render::SurfaceRequests& io_requests);
  // The frame's tiles, and their textures.
  const LitTiles& tiles() const { return tiles_; }

  // Whether faces are drawn from the tiles' textures and light. False: the method draws surface blocks, which
  // faces show.
  virtual bool has_lit_faces() const { return true; }
  // Whether LitLook::has_lights matters.
  virtual bool separates_lights() const { return false; }
  // Comes before the frame's first portion. Fails if the card lacks the memory.
  virtual base::Status prepare(const Functions&, const FrameInput&) { return base::Ok{}; }
  // Whether a draw (a number in SurfaceDraws) is placed by the method.
  virtual bool has_tile(const FrameInput&, std::uint32_t draw) const { return tiles_.contains(draw); }
  // The tiles that follow are drawn together, up to end_portion().
  virtual void begin_portion() {}
  // The record of a lit tile. Nothing if the portion is full.
  virtual std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                          BlockAtlas& io_atlas) = 0;
  // Brings what the portion needs to the card. May bind another framebuffer and viewport.
  virtual void end_portion(const Functions&, const FrameInput&, const BlockAtlas&) {}

  // Sets what is the method's own in the program in use.
  virtual void use(const Functions& gl, const FaceProgram& program, const LitLook& look) const;
  // The same for an instance of FrameInput::scene (0: the world).
  virtual void use_instance(const Functions&, const FaceProgram&, std::uint32_t) const {}

  // Draws LitPassKind::kPolygons of the portion.
  virtual void draw_polygons(const Functions&, const FrameInput&) const {}

  // Uploads all light again.
  virtual void clear_light() {}
  // How the last frame used the card's memory of light.
  virtual CacheCounts light_counts() const { return {}; }
  // The memory of the card.
  virtual std::size_t bytes() const { return tiles_.bytes(); }

 protected:
  LitMethod() = default;
  // For another level. Nothing is left of the last one if it fails.
  virtual base::Status set_level(const Functions& gl, const render::FrameContext& context);
  virtual void begin_frame() {}
  // Whether the method can light a tile whose texture it has.
  virtual bool can_light(const world::Level&, const render::BlockRequest&) const { return true; }
  // For methods that take dynamic lights out of the requests of the tiles, which are ordered by draw. Draws
  // from `first_deferred` on may be translucent.
  virtual void take_lights(std::span<render::BlockRequest>, std::uint32_t) {}

  LitTiles tiles_;

 private:
  render::TextureFilter filter_ = render::TextureFilter::kNearest;
  std::shared_ptr<const world::LevelIdentity> level_;
};

// Null for WorldMethod::kBlocks. Fails if the card lacks the memory, cannot draw into `atlas`, or does not
// accept a shader.
base::Result<std::unique_ptr<LitMethod>> make_lit_method(const Functions& gl, WorldMethod method,
                                                         const BlockAtlas& atlas);

}  // namespace temblor::render_gl
