#include "host/video/window_gl.h"

#include <array>
#include <utility>

#include "base/check.h"
#include "platform/egl/offscreen_context.h"
#include "render_gl/gl/objects.h"

namespace temblor::test {
namespace {

constexpr int kMaxSide = 1024;

// These belong to the thread's context.
thread_local PFNGLBINDFRAMEBUFFERPROC real_bind_framebuffer = nullptr;
thread_local GLuint window_framebuffer = 0;
thread_local int* calls_until_window_fails = nullptr;

void GL_APIENTRY bind_framebuffer(GLenum target, GLuint name) {
  real_bind_framebuffer(target, name == 0 ? window_framebuffer : name);
}

GLenum GL_APIENTRY get_window_error() {
  if (*calls_until_window_fails < 0) return GL_NO_ERROR;
  if (*calls_until_window_fails == 0) return GL_OUT_OF_MEMORY;
  --*calls_until_window_fails;
  return GL_NO_ERROR;
}

class ReadableContext final : public platform::WindowGlContext {
 public:
  ReadableContext(std::unique_ptr<platform::GlContext> real, const platform::Window& window,
                  ShownByGl& io_shown)
      : real_(std::move(real)), window_(window), shown_(io_shown), gl_(load()) {
    color_.emplace(render_gl::make_texture(gl_, GL_RGBA8, {kMaxSide, kMaxSide}).value());
    framebuffer_.emplace(render_gl::make_framebuffer(gl_));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_->name());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_->name(), 0);
    real_bind_framebuffer = gl_.BindFramebuffer;
    window_framebuffer = framebuffer_->name();
    calls_until_window_fails = &shown_.calls_until_failure;
    ++shown_.contexts;
    ++shown_.opened;
  }
  ~ReadableContext() override { --shown_.contexts; }

  base::Status make_current() override { return real_->make_current(); }
  void* find_function(const char* name) const override {
    if (std::string_view(name) == "glBindFramebuffer") return reinterpret_cast<void*>(bind_framebuffer);
    if (shown_.calls_until_failure >= 0 && std::string_view(name) == "glGetError")
      return reinterpret_cast<void*>(get_window_error);
    return real_->find_function(name);
  }
  bool is_software() const override { return shown_.is_software; }

  void show() override {
    shown_.size = window_.size();
    const auto [width, height] = shown_.size;
    std::vector<std::array<std::uint8_t, 4>> rows(static_cast<std::size_t>(width) *
                                                  static_cast<std::size_t>(height));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_->name());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    shown_.pixels.clear();
    for (int y = height - 1; y >= 0; --y)
      for (int x = 0; x < width; ++x) {
        const auto& [r, g, b, a] = rows[static_cast<std::size_t>(y * width + x)];
        shown_.pixels.push_back(0xff000000u | std::uint32_t{r} << 16 | std::uint32_t{g} << 8 | b);
      }
    ++shown_.pictures;
  }

 private:
  render_gl::Functions load() const {
    auto functions =
        render_gl::load_functions([this](const char* name) { return real_->find_function(name); });
    CHECK(functions.ok());
    return *functions;
  }

  std::unique_ptr<platform::GlContext> real_;
  const platform::Window& window_;
  ShownByGl& shown_;
  const render_gl::Functions gl_;
  std::optional<render_gl::Texture> color_;
  std::optional<render_gl::Framebuffer> framebuffer_;
};

}  // namespace

platform::headless::HeadlessWindow::OpenGl make_window_gl(const platform::Window& window,
                                                          ShownByGl& io_shown) {
  return [&window, &io_shown]() -> base::Result<std::unique_ptr<platform::WindowGlContext>> {
    TRY(std::unique_ptr<platform::GlContext> real, platform::egl::make_offscreen_context());
    return std::unique_ptr<platform::WindowGlContext>(
        std::make_unique<ReadableContext>(std::move(real), window, io_shown));
  };
}

}  // namespace temblor::test
