// A sound as the mixer plays it: one channel of floating-point samples at the mixer's own rate.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "formats/sounds/wav.h"

namespace temblor::audio {

// What the mixer makes, whatever the device; devices convert.
constexpr int kFramesPerSecond = 48000;
// A sound that lasts longer is an error: it would be 12 MB and half a second of resampling, and music is
// played otherwise. The longest of LibreQuake, a wind, lasts for 32 s.
constexpr int kMaxSound_s = 60;
// A loop that is shorter is written out several times, or mixing it would be all beginnings.
constexpr std::size_t kMinLoop = 1024;  // samples

struct SoundLoop {
  std::size_t start = 0, end = 0;  // start < end <= samples.size()
};

struct Sound {
  std::string name;            // for who wants to say what is heard: "weapons/rocket1i.wav"
  std::vector<float> samples;  // -1 to 1, but for what resampling overshoots; may be empty
  // Played from its beginning, then from `end` on again at `start`. Without: the last few samples fade, so
  // that a sound that breaks off does not click.
  std::optional<SoundLoop> loop;
};

// Loaded sounds are shared and const.
using SoundPtr = std::shared_ptr<const Sound>;

// kAlways: one without a loop is made to loop, its end blended into its beginning.
enum class Repeats { kAsTheFileSays, kAlways };

// Resampled to kFramesPerSecond, several channels folded into one. Frequencies that the rate cannot hold are
// filtered out, images are 90 dB down. A loop stays as long as it was, to half a sample, and without a seam.
base::Result<SoundPtr> make_sound(const formats::Wav& wav, std::string name,
                                  Repeats repeats = Repeats::kAsTheFileSays);

}  // namespace temblor::audio
