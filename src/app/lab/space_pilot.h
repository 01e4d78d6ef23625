// The player's flight through the space battle.
#pragma once

#include <array>

#include "math/angles.h"
#include "math/vec.h"
#include "platform/input_event.h"

namespace temblor::app {

// For the window's title and the terminal.
constexpr const char* kSpaceKeys = "arrows turn, W and S thrust, A and D roll, Escape leaves";

class SpacePilot {
 public:
  SpacePilot(const math::Vec3d& place, const math::Basis& axes) : place_(place), axes_(axes) {}

  void handle(const platform::InputEvent& event);
  // Turns while a key is held, and glides: space has little friction.
  void fly(double seconds);

  const math::Vec3d& place() const { return place_; }
  const math::Basis& axes() const { return axes_; }
  bool has_left() const { return has_left_; }

 private:
  // 1, -1, or 0 if neither or both keys are held.
  double read_keys(platform::Key positive, platform::Key negative) const;
  void turn(math::Vec3d& io_from, math::Vec3d& io_toward, double angle_rad);

  math::Vec3d place_, velocity_{0.0};
  math::Basis axes_;
  std::array<bool, platform::kKeys> held_{};
  bool has_left_ = false;
};

}  // namespace temblor::app
