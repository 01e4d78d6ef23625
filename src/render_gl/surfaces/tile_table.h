// A table of what each tile of each face shows, as a texture that shaders read. Tiles of the world keep their
// place in it from frame to frame, and only rows with changes are uploaded. Brush models, which may be drawn
// several times in a frame, get places after those for the frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

// How a tile gets its texels.
enum class TileKind : std::uint32_t {
  kHidden,  // the CPU's edge scan found no pixel of it
  kBlock,   // from its surface block
  kRepeat,  // from a texture that repeats
  kLiquid,  // from a texture that repeats and is warped
  kSky,     // from the two layers of a sky
  kSkybox,  // from the scene's skybox, which is one texture
  kLit      // from a texture of TextureArrays, times a grid of light
};

// Bits of TileRecord::flags: texels with alpha 0 are clear; one color replaces all texels; there is no fog.
constexpr std::uint32_t kHasHoles = 1 << 20, kHasColor = 1 << 21, kHasNoFog = 1 << 22;

// A record of kLit has the place and layer of its grid of light, the size of the block that it does without,
// and scale_t holds other bits (lit_shaders.h).
//
// One tile. A texel of the atlas is found from a point of the face that is s, t texels of mip 0 from the
// face's first texel: (s + origin_s) * scale_s from the first texel of the image. The layout is that of the
// shader.
struct TileRecord {
  std::uint32_t place = 0;         // x | y << 16 in the atlas
  std::uint32_t size = 0;          // width | height << 16 of the image
  std::uint32_t flags = 0;         // layer | TileKind << 16 | kHas... | opacity (0 to 255) << 24
  std::uint32_t second_place = 0;  // kSky: the background's x / 8 | y / 8 << 8 | layer << 16
                                   // kLit: the texture's first texel, x | y << 16
                                   // kHasColor: 0x00RRGGBB, or an index
  float origin_s = 0, origin_t = 0, scale_s = 1, scale_t = 1;
  bool operator==(const TileRecord&) const = default;
};

// Two numbers below 65536.
constexpr std::uint32_t pack_halves(std::uint32_t low, std::uint32_t high) {
  return low | high << 16;
}

class TileTable {
 public:
  // Records that the table's texture has in a row.
  static constexpr std::uint32_t kRecordsPerRow = 512;

  // Makes room for `count` records, or for as many as the card's largest texture has: half a million at
  // least. All of them are hidden then, if there was less room before.
  base::Status reserve(const Functions& gl, std::uint32_t count);
  // The records that there is room for.
  std::size_t capacity() const { return records_.size(); }
  // Does nothing if there is no room for the record.
  void set(std::uint32_t number, const TileRecord& record);
  // Uploads the rows that have changed.
  void upload(const Functions& gl);

  GLuint texture() const { return texture_.name(); }

 private:
  Texture texture_;
  std::vector<TileRecord> records_;
  std::vector<bool> row_changed_;
};

}  // namespace temblor::render_gl
