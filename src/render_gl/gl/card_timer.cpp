#include "render_gl/gl/card_timer.h"

namespace temblor::render_gl {

CardTimer::CardTimer(const Functions& gl) {
  if (!gl.has_timer) return;
  for (Measurement& each : measurements_) {
    GLuint name = 0;
    gl.GenQueries(1, &name);
    each.query = Query(gl, name);
  }
}

void CardTimer::begin(const Functions& gl, const FrameSize& size) {
  end(gl);
  if (size != size_) seconds_.reset();
  size_ = size;
  Measurement& next = measurements_[next_];
  if (!next.query) return;
  take_results(gl);
  if (next.is_pending) return;  // this frame is not measured
  next.size = size;
  gl.BeginQuery(GL_TIME_ELAPSED_EXT, next.query.name());
  is_running_ = true;
}

void CardTimer::end(const Functions& gl) {
  if (!is_running_) return;
  gl.EndQuery(GL_TIME_ELAPSED_EXT);
  is_running_ = false;
  measurements_[next_].is_pending = true;
  next_ = (next_ + 1) % measurements_.size();
}

// From the oldest one on, until one has no result yet.
void CardTimer::take_results(const Functions& gl) {
  GLint is_disjoint = GL_FALSE;  // the card's clock has changed meanwhile
  if (gl.has_disjoint_timer) gl.GetIntegerv(GL_GPU_DISJOINT_EXT, &is_disjoint);
  constexpr double kSecondsPerNanosecond = 1e-9;
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    Measurement& each = measurements_[(next_ + i) % measurements_.size()];
    if (!each.is_pending) continue;
    GLuint is_available = GL_FALSE, nanoseconds = 0;
    gl.GetQueryObjectuiv(each.query.name(), GL_QUERY_RESULT_AVAILABLE, &is_available);
    if (is_available == GL_FALSE) return;
    gl.GetQueryObjectuiv(each.query.name(), GL_QUERY_RESULT, &nanoseconds);
    each.is_pending = false;
    if (each.size == size_ && is_disjoint == GL_FALSE) seconds_ = nanoseconds * kSecondsPerNanosecond;
  }
}

}  // namespace temblor::render_gl
