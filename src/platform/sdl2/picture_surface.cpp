#include "platform/sdl2/picture_surface.h"

#include <algorithm>
#include <cstring>

#include "platform/sdl2/library.h"

namespace temblor::platform::sdl2 {
namespace {

// Copies a picture of the surface's size. Each job copies a slice of rows.
void copy_rows(const Picture& picture, base::Jobs& jobs, SDL_Surface& io_surface) {
  const auto width = static_cast<std::size_t>(picture.size.width);
  const auto height = static_cast<std::size_t>(picture.size.height);
  const auto pitch = static_cast<std::size_t>(io_surface.pitch);
  const auto slices = std::min(height, static_cast<std::size_t>(jobs.threads()));
  auto* const pixels = static_cast<std::uint8_t*>(io_surface.pixels);
  jobs.parallel_for(slices, [&](std::size_t slice) {
    for (std::size_t y = height * slice / slices; y < height * (slice + 1) / slices; ++y)
      std::memcpy(pixels + y * pitch, picture.pixels.data() + y * width, width * sizeof(std::uint32_t));
  });
}

bool draw_scaled(const Picture& picture, SDL_Surface& io_surface) {
  // SDL only reads from the picture, so the const_cast is safe.
  const Surface source = wrap_pixels(const_cast<std::uint32_t*>(picture.pixels.data()), picture.size);
  if (!source) return false;
  // The linear filter needs equal pixel formats on both sides.
  if (io_surface.format->format == SDL_PIXELFORMAT_RGB888)
    return SDL_SoftStretchLinear(source.get(), nullptr, &io_surface, nullptr) == 0;
  return SDL_BlitScaled(source.get(), nullptr, &io_surface, nullptr) == 0;
}

}  // namespace

Surface wrap_pixels(std::uint32_t* pixels, PixelSize size) {
  return Surface(SDL_CreateRGBSurfaceWithFormatFrom(pixels, size.width, size.height, 32,
                                                    size.width * static_cast<int>(sizeof(std::uint32_t)),
                                                    SDL_PIXELFORMAT_RGB888));
}

base::Status draw_picture(const Picture& picture, base::Jobs& jobs, SDL_Surface& io_surface) {
  // Same size and pixel format: plain copies of rows are enough.
  const bool is_same = io_surface.w == picture.size.width && io_surface.h == picture.size.height &&
                       io_surface.format->BytesPerPixel == sizeof(std::uint32_t) &&
                       io_surface.format->Rmask == 0xff0000 && io_surface.format->Bmask == 0xff;
  if (is_same)
    copy_rows(picture, jobs, io_surface);
  else if (!draw_scaled(picture, io_surface))
    return sdl_error("scaling the picture");
  return base::Ok{};
}

}  // namespace temblor::platform::sdl2
