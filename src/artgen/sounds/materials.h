// Things that ring when they are struck: each a set of resonances, as its shape and stuff have them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/sounds/signal.h"

namespace temblor::artgen {

struct SoundMaterial {
  std::string_view name;
  std::vector<double> ratios;  // of the resonances to the lowest
  double ring_s = 1;           // until the lowest has lost 60 dB
  double damping = 1;          // a resonance of ratio r rings r^-damping as long
};
std::span<const SoundMaterial> materials();
// Null where there is none.
const SoundMaterial* find_material(std::string_view name);
// "bell, bone, ...", for messages.
std::string material_names();

// Resonances of a material around `pitch`, side by side. Struck by a sample of 1, each begins at its share
// of 1.
class Resonances {
 public:
  struct Settings {
    double pitch = 440, ring_s = 1;
    double spread = 0;  // how far each is mistuned, as a part of its frequency; by `seed`
    std::uint64_t seed = 0;
  };
  Resonances(const SoundMaterial& material, const Settings& settings, double rate);
  double step(double sample);

 private:
  struct Mode {
    double feedback = 0, loss = 0, gain = 0, last = 0, before = 0;
  };
  std::vector<Mode> modes_;
};

}  // namespace temblor::artgen
