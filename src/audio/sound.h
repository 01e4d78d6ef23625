// A sound in the form that the mixer plays: one channel of floating-point samples at the mixer's rate.
//
// make_sound() resamples once, when the sound is loaded, so mixing is a multiplication and an addition per
// sample and ear. Method: windowed sinc (libsamplerate), see sound.cpp. The original resamples without a
// filter, to the rate of its device.
//
//   start of the sound          loop.start                      loop.end
//   |--- plays once ------------|--- repeats until stopped -----|
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "formats/sounds/wav.h"

namespace temblor::audio {

// The mixer's rate, whatever the device's rate is; the device converts.
constexpr int kFramesPerSecond = 48000;
// Longer sounds are an error: one minute already takes 12 MB and half a second to resample, and music is
// streamed instead. LibreQuake's longest sound, a wind, lasts 32 s.
constexpr int kMaxSound_s = 60;
// In samples. Shorter loops are repeated until they are this long, so that mixing has little overhead per
// loop.
constexpr std::size_t kMinLoop = 1024;

struct SoundLoop {
  std::size_t start = 0, end = 0;  // sample indices; start < end <= samples.size()
};

struct Sound {
  std::string name;            // for subtitles and messages, for example "weapons/rocket1i.wav"
  std::vector<float> samples;  // -1 to 1, apart from the overshoot of resampling; may be empty
  // Playback jumps from `end` back to `start`. Sounds without a loop fade over their last few samples, so
  // that an abrupt end does not click.
  std::optional<SoundLoop> loop;
};

// Sounds never change after loading, so threads may share them.
using SoundPtr = std::shared_ptr<const Sound>;

// kAlways, for static and ambient sounds, adds a missing loop and blends its end into its beginning.
enum class Repeats { kAsInFile, kAlways };

// Resamples `wav` to kFramesPerSecond and mixes its channels into one. Frequencies above the new limit are
// filtered out; images are 90 dB down. A loop keeps its length to half a sample and has no seam. Fails on
// sounds longer than kMaxSound_s and on rates that libsamplerate refuses.
base::Result<SoundPtr> make_sound(const formats::Wav& wav, std::string name,
                                  Repeats repeats = Repeats::kAsInFile);

}  // namespace temblor::audio
