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

void CardTimer::begin(const Functions& gl) {
  if (is_running_ || !measurements_[next_].query) return;
  take_results(gl);
  if (measurements_[next_].is_pending) return;  // this frame is not measured
  gl.BeginQuery(GL_TIME_ELAPSED_EXT, measurements_[next_].query.name());
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
  constexpr double kSecondsPerNanosecond = 1e-9;
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    Measurement& each = measurements_[(next_ + i) % measurements_.size()];
    if (!each.is_pending) continue;
    GLuint is_available = GL_FALSE, nanoseconds = 0;
    gl.GetQueryObjectuiv(each.query.name(), GL_QUERY_RESULT_AVAILABLE, &is_available);
    if (is_available == GL_FALSE) return;
    gl.GetQueryObjectuiv(each.query.name(), GL_QUERY_RESULT, &nanoseconds);
    each.is_pending = false;
    seconds_ = nanoseconds * kSecondsPerNanosecond;
  }
}

}  // namespace temblor::render_gl
