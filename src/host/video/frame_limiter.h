// How fast frames follow one another, and how large they may be for that.
#pragma once

namespace temblor::host {

// Waits so that frames come at an even rate. Input is read after the wait, so that it does not grow old.
class FrameLimiter {
 public:
  // Returns when the next frame is due, and whether there was time to wait. `now_s` tells the time of the
  // same steady clock at any moment.
  template <typename Clock>
  bool wait(double frames_per_second, const Clock& now_s) {
    const double now = now_s();
    if (frames_per_second <= 0) return false;
    const double frame_s = 1 / frames_per_second;
    due_s_ += frame_s;
    // After a hitch frames are not made good.
    if (due_s_ < now || due_s_ > now + 2 * frame_s) due_s_ = now;
    sleep_until(due_s_, now);
    return due_s_ > now;
  }

 private:
  static void sleep_until(double due_s, double now_s);
  double due_s_ = 0;
};

// The render scale that holds a frame time: smaller at once when frames take too long, larger again only
// after a while.
class AutomaticScale {
 public:
  static constexpr float kSmallest = 0.5f;
  // After each frame: what it took to draw. Returns the scale for the next one, from kSmallest to 1.
  float update(double drawing_s, double target_s);
  float scale() const { return scale_; }

 private:
  float scale_ = 1;
  double average_s_ = 0;
  int frames_ = 0;  // since the last change
};

}  // namespace temblor::host
