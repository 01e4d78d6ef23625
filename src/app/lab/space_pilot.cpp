#include "app/lab/space_pilot.h"

#include <cmath>

namespace temblor::app {

using math::Vec3d;
using platform::Key;

namespace {

// In units of the largest solid's radius, and seconds. Thrust and friction give a top speed of 20.
constexpr double kTurnRadS = 1.0, kThrust = 20, kFriction = 1;

}  // namespace

void SpacePilot::handle(const platform::InputEvent& event) {
  if (const auto* key = std::get_if<platform::KeyChange>(&event.what)) {
    held_[static_cast<std::size_t>(key->key)] = key->down;
    has_left_ |= key->key == Key::kEscape && key->down;
  } else if (const auto* focus = std::get_if<platform::FocusChanged>(&event.what)) {
    if (!focus->focused) held_.fill(false);
  } else if (std::holds_alternative<platform::CloseRequested>(event.what)) {
    has_left_ = true;
  }
}

void SpacePilot::fly(double seconds) {
  const double angle_rad = kTurnRadS * seconds;
  turn(axes_.forward, axes_.right, read_keys(Key::kRightArrow, Key::kLeftArrow) * angle_rad);
  turn(axes_.forward, axes_.up, read_keys(Key::kUpArrow, Key::kDownArrow) * angle_rad);
  turn(axes_.up, axes_.right, read_keys(Key{'d'}, Key{'a'}) * angle_rad);
  velocity_ += axes_.forward * (read_keys(Key{'w'}, Key{'s'}) * kThrust * seconds);
  velocity_ *= std::exp(-kFriction * seconds);
  place_ += velocity_ * seconds;
}

double SpacePilot::read_keys(Key positive, Key negative) const {
  return (held_[static_cast<std::size_t>(positive)] ? 1 : 0) -
         (held_[static_cast<std::size_t>(negative)] ? 1 : 0);
}

// Rounding would let the axes drift apart, so they are made orthonormal again.
void SpacePilot::turn(Vec3d& io_from, Vec3d& io_toward, double angle_rad) {
  if (angle_rad == 0) return;
  const Vec3d from = io_from;
  io_from = glm::normalize(from * std::cos(angle_rad) + io_toward * std::sin(angle_rad));
  io_toward = io_toward * std::cos(angle_rad) - from * std::sin(angle_rad);
  axes_.right = glm::normalize(glm::cross(axes_.forward, axes_.up));
  axes_.up = glm::cross(axes_.right, axes_.forward);
}

}  // namespace temblor::app
