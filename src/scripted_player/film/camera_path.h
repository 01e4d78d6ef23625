// The flight of a camera through the places of a shot. Method: cubic Hermite curves with the slopes of a
// Catmull-Rom spline for uneven times (Edwin Catmull and Raphael Rom, "A class of local interpolating
// splines", 1974), for the place and for the point that the camera looks at.
#pragma once

#include <optional>

#include "math/vec.h"
#include "scripted_player/film/film_script.h"

namespace temblor::player {

struct CameraPose {
  math::Vec3 place_world{0.0f};
  math::Vec3 angles_deg{0.0f};
};

class CameraPath {
 public:
  // The shot, which must be a flight, must outlive the path.
  explicit CameraPath(const Shot& shot) : shot_(shot) {}

  // The pose at a time. A camera that looks at the player follows slowly, so call this tick by tick.
  CameraPose advance(double time_s, const math::Vec3& player_world);

 private:
  const Shot& shot_;
  // The player's place, smoothed.
  std::optional<math::Vec3> followed_world_;
  double last_time_s_ = 0;
};

}  // namespace temblor::player
