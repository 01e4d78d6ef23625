// Measures how long the card draws, by queries whose results come some frames later; nothing waits for them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

class CardTimer {
 public:
  explicit CardTimer(const Functions& gl);

  struct FrameSize {
    int width = 0, height = 0;
    bool operator==(const FrameSize&) const = default;
  };
  // From begin() to end() is one time. begin() ends an older one; end() without begin() does nothing.
  void begin(const Functions& gl, const FrameSize& size);
  void end(const Functions& gl);
  // The last time that the card has reported, in seconds. Nothing before the first one of the last frame's
  // size, and always on cards without a timer.
  std::optional<double> seconds() const { return seconds_; }

 private:
  struct Measurement {
    Query query;
    FrameSize size;
    bool is_pending = false;
  };
  void take_results(const Functions& gl);

  // More than the frames that drivers let wait. Empty queries: no timer.
  std::array<Measurement, 4> measurements_;
  std::size_t next_ = 0;
  bool is_running_ = false;
  FrameSize size_;  // of the last frame
  std::optional<double> seconds_;
};

}  // namespace temblor::render_gl
