#include "platform/sdl2/presenters.h"

#include <SDL_opengl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "platform/sdl2/library.h"

namespace temblor::platform::sdl2 {
namespace {

struct FreeSurface {
  void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};
using Surface = std::unique_ptr<SDL_Surface, FreeSurface>;

// Wraps the picture's pixels in a surface without a copy. SDL only reads from it, so the const_cast is safe.
Surface wrap_picture(const Picture& picture) {
  return Surface(SDL_CreateRGBSurfaceWithFormatFrom(
      const_cast<std::uint32_t*>(picture.pixels.data()), picture.size.width, picture.size.height, 32,
      picture.size.width * static_cast<int>(sizeof(std::uint32_t)), SDL_PIXELFORMAT_RGB888));
}

// Copies each picture into the window's surface, and stretches it there if the sizes differ.
class SurfacePresenter : public PicturePresenter {
 public:
  explicit SurfacePresenter(SDL_Window* window) : window_(window) {}

  base::Status present(const Picture& picture, base::Jobs& jobs) override {
    // SDL owns the surface and replaces it when the window's size changes, so ask for it in every frame.
    SDL_Surface* const surface = SDL_GetWindowSurface(window_);
    if (surface == nullptr) return sdl_error("the window's surface");
    // Same size and pixel format: plain copies of rows are enough.
    const bool is_same = surface->w == picture.size.width && surface->h == picture.size.height &&
                         surface->format->BytesPerPixel == sizeof(std::uint32_t) &&
                         surface->format->Rmask == 0xff0000 && surface->format->Bmask == 0xff;
    if (is_same)
      copy_rows(picture, jobs, *surface);
    else if (!draw_scaled(picture, surface))
      return sdl_error("the window's surface");
    if (SDL_UpdateWindowSurface(window_) != 0) return sdl_error("the window's surface");
    return base::Ok{};
  }

  // A surface has no vsync of its own: the display's compositor shows it with its next frame.
  void set_vsync(bool) override {}
  std::string describe() const override {
    return fmt::format("{}, shared memory", SDL_GetCurrentVideoDriver());
  }

 private:
  // Copies a picture of the window's size. Each job copies a slice of rows.
  static void copy_rows(const Picture& picture, base::Jobs& jobs, SDL_Surface& io_surface) {
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

  bool draw_scaled(const Picture& picture, SDL_Surface* io_surface) {
    const Surface source = wrap_picture(picture);
    if (!source) return false;
    // The linear filter needs equal pixel formats on both sides.
    if (io_surface->format->format == SDL_PIXELFORMAT_RGB888)
      return SDL_SoftStretchLinear(source.get(), nullptr, io_surface, nullptr) == 0;
    return SDL_BlitScaled(source.get(), nullptr, io_surface, nullptr) == 0;
  }

  SDL_Window* window_;
};

struct DestroyRenderer {
  void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
};
struct DestroyTexture {
  void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};

// Uploads each picture into a texture and lets SDL's renderer stretch it over the window.
class RendererPresenter : public PicturePresenter {
 public:
  explicit RendererPresenter(std::unique_ptr<SDL_Renderer, DestroyRenderer> renderer)
      : renderer_(std::move(renderer)) {}

  base::Status present(const Picture& picture, base::Jobs&) override {
    // The texture is made again only when the resolution of the pictures changes.
    if (!texture_ || size_ != picture.size) {
      SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
      texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING,
                                       picture.size.width, picture.size.height));
      size_ = picture.size;
    }
    const int pitch = picture.size.width * static_cast<int>(sizeof(std::uint32_t));
    if (!texture_ || SDL_UpdateTexture(texture_.get(), nullptr, picture.pixels.data(), pitch) != 0 ||
        SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr) != 0)
      return sdl_error("the display's renderer");
    SDL_RenderPresent(renderer_.get());
    return base::Ok{};
  }

  void set_vsync(bool vsync) override { SDL_RenderSetVSync(renderer_.get(), vsync ? 1 : 0); }

  std::string describe() const override {
    SDL_RendererInfo info;
    const bool is_known = SDL_GetRendererInfo(renderer_.get(), &info) == 0;
    return fmt::format("{}, {}", SDL_GetCurrentVideoDriver(), is_known ? info.name : "renderer");
  }

 private:
  std::unique_ptr<SDL_Renderer, DestroyRenderer> renderer_;
  std::unique_ptr<SDL_Texture, DestroyTexture> texture_;
  PixelSize size_;
};

// SDL reports every OpenGL renderer as accelerated, even Mesa's renderers on the CPU, so the driver's name
// must tell.
bool is_software(SDL_Renderer* renderer) {
  SDL_RendererInfo info;
  if (SDL_GetRendererInfo(renderer, &info) != 0 || (info.flags & SDL_RENDERER_ACCELERATED) == 0) return true;
  using GetString = const GLubyte*(APIENTRY*)(GLenum);
  const auto get_string = reinterpret_cast<GetString>(SDL_GL_GetProcAddress("glGetString"));
  if (SDL_GL_GetCurrentContext() == nullptr || get_string == nullptr) return false;
  const GLubyte* const name = get_string(GL_RENDERER);
  if (name == nullptr) return false;
  const std::string_view renderer_name = reinterpret_cast<const char*>(name);
  constexpr std::array<std::string_view, 4> kSoftware = {"llvmpipe", "softpipe", "swrast", "SwiftShader"};
  for (const std::string_view software : kSoftware)
    if (renderer_name.find(software) != std::string_view::npos) return true;
  return false;
}

}  // namespace

std::unique_ptr<PicturePresenter> make_surface_presenter(SDL_Window* window) {
  // Without this hint, SDL may implement the surface by a texture of a software renderer, which is slower.
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  if (SDL_GetWindowSurface(window) == nullptr) return nullptr;
  return std::make_unique<SurfacePresenter>(window);
}

std::unique_ptr<PicturePresenter> make_renderer_presenter(SDL_Window* window, bool hardware_only) {
  std::unique_ptr<SDL_Renderer, DestroyRenderer> renderer(
      SDL_CreateRenderer(window, -1, hardware_only ? SDL_RENDERER_ACCELERATED : 0));
  if (!renderer || (hardware_only && is_software(renderer.get()))) return nullptr;
  return std::make_unique<RendererPresenter>(std::move(renderer));
}

}  // namespace temblor::platform::sdl2
