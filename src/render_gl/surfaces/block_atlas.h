// The graphics card's copy of what the CPU has built: surface blocks and textures, in the layers of one array
// texture. Texels are uploaded when they are new or have changed, and stay as long as there is room. VQuake
// drew from such a cache of surfaces (Abrash, "Quake: A Post-Mortem and a Glimpse into the Future").
//
// Full, it drops everything and uploads again what the frame needs. So no frame depends on earlier ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "render/frame_buffer.h"
#include "render/surfaces/surface_block.h"
#include "render_gl/gl/objects.h"
#include "render_gl/surfaces/rect_allocator.h"

namespace temblor::render_gl {

// Identifies texels. Blocks: the address of their texels in the CPU's surface cache. Textures: any number
// that no address can be (texture_key).
using AtlasKey = std::uint64_t;

// Texels to draw from; `texels` has those of the frame's format, row by row.
struct AtlasImage {
  AtlasKey key;
  const void* texels;
  render::SurfaceShape shape;
  bool changed = false;  // since the last frame: it must be uploaded
};

// Counts of the current frame.
struct AtlasCounts {
  std::uint32_t uploads = 0, flushes = 0;
  std::uint64_t bytes_uploaded = 0;
};

class BlockAtlas {
 public:
  // `bytes`: at most so much memory of the card, but at least one layer. Fails if the card has less.
  static base::Result<BlockAtlas> make(const Functions& gl, render::PixelFormat format, std::size_t bytes);

  void begin_frame() { counts_ = {}; }
  // Drops everything; for another level.
  void clear();
  // The place of the image, after uploading it if it is missing or has changed. Nothing if the atlas is full:
  // then the caller must clear() it and place all images of the frame again.
  std::optional<AtlasPlace> place(const Functions& gl, const AtlasImage& image);

  GLuint texture() const { return texture_.name(); }
  const AtlasCounts& counts() const { return counts_; }

 private:
  struct Cell {
    AtlasPlace place;
    RectAllocator::Size size;
  };
  BlockAtlas(Texture texture, render::PixelFormat format, int layers);
  void upload(const Functions& gl, const AtlasImage& image, AtlasPlace place);

  Texture texture_;
  render::PixelFormat format_;
  RectAllocator rectangles_;
  std::unordered_map<AtlasKey, Cell> cells_;
  AtlasCounts counts_;
};

}  // namespace temblor::render_gl
