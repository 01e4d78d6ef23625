#include "host/video/gl_view.h"

namespace temblor::host {

namespace {

base::Result<render_gl::GlRenderer> make_gl_renderer(const platform::GlContext& context,
                                                     const assets::Look& look) {
  const auto find = [&context](const char* name) { return context.find_function(name); };
  return render_gl::GlRenderer::make(find, look.palette, look.colormap);
}

}  // namespace

base::Result<std::unique_ptr<GlView>> GlView::make(platform::Window& window, GlWindowUse use,
                                                   const OpenGl& open_gl, const assets::Look& look) {
  std::unique_ptr<GlView> view(new GlView);
  if (use != GlWindowUse::kOff) {
    const base::Status opened = view->open_in_window(window, use, look);
    if (opened.ok()) return view;
    view.reset(new GlView);
    if (use == GlWindowUse::kOn) view->window_failure_ = opened.error();
  }
  TRY_STATUS(view->open_alone(open_gl, look));
  return view;
}

base::Status GlView::open_in_window(platform::Window& window, GlWindowUse use, const assets::Look& look) {
  TRY(window_context_, window.open_gl());
  if (use == GlWindowUse::kAuto && window_context_->is_software())
    return base::error(base::ErrorCode::kUnsupported, "the driver is software");
  TRY(renderer_, make_gl_renderer(*window_context_, look));
  return base::Ok{};
}

base::Status GlView::open_alone(const OpenGl& open_gl, const assets::Look& look) {
  if (!open_gl) return base::error(base::ErrorCode::kUnsupported, "this program has no OpenGL");
  const auto open = [&]() -> base::Status {
    TRY(context_, open_gl());
    TRY(renderer_, make_gl_renderer(*context_, look));
    return base::Ok{};
  };
  thread_.emplace();
  base::Status opened = base::Ok{};
  run([&] { opened = open(); });
  return opened;
}

GlView::~GlView() {
  run([this] {
    renderer_.reset();
    context_.reset();
    window_context_.reset();
  });
}

base::Result<render::FrameStats> GlView::draw(const render::Scene& scene, const render::Settings& settings,
                                              render::FrameBuffer& io_frame) {
  if (draws_into_window()) return renderer_->draw(scene, settings, io_frame);
  base::Result<render::FrameStats> drawn = render::FrameStats{};
  run([&] { drawn = renderer_->render(scene, settings, io_frame); });
  return drawn;
}

void GlView::make_blend_tables() const {
  renderer_->make_blend_tables();
}

base::Status GlView::show(const render_gl::Shown& shown) {
  TRY_STATUS(renderer_->show(shown));
  window_context_->show();
  return base::Ok{};
}

void GlView::run(std::function<void()> work) {
  if (!thread_) return work();
  thread_->begin(std::move(work));
  thread_->wait();
}

}  // namespace temblor::host
