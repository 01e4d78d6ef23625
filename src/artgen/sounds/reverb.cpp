#include "artgen/sounds/reverb.h"

#include <cmath>

namespace temblor::artgen {

Reverb::Reverb(const Settings& settings, double rate) {
  // Times in proportions that share no multiples: powers of a ratio, and a little more each.
  double length_s = 0.011 + 0.04 * settings.size;
  for (Line& line : lines_) {
    line.samples.assign(frames_in(length_s, rate) | 1, 0.0);
    line.kept = std::pow(10.0, -3 * static_cast<double>(line.samples.size()) / (settings.ring_s * rate));
    line.wall.set(settings.dull_hz, rate);
    length_s *= 1.137;
  }
}

Reverb::Echoes Reverb::step(double sample) {
  std::array<double, kLines> out{};
  double sum = 0;
  for (std::size_t k = 0; k < kLines; ++k) {
    Line& line = lines_[k];
    out[k] = line.wall.step(line.samples[line.at]) * line.kept;
    sum += out[k];
  }
  // Every line gets all others, as a mirror across the diagonal gives them: no energy is made or lost.
  const double reflected = sum * 2 / static_cast<double>(kLines);
  Echoes echoes;
  for (std::size_t k = 0; k < kLines; ++k) {
    Line& line = lines_[k];
    line.samples[line.at] = sample + out[k] - reflected;
    line.at = line.at + 1 < line.samples.size() ? line.at + 1 : 0;
    (k % 2 == 0 ? echoes.left : echoes.right) += (k % 4 < 2 ? out[k] : -out[k]);
  }
  echoes.left *= 0.5;
  echoes.right *= 0.5;
  return echoes;
}

}  // namespace temblor::artgen
