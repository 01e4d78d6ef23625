// The numbers that movement depends on. They are here because movement, which applies them, and net, which
// sends them to clients that predict their own moves, may not include each other.
#pragma once

namespace temblor::math {

// Each is a console variable of the server ("sv_gravity" and so on; edge_friction is "edgefriction"). The
// defaults are those of the original game.
struct PhysicsSettings {
  float gravity = 800;        // units per second squared, downward
  float max_velocity = 2000;  // units per second along each axis
  float friction = 4;         // share of the speed that a walking player loses per second
  float edge_friction = 2;    // factor on friction just before a drop
  float stop_speed = 100;     // units per second; below it, friction is as strong as at this speed
  float accelerate = 10;      // share of the wished speed that a player gains per second
  float max_speed = 320;      // units per second, of a player's own wish to move
  bool no_step = false;       // players cannot climb steps
  bool operator==(const PhysicsSettings&) const = default;
};

}  // namespace temblor::math
