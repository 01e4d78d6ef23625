#include "host/video/gl_view.h"

namespace temblor::host {

base::Result<std::unique_ptr<GlView>> GlView::make(const OpenGl& open_gl, const assets::Look& look) {
  if (!open_gl) return base::error(base::ErrorCode::kUnsupported, "this program has no OpenGL");
  std::unique_ptr<GlView> view(new GlView);
  const auto open = [&]() -> base::Status {
    TRY(view->context_, open_gl());
    const auto find = [context = view->context_.get()](const char* name) {
      return context->find_function(name);
    };
    TRY(view->renderer_, render_gl::GlRenderer::make(find, look.palette, look.colormap));
    return base::Ok{};
  };
  base::Status opened = base::Ok{};
  view->run([&] { opened = open(); });
  if (!opened.ok()) return opened.error();
  return view;
}

GlView::~GlView() {
  run([this] {
    renderer_.reset();
    context_.reset();
  });
}

base::Result<render::FrameStats> GlView::draw(const render::Scene& scene, const render::Settings& settings,
                                              render::FrameBuffer& io_frame) {
  base::Result<render::FrameStats> drawn = render::FrameStats{};
  run([&] { drawn = renderer_->render(scene, settings, io_frame); });
  return drawn;
}

void GlView::make_blend_tables() const {
  renderer_->make_blend_tables();
}

void GlView::run(std::function<void()> work) {
  thread_.begin(std::move(work));
  thread_.wait();
}

}  // namespace temblor::host
