#include "render_gl/overlay/overlay_textures.h"

#include <utility>

#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// The pictures of stock Quake's menus and status bar take 2 MB.
constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

}  // namespace

void OverlayTextures::begin_frame() {
  if (bytes_ > kMaxBytes)
    std::erase_if(entries_, [this](const auto& each) {
      const bool is_unused = each.second.frame != frame_;
      if (is_unused) bytes_ -= each.second.bytes;
      return is_unused;
    });
  ++frame_;
}

template <typename Texel>
base::Status OverlayTextures::upload(const Functions& gl, const Texel* texels, int width, int height,
                                     Entry& io_entry) {
  constexpr bool kIsColor = sizeof(Texel) == sizeof(std::uint32_t);
  const int halvings = count_halvings(width, height, find_texture_limits(gl).side);
  OverlayTexture& found = io_entry.found;
  found = {0, halve(width, halvings), halve(height, halvings)};
  TRY(io_entry.texture, make_texture(gl, kIsColor ? GL_RGBA8 : GL_R8, {found.width, found.height}));
  found.name = io_entry.texture.name();
  std::vector<Texel> halved;
  if (halvings > 0) halved = halve_picture(texels, width, height, halvings);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, found.width, found.height, kIsColor ? GL_RGBA : GL_RED,
                   GL_UNSIGNED_BYTE, halvings > 0 ? halved.data() : texels);
  bytes_ -= io_entry.bytes;
  io_entry.bytes =
      sizeof(Texel) * static_cast<std::size_t>(found.width) * static_cast<std::size_t>(found.height);
  bytes_ += io_entry.bytes;
  return base::Ok{};
}

base::Result<OverlayTexture> OverlayTextures::find(const Functions& gl, const formats::Picture& picture) {
  Entry& entry = entries_[picture.pixels.data()];
  const bool is_same_size = entry.width == picture.width && entry.height == picture.height;
  // Pictures do not change while a list is drawn.
  const bool is_compared = std::exchange(entry.frame, frame_) == frame_;
  if (is_same_size && !entry.pixels.empty() && (is_compared || entry.pixels == picture.pixels))
    return entry.found;
  entry.pixels.clear();  // stays so if the upload fails
  TRY_STATUS(upload(gl, picture.pixels.data(), static_cast<int>(picture.width),
                    static_cast<int>(picture.height), entry));
  entry.width = picture.width;
  entry.height = picture.height;
  entry.pixels = picture.pixels;
  return entry.found;
}

base::Result<OverlayTexture> OverlayTextures::find(
    const Functions& gl, const std::shared_ptr<const formats::PictureDetail>& detail) {
  Entry& entry = entries_[detail.get()];
  entry.frame = frame_;
  if (entry.detail == detail) return entry.found;
  entry.detail.reset();
  const int width = static_cast<int>(detail->width), height = static_cast<int>(detail->height);
  TRY_STATUS(upload(gl, detail->colors.data(), width, height, entry));
  entry.detail = detail;
  return entry.found;
}

}  // namespace temblor::render_gl
