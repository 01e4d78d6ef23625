#include "host/video/frame_limiter.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace temblor::host {
namespace {

constexpr double kNewWeight = 0.2;  // of a frame in the average
constexpr float kStep = 0.05f;
constexpr int kFramesToJudge = 5, kFramesToGrow = 60;
// Of the target: over the one it gets smaller, under the other larger. What is between them must hold a step:
// at the smallest scale one is a fifth of the pixels.
constexpr double kTooSlow = 0.95, kFastEnough = 0.7;

}  // namespace

void FrameLimiter::sleep_until(double due_s, double now_s) {
  if (due_s > now_s) std::this_thread::sleep_for(std::chrono::duration<double>(due_s - now_s));
}

float AutomaticScale::update(double drawing_s, double target_s) {
  ++frames_;
  average_s_ = frames_ == 1 ? drawing_s : average_s_ + (drawing_s - average_s_) * kNewWeight;
  if (target_s <= 0) return scale_ = 1;
  const bool is_too_slow = frames_ >= kFramesToJudge && average_s_ > target_s * kTooSlow;
  const bool has_room = frames_ >= kFramesToGrow && average_s_ < target_s * kFastEnough;
  const float wished = scale_ + (is_too_slow ? -kStep : has_room ? kStep : 0.0f);
  const float scale = std::clamp(wished, kSmallest, 1.0f);
  if (scale != scale_) frames_ = 0;
  return scale_ = scale;
}

}  // namespace temblor::host
