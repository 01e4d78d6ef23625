#include "render_gl/gl_pictures.h"

#include <algorithm>
#include <cstdlib>

#include "platform/egl/offscreen_context.h"
#include "support/pictures/frames.h"
#include "support/pictures/picture_file.h"

namespace temblor::render_gl {

namespace {

constexpr int kWidth = 640, kHeight = 480;

// Gray where the pictures are equal, red where they differ.
render::FrameBuffer make_difference(const render::FrameBuffer& a, const render::FrameBuffer& b,
                                    const formats::Palette& palette) {
  render::FrameBuffer out(a.width(), a.height(), render::PixelFormat::kRgb);
  for (std::size_t i = 0; i < a.pixel_count(); ++i) {
    const bool is_indexed = a.format() == render::PixelFormat::kIndexed;
    const bool differs =
        is_indexed ? a.indexed()[i] != b.indexed()[i] : test::largest_difference(a.rgb()[i], b.rgb()[i]) > 2;
    const std::uint32_t shown = is_indexed ? render::to_rgb(palette[a.indexed()[i]]) : a.rgb()[i];
    out.rgb()[i] = 0xff000000u | (differs ? 0xff0000u : (shown >> 2) & 0x3f3f3fu);
  }
  return out;
}

// Most drivers round vertices to 1/256 pixel. SwiftShader rounds them to 1/16, so that borders move.
bool rounds_coarsely(const platform::GlContext& context) {
  constexpr GLenum kSubpixelBits = 0x0D50;
  constexpr GLint kUsual = 8;
  const auto get = reinterpret_cast<PFNGLGETINTEGERVPROC>(context.find_function("glGetIntegerv"));
  GLint bits = kUsual;
  get(kSubpixelBits, &bits);
  return bits < kUsual;
}

// The share of pixels with a neighbor, or the same place, where the other picture is equal.
template <typename Pixel, typename Equal>
double share_near(std::span<const Pixel> a, std::span<const Pixel> b, Equal equal) {
  std::size_t found = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto at = [](int column, int row) { return static_cast<std::size_t>(row * kWidth + column); };
      const auto matches = [&] {
        for (int row = std::max(y - 1, 0); row <= std::min(y + 1, kHeight - 1); ++row)
          for (int column = std::max(x - 1, 0); column <= std::min(x + 1, kWidth - 1); ++column)
            if (equal(a[at(x, y)], b[at(column, row)])) return true;
        return false;
      };
      found += matches() ? 1 : 0;
    }
  return static_cast<double>(found) / (kWidth * kHeight);
}

}  // namespace

RendererPair::RendererPair(const test::DrawableLevel& look)
    : name_(look.name),
      palette_(look.palette),
      cpu_(look.palette, look.colormap),
      cpu_frame_(kWidth, kHeight, render::PixelFormat::kRgb),
      gl_frame_(kWidth, kHeight, render::PixelFormat::kRgb) {}

base::Result<std::unique_ptr<RendererPair>> RendererPair::make(const test::DrawableLevel& look,
                                                               ClipControl clip_control,
                                                               const CacheOptions& cache) {
  std::unique_ptr<RendererPair> pair(new RendererPair(look));
  TRY(pair->context_, platform::egl::make_offscreen_context());
  const auto find = [context = pair->context_.get(), clip_control](const char* name) -> void* {
    const bool is_hidden =
        clip_control == ClipControl::kNo && std::string_view(name).starts_with("glClipControl");
    return is_hidden ? nullptr : context->find_function(name);
  };
  TRY(pair->gl_, GlRenderer::make(find, look.palette, look.colormap, cache));
  pair->rounds_coarsely_ = rounds_coarsely(*pair->context_);
  return pair;
}

GlRenderer& RendererPair::gl() {
  const base::Status current = context_->make_current();
  CHECK(current.ok(), "{}", current.error().what);
  return *gl_;
}

double RendererPair::compare(const render::Scene& scene, const render::Settings& settings, int tolerance) {
  cpu_.render(scene, settings, cpu_frame_);
  const base::Result<render::FrameStats> drawn = gl().render(scene, settings, gl_frame_);
  CHECK(drawn.ok(), "{}", drawn.error().what);
  const std::string number = name_ + "-" + std::to_string(picture_count_++);
  test::show_picture(number + "-cpu", cpu_frame_, palette_);
  test::show_picture(number + "-gl", gl_frame_, palette_);
  test::show_picture(number + "-difference", make_difference(cpu_frame_, gl_frame_, palette_), palette_);
  if (cpu_frame_.format() == render::PixelFormat::kIndexed) return equal_indices();
  if (rounds_coarsely_)
    return share_near<std::uint32_t>(
        cpu_frame_.rgb(), gl_frame_.rgb(),
        [&](std::uint32_t a, std::uint32_t b) { return test::largest_difference(a, b) <= tolerance; });
  return test::equal_share(cpu_frame_.rgb(), gl_frame_.rgb(), tolerance);
}

void RendererPair::set_format(render::PixelFormat format) {
  cpu_frame_ = render::FrameBuffer(kWidth, kHeight, format);
  gl_frame_ = render::FrameBuffer(kWidth, kHeight, format);
}

double RendererPair::equal_indices() const {
  if (rounds_coarsely_)
    return share_near<std::uint8_t>(cpu_frame_.indexed(), gl_frame_.indexed(), std::equal_to());
  std::size_t equal = 0;
  for (std::size_t i = 0; i < cpu_frame_.pixel_count(); ++i)
    equal += cpu_frame_.indexed()[i] == gl_frame_.indexed()[i];
  return static_cast<double>(equal) / static_cast<double>(cpu_frame_.pixel_count());
}

}  // namespace temblor::render_gl
