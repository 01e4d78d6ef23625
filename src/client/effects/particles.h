// The particle pool. Each particle's place is computed from the values with which it was added, and from its
// age.
//
// The original integrated velocities once a frame, so its explosions grew with the frame rate. Here the same
// laws of motion (change of velocity per second) are solved in closed form, so that the result does not
// depend on when and how often it is computed.
//
// The pool is a structure of arrays: particle i has element i in each. Removal closes the gaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

// The laws, as changes per second. Gravity is 40 units/s^2, that of bodies 800. A ramp is a row of colors
// that the particle runs through.
enum class ParticleMotion : std::uint8_t {
  kStill,     // constant velocity
  kFalling,   // gravity
  kFire,      // rises as fast as others fall; ramp of 6 colors, 5 a second
  kExplode,   // velocity + 4 x velocity, gravity; ramp of 8 colors, 10 a second
  kExplode2,  // velocity - velocity, gravity; ramp of 8 colors, 15 a second
  kBlob,      // velocity + 4 x velocity, gravity
  kBlob2,     // horizontal velocity - 4 x velocity, gravity
  kSpark,     // velocity - 3 x velocity, gravity of bodies; ramp of 8 colors, 16 a second
  kDrop       // gravity of bodies
};
constexpr std::size_t kParticleMotions = 9;

// A particle at the time at which it is added.
struct ParticleSpawn {
  math::Vec3 origin_world{0.0f}, velocity{0.0f};  // units, units per second
  double born_s = 0;
  float life_s = 0;  // 0: for one frame. The end of the ramp may come first
  ParticleMotion motion{};
  std::uint8_t color = 0;  // palette index, for motions without a ramp
  float ramp = 0;          // start on the ramp, in colors
};

class ParticlePool {
 public:
  // Sets the maximum number of particles. A lower number removes none; new ones are dropped until enough have
  // died.
  void set_capacity(std::size_t capacity);
  void clear();

  // Adds a particle. If the pool is full, returns false and counts the particle as dropped.
  bool add(const ParticleSpawn& particle);
  std::size_t room() const { return capacity_ > size() ? capacity_ - size() : 0; }
  // Counts particles as dropped that the caller did not try to add.
  void count_dropped(std::size_t count) { dropped_ += count; }

  // Removes dead particles and moves the others to their places at `time_s`. Particles that are added later
  // appear after the next place_new() or advance().
  void advance(double time_s);
  void place_new(double time_s);

  // The particles to draw. Valid until anything changes.
  render::ParticleCloud cloud() const;
  std::size_t size() const { return born_s_.size(); }
  std::size_t dropped() const { return dropped_; }  // since clear()

 private:
  void place(std::size_t first, double time_s);
  void move_particle(std::size_t from, std::size_t to);
  void resize(std::size_t size);

  std::size_t capacity_ = 0, placed_ = 0, dropped_ = 0;
  // Constant values from add(); x, y and z separately.
  std::array<std::vector<float>, 3> origin_, velocity_;
  std::vector<double> born_s_;
  std::vector<float> life_s_, ramp_;
  std::vector<ParticleMotion> motion_;
  std::vector<std::uint8_t> born_color_;
  // Values at the time of the last advance() or place_new(), for cloud().
  std::array<std::vector<float>, 3> place_;
  std::vector<std::uint8_t> color_;
};

}  // namespace temblor::client
