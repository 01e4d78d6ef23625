// Mixes sounds into two channels of samples.
//
// The mixer knows no clock, file or device: it receives the scene and the events of the game, and renders the
// frames that follow. The same calls return the same samples, so videos and tests use it as well as a sound
// device.
//
//   SoundEvents -> voices -> per-ear gains (mixing/spatial.h) -> focus (mixing/focus.h) -> sum -> muffle
//   -> volume, + music -> limiter -> out
//
// Every gain moves along a straight line (Glide), so no change clicks. The output is Limiter::kDelay_frames
// late. Ambient sounds bypass the voices: they have no position, only a level that fades.
//
// The rules of loudness, replacement and ambient sounds are those of the original. Unlike the original, which
// mixes 8 dynamic sounds and clips the sum, this mixer plays up to kMaxVoices sounds and limits the sum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "audio/mixing/limiter.h"
#include "audio/mixing/muffle.h"
#include "audio/mixing/voice.h"
#include "audio/scene.h"

namespace temblor::audio {

struct MixerStats {
  // Current voices, audible or not, including those that fade out. Ambient sounds are not counted.
  std::size_t voices = 0;
  std::size_t left_out = 0;  // sounds that found no free voice since the mixer was made
};

struct MixerSettings {
  // For an audio callback, which must not free memory: finished sounds are kept until move_finished_to().
  // Otherwise the mixer releases them as soon as they end.
  bool keep_finished_sounds = false;
};

// Not thread-safe; LiveMixer connects it to a device. Only the constructor allocates memory.
class Mixer {
 public:
  // The maximum number of voices that play at the same time. A further sound ends the voice with the least
  // time left, but never a looping voice or one of the listener's (the original's rule).
  static constexpr std::size_t kMaxVoices = 1024;
  static constexpr std::size_t kDelay_frames = Limiter::kDelay_frames;

  explicit Mixer(const MixerSettings& settings = {});

  // Moves positions and volumes to those of `scene` over `frames`, or over 5 ms if that is longer, so that
  // nothing clicks. The first scene applies its volumes at once.
  void set_scene(const Scene& scene, std::size_t frames);
  // Starts and stops sounds at the next frame to be rendered, heard from the listener of the last
  // set_scene().
  void handle_events(const SoundEvents& events);
  // Renders the next frames at kFramesPerSecond, left and right interleaved, each from -1 to 1. `music` is
  // empty or has as many samples. CHECKs that the number of samples is even.
  void render(std::span<float> out_samples, std::span<const float> music = {});

  // Moves finished sounds to the end of `io_list`, as many as fit without growing it.
  void move_finished_to(std::vector<SoundPtr>& io_list);

  MixerStats stats() const { return {voices_.size(), left_out_}; }

 private:
  static constexpr std::size_t kBlock_frames = 256;
  // Voices that fade out do not count as playing, but need a place.
  static constexpr std::size_t kMaxWithEnding = 2 * kMaxVoices;

  struct Ambient {
    SoundPtr sound;            // null: none of this kind
    std::size_t position = 0;  // index of the next sample
    Glide level;               // 0 to 255
  };

  void replace_ambients(const std::array<SoundPtr, kAmbients>& sounds);
  void start(const StartedSound& started);
  void start(const StaticSound& started);
  void stop(const StoppedSound& stopped);
  bool is_threat(const StartedSound& started) const;
  void end_replaced_voice(std::int32_t entity, int channel);
  void add_voice(Voice voice);
  bool make_room();
  std::size_t choose_duplicate_skip(const SoundPtr& sound);
  void update_ambient_target(std::size_t kind);
  void mix_ambient(Ambient& io_ambient, const EarBuffers& io_ears);
  void render_block(std::span<float> out_samples, std::span<const float> music);
  void remove_ended();
  void retire_sound(SoundPtr sound);

  MixerSettings settings_;
  Scene scene_;
  std::vector<Voice> voices_;       // unordered; never grows beyond its reserved memory
  std::vector<SoundPtr> finished_;  // kept for move_finished_to()
  std::array<Ambient, kAmbients> ambients_;
  Glide sound_volume_, music_volume_;
  bool has_scene_ = false;  // false until the first scene, which applies at once
  Muffle muffle_;
  Limiter limiter_;
  // The number of the newest voice; orders voices by age and seeds choose_duplicate_skip().
  std::uint64_t started_count_ = 0;
  std::size_t left_out_ = 0;
  std::array<float, kBlock_frames> left_{}, right_{};
};

}  // namespace temblor::audio
