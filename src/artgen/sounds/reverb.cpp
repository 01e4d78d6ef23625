#include "artgen/sounds/reverb.h"

#include <cmath>

namespace temblor::artgen {

Reverb::Reverb(const Settings& settings, double rate) {
  // The delays are powers of a ratio, with odd lengths in samples, so that few echoes coincide.
  double length_s = 0.011 + 0.04 * settings.size;
  for (Line& line : lines_) {
    line.samples.assign(count_frames(length_s, rate) | 1, 0.0);
    // The gain of one pass through the line, so that echoes have lost 60 dB (a factor of 10^-3) after ring_s.
    line.gain = std::pow(10.0, -3 * static_cast<double>(line.samples.size()) / (settings.ring_s * rate));
    line.lowpass.set(settings.damping_hz, rate);
    length_s *= 1.137;
  }
}

Reverb::Echoes Reverb::step(double sample) {
  std::array<double, kLines> out{};
  double sum = 0;
  for (std::size_t k = 0; k < kLines; ++k) {
    Line& line = lines_[k];
    out[k] = line.lowpass.step(line.samples[line.at]) * line.gain;
    sum += out[k];
  }
  // A Householder reflection: out - 2 / N * sum for every line. The matrix is orthogonal, so the energy does
  // not change.
  const double reflected = sum * 2 / static_cast<double>(kLines);
  Echoes echoes;
  for (std::size_t k = 0; k < kLines; ++k) {
    Line& line = lines_[k];
    line.samples[line.at] = sample + out[k] - reflected;
    line.at = line.at + 1 < line.samples.size() ? line.at + 1 : 0;
    // Different lines and signs for both sides make the echoes sound wide.
    (k % 2 == 0 ? echoes.left : echoes.right) += (k % 4 < 2 ? out[k] : -out[k]);
  }
  echoes.left *= 0.5;
  echoes.right *= 0.5;
  return echoes;
}

}  // namespace temblor::artgen
