// Pictures of the overlay on the graphics card, one texture for each, and one for its detail. They stay as
// long as there is room, or while they are drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "formats/images/picture.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

struct OverlayTexture {
  GLuint name;
  // In texels. Less than those of the picture if it is larger than the card's textures.
  int width, height;
};

class OverlayTextures {
 public:
  // Drops what the last frame did not draw, if the textures have become too large together.
  void begin_frame();
  // Indices, and colors with opacity in the order of the CPU's pictures. Textures live until the next frame
  // begins. Fails if the card lacks memory.
  //
  // Pictures have no identity, and their pixels may change, as those of films do. So they are compared with
  // a copy of what was uploaded: that costs less than an upload.
  base::Result<OverlayTexture> find(const Functions& gl, const formats::Picture& picture);
  // A detail never changes while somebody holds it.
  base::Result<OverlayTexture> find(const Functions& gl,
                                    const std::shared_ptr<const formats::PictureDetail>& detail);

 private:
  struct Entry {
    Texture texture;
    OverlayTexture found{};
    std::vector<std::uint8_t> pixels;  // of a picture
    std::uint32_t width = 0, height = 0;
    std::shared_ptr<const formats::PictureDetail> detail;
    std::size_t bytes = 0;
    std::uint64_t frame = 0;  // the last one that drew it
  };
  template <typename Texel>
  base::Status upload(const Functions& gl, const Texel* texels, int width, int height, Entry& io_entry);

  // By the address of the pixels, or of the detail.
  std::unordered_map<const void*, Entry> entries_;
  std::size_t bytes_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace temblor::render_gl
