// Mixes sounds into two channels of samples.
//
// The mixer knows no clock, file or device: it receives the scene and the events of the game, and renders the
// frames that follow. The same calls return the same samples, so videos and tests use it as well as a sound
// device.
//
//   SoundEvents -> voices -> per-ear gains (mixing/spatial.h) -> sum -> muffle -> volume, + music -> limiter
//   -> out
//
// Every gain moves along a straight line (Glide), so no change clicks. The output is Limiter::kDelay_frames
// late.
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
  std::size_t voices = 0;    // that play, audible or not
  std::size_t left_out = 0;  // sounds that found no free voice, since the mixer was made
};

struct MixerSettings {
  // For an audio callback, which must not free memory: finished sounds are kept until move_finished_to().
  bool keep_finished_sounds = false;
};

// Not thread-safe; LiveMixer connects it to a device. Only the constructor allocates memory.
class Mixer {
 public:
  // Voices that play at the same time. Beyond that, the voice with the least time left ends, but never one of
  // the listener's or one that loops (the original's rule).
  static constexpr std::size_t kMaxVoices = 1024;
  static constexpr std::size_t kDelay_frames = Limiter::kDelay_frames;

  explicit Mixer(const MixerSettings& settings = {});

  // Positions and volumes move to those of `scene` within `frames`, and within 5 ms at least so that nothing
  // clicks.
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
    SoundPtr sound;  // null: none of this kind
    std::size_t position = 0;
    Glide level;  // 0 to 255
  };

  void replace_ambients(const std::array<SoundPtr, kAmbients>& sounds);
  void start(const StartedSound& started);
  void start(const StaticSound& started);
  void stop(const StoppedSound& stopped);
  void replace(std::int32_t entity, int channel);
  void begin(Voice voice);
  bool make_room();
  std::size_t choose_duplicate_skip(const SoundPtr& sound);
  void retarget_ambient(std::size_t kind);
  void mix_ambient(Ambient& io_ambient, const EarBuffers& io_ears);
  void render_block(std::span<float> out_samples, std::span<const float> music);
  void remove_ended();
  void retire_sound(SoundPtr sound);

  MixerSettings settings_;
  Scene scene_;
  std::vector<Voice> voices_;       // in no order
  std::vector<SoundPtr> finished_;  // kept for move_finished_to()
  std::array<Ambient, kAmbients> ambients_;
  Glide sound_volume_, music_volume_;
  bool has_scene_ = false;  // the first scene applies at once
  Muffle muffle_;
  Limiter limiter_;
  std::uint64_t started_count_ = 0;
  std::size_t left_out_ = 0;
  std::array<float, kBlock_frames> left_{}, right_{};
};

}  // namespace temblor::audio
