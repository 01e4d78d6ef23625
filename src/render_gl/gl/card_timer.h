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

  // From begin() to end() is one time. A second begin() before end() does nothing, and so does end() without
  // begin().
  void begin(const Functions& gl);
  void end(const Functions& gl);
  // The last time that the card has reported, in seconds. Nothing before the first one, and always on cards
  // without a timer.
  std::optional<double> seconds() const { return seconds_; }

 private:
  struct Measurement {
    Query query;
    bool is_pending = false;
  };
  void take_results(const Functions& gl);

  // More than the frames that drivers let wait. Empty queries: no timer.
  std::array<Measurement, 4> measurements_;
  std::size_t next_ = 0;
  bool is_running_ = false;
  std::optional<double> seconds_;
};

}  // namespace temblor::render_gl
