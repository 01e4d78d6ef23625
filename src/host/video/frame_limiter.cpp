#include "host/video/frame_limiter.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace temblor::host {
namespace {

constexpr double kNewWeight = 0.2;  // of the newest frame in the average
constexpr float kStep = 0.05f;
// Frames since the last change. Shrinking must be quick, because slow frames are what the player notices;
// growing waits about a second.
constexpr int kMinFramesToShrink = 5, kMinFramesToGrow = 60;
// Fractions of the target time. Above the first the scale shrinks, below the second it grows. The gap between
// them must be larger than the effect of one step, or the scale would oscillate: at kMinScale a step changes
// the number of pixels by a fifth.
constexpr double kTooSlow = 0.95, kFastEnough = 0.7;

}  // namespace

void FrameLimiter::sleep_until(double due_s, double now_s) {
  if (due_s > now_s) std::this_thread::sleep_for(std::chrono::duration<double>(due_s - now_s));
}

// A change of the scale restarts the average: times at the old scale say nothing about the new one.
float AutomaticScale::update(double drawing_s, double target_s) {
  ++frames_;
  average_s_ = frames_ == 1 ? drawing_s : average_s_ + (drawing_s - average_s_) * kNewWeight;
  if (target_s <= 0) return scale_ = 1;
  const bool is_too_slow = frames_ >= kMinFramesToShrink && average_s_ > target_s * kTooSlow;
  const bool has_room = frames_ >= kMinFramesToGrow && average_s_ < target_s * kFastEnough;
  const float wanted = scale_ + (is_too_slow ? -kStep : has_room ? kStep : 0.0f);
  const float scale = std::clamp(wanted, kMinScale, 1.0f);
  if (scale != scale_) frames_ = 0;
  return scale_ = scale;
}

}  // namespace temblor::host
