// The graphics card's copy of what the CPU has built: surface blocks and textures, in the layers of one array
// texture. Texels are uploaded when they are new or have changed, and stay as long as there is room. VQuake
// drew from such a cache of surfaces (Abrash, "Quake: A Post-Mortem and a Glimpse into the Future").
//
// A frame that does not fit is drawn in portions. Images of the current portion stay until the next one
// begins. Others make room: first those that the last frame did not need, the oldest ones first. A frame asks
// for its images in about the order of the last frame, so those that it has drawn are needed latest: they go
// next, the latest ones first. To evict the least recently used one would evict what is needed next: frames
// of twice the cache's size would then find nothing in it, and now find a fifth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <unordered_map>
#include <vector>

#include "render/surfaces/surface_block.h"
#include "render_gl/cache_options.h"
#include "render_gl/gl/objects.h"
#include "render_gl/surfaces/rect_allocator.h"

namespace temblor::render_gl {

// Identifies texels. Blocks: the address of their texels in the CPU's surface cache. Textures: any number
// that no address can be (texture_key).
using AtlasKey = std::uint64_t;

// Texels to draw from, 0xAARRGGBB or bytes, row by row; those of light have the format's 32 bits.
struct AtlasImage {
  AtlasKey key;
  const void* texels;
  render::SurfaceShape shape;
};

// Where an image is, and its size there: less than its own if it is larger than a layer.
struct StoredImage {
  AtlasPlace place;
  render::SurfaceShape shape;
};

class BlockAtlas {
 public:
  // Layers are smaller, and fewer, where the card's limits are. Fails if the card lacks the memory.
  static base::Result<BlockAtlas> make(const Functions& gl, const CacheOptions& options);

  void begin_frame();
  // From now on, the images of earlier portions may make room for others.
  void begin_portion();
  // Drops everything; for another level.
  void clear();
  // The image's texels have changed: it must be uploaded before it is drawn again.
  void invalidate(AtlasKey key);
  // The image if it is there and has not changed, without its texels. It counts as used.
  std::optional<StoredImage> reuse(AtlasKey key);
  // The image, after uploading it if it is missing or has changed. Nothing if the portion is full. Two images
  // always fit an empty portion.
  std::optional<StoredImage> place(const Functions& gl, const AtlasImage& image);

  // Room for an image that is not there (reuse() found nothing): the caller draws its texels into the texture
  // before the portion is drawn. Nothing if the portion is full.
  std::optional<StoredImage> reserve(AtlasKey key, render::SurfaceShape shape);

  GLuint texture() const { return texture_.name(); }
  // Texels of a layer's side.
  int side() const { return 1 << layer_power_; }
  TexelFormat format() const { return format_; }
  // Memory of the card.
  std::size_t bytes() const { return bytes_; }
  const CacheCounts& counts() const { return counts_; }

 private:
  struct Cell {
    AtlasKey key;
    RectAllocator::Rect rect;
    RectAllocator::Size size;
    StoredImage stored;
    std::uint64_t frame = 0, portion = 0;  // that used it last
    bool changed = false;
  };
  using Cells = std::list<Cell>;  // the least recently used one first

  BlockAtlas(Texture texture, TexelFormat format, int layer_power, int layers);
  render::SurfaceShape shrink(render::SurfaceShape shape) const;
  bool evict();
  void drop(Cells::iterator cell);
  std::optional<RectAllocator::Rect> make_room(RectAllocator::Size size);
  void use(Cells::iterator cell);
  // The cell of an image, whose texels count as changed if it is new. Null if the portion is full.
  Cell* find_cell(AtlasKey key, render::SurfaceShape stored_shape);
  void upload(const Functions& gl, const AtlasImage& image, const StoredImage& stored);
  // The texels as the card takes them.
  const void* convert(const AtlasImage& image, render::SurfaceShape stored);

  Texture texture_;
  TexelFormat format_;
  int layer_power_;
  std::size_t bytes_;
  RectAllocator rectangles_;
  Cells earlier_, of_portion_;
  std::unordered_map<AtlasKey, Cells::iterator> by_key_;
  std::uint64_t frame_ = 1, portion_ = 1;
  std::vector<std::uint32_t> shrunk_;       // scratch of upload()
  std::vector<std::uint16_t> packed_;       // the same
  std::vector<std::uint8_t> shrunk_bytes_;  // the same
  CacheCounts counts_;
};

}  // namespace temblor::render_gl
