#include "platform/sdl2/presenters.h"

#include <SDL_opengl.h>

#include <array>
#include <string_view>

#include "platform/sdl2/gl_context.h"
#include "platform/sdl2/library.h"
#include "platform/sdl2/picture_surface.h"

namespace temblor::platform::sdl2 {
namespace {

// Copies each picture into the window's surface, and stretches it there if the sizes differ.
class SurfacePresenter : public PicturePresenter {
 public:
  explicit SurfacePresenter(SDL_Window* window) : window_(window) {}

  base::Status present(const Picture& picture, base::Jobs& jobs) override {
    // SDL owns the surface and replaces it when the window's size changes, so ask for it in every frame.
    SDL_Surface* const surface = SDL_GetWindowSurface(window_);
    if (surface == nullptr) return sdl_error("the window's surface");
    TRY_STATUS(draw_picture(picture, jobs, *surface));
    if (SDL_UpdateWindowSurface(window_) != 0) return sdl_error("the window's surface");
    return base::Ok{};
  }

  // SDL copies the surface at once, whatever the display is showing.
  void set_vsync(bool) override {}
  std::string describe() const override {
    return fmt::format("{}, window surface, without vsync", SDL_GetCurrentVideoDriver());
  }

 private:
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

  void set_vsync(bool vsync) override {
    has_vsync_ = SDL_RenderSetVSync(renderer_.get(), vsync ? 1 : 0) == 0 && vsync;
  }

  std::string describe() const override {
    SDL_RendererInfo info;
    const bool is_known = SDL_GetRendererInfo(renderer_.get(), &info) == 0;
    return fmt::format("{}, {} renderer, {} vsync", SDL_GetCurrentVideoDriver(),
                       is_known ? info.name : "unknown", has_vsync_ ? "with" : "without");
  }

 private:
  std::unique_ptr<SDL_Renderer, DestroyRenderer> renderer_;
  std::unique_ptr<SDL_Texture, DestroyTexture> texture_;
  PixelSize size_;
  bool has_vsync_ = false;
};

// SDL reports every OpenGL renderer as accelerated, even Mesa's renderers on the CPU.
bool is_software(SDL_Renderer* renderer) {
  SDL_RendererInfo info;
  if (SDL_GetRendererInfo(renderer, &info) != 0 || (info.flags & SDL_RENDERER_ACCELERATED) == 0) return true;
  return SDL_GL_GetCurrentContext() != nullptr && has_software_driver();
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
