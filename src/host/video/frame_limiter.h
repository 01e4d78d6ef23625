// Frame rate limit and dynamic resolution.
//
//   FrameLimiter     sleeps until the next frame is due
//   AutomaticScale   drawing time of each frame -> moving average -> resolution scale of the next frame
//
// The drawing time grows with the number of pixels, the square of the scale. There is no model of that here:
// the scale moves in small steps until the average is inside a band below the target time.
#pragma once

namespace temblor::host {

// Waits so that frames start at an even rate.
class FrameLimiter {
 public:
  // Returns when the next frame is due. The result is true if there was time to wait. `now_s` returns the
  // current time of a steady clock, in seconds; 0 frames per second: no limit.
  template <typename Clock>
  bool wait(double frames_per_second, const Clock& now_s) {
    const double now = now_s();
    if (frames_per_second <= 0) return false;
    const double frame_s = 1 / frames_per_second;
    due_s_ += frame_s;
    // After a slow frame, start a new rhythm instead of catching up with a burst of frames. The same applies
    // if the limit was raised, which leaves due_s_ too far in the future.
    if (due_s_ < now || due_s_ > now + 2 * frame_s) due_s_ = now;
    sleep_until(due_s_, now);
    return due_s_ > now;
  }

 private:
  static void sleep_until(double due_s, double now_s);
  double due_s_ = 0;  // when the last frame was due
};

// Dynamic resolution: the scale of the frame that holds a frame time. It shrinks soon after frames become too
// slow, and grows only after a while, so that the picture does not pump.
class AutomaticScale {
 public:
  static constexpr float kMinScale = 0.5f;
  // Call it after each frame with its drawing time. Returns the scale for the next frame, from kMinScale
  // to 1. A target of 0 seconds or less switches scaling off.
  float update(double drawing_s, double target_s);
  float scale() const { return scale_; }

 private:
  float scale_ = 1;
  double average_s_ = 0;  // drawing time, exponentially smoothed
  int frames_ = 0;        // since the last change
};

}  // namespace temblor::host
