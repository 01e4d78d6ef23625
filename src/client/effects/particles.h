// Particles: where each is at a moment, from how it was born.
//
// The original stepped velocities and positions once a frame, so its explosions grew larger at higher frame
// rates. Here its laws of motion (change of velocity a second) are solved: a particle is kept as it was born,
// and its place is a function of its age. It does not matter how often that is asked for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

// The laws, as changes a second. Gravity is 40 units/s^2; a ramp is a row of colors that is walked through.
enum class ParticleMotion : std::uint8_t {
  kStill,     // its velocity stays
  kFalling,   // gravity
  kFire,      // rises as fast as others fall; ramp of 6, 5 a second
  kExplode,   // velocity + 4 x velocity, gravity; ramp of 8, 10 a second
  kExplode2,  // velocity - velocity, gravity; ramp of 8, 15 a second
  kBlob,      // velocity + 4 x velocity, gravity
  kBlob2      // horizontal velocity - 4 x velocity, gravity
};
constexpr std::size_t kParticleMotions = 7;

struct ParticleBirth {
  math::Vec3 origin_world{0.0f}, velocity{0.0f};  // units, units a second
  double born_s = 0;
  float life_s = 0;  // 0: for one moment. The end of its ramp may come first
  ParticleMotion motion{};
  std::uint8_t color = 0;  // palette index, when the motion has no ramp
  float ramp = 0;          // where it starts on its ramp, in steps
};

class ParticlePool {
 public:
  // At most that many live at once. A lower number removes none: fewer are taken until enough have died.
  void set_capacity(std::size_t capacity);
  void clear();

  // False, and counted, when there is no room for it.
  bool add(const ParticleBirth& birth);
  std::size_t room() const { return capacity_ > size() ? capacity_ - size() : 0; }
  // To be counted as left out without having been tried one by one.
  void leave_out(std::size_t count) { left_out_ += count; }

  // Removes those whose life is over, and moves the others to where they are at `time_s`. Particles added
  // after it are in the cloud from the next place_new() or advance() on.
  void advance(double time_s);
  void place_new(double time_s);

  // Valid until anything changes.
  render::ParticleCloud cloud() const;
  std::size_t size() const { return born_s_.size(); }
  std::size_t left_out() const { return left_out_; }  // since the beginning or clear()

 private:
  void place(std::size_t first, double time_s);
  void keep(std::size_t from, std::size_t to);
  void resize(std::size_t size);

  std::size_t capacity_ = 0, placed_ = 0, left_out_ = 0;
  // As they were born.
  std::array<std::vector<float>, 3> origin_, velocity_;
  std::vector<double> born_s_;
  std::vector<float> life_s_, ramp_;
  std::vector<ParticleMotion> motion_;
  std::vector<std::uint8_t> born_color_;
  // As they are.
  std::array<std::vector<float>, 3> place_;
  std::vector<std::uint8_t> color_;
};

}  // namespace temblor::client
