// Sounds to two channels of samples. Knows no clock, file or device: told how things are and what happens, it
// renders the frames that follow. The same calls give the same samples.
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
  std::size_t voices = 0;    // playing, heard or not
  std::size_t left_out = 0;  // starts that found no room, ever
};

struct MixerSettings {
  // For an audio callback, in which nothing may be freed: sounds that are done with are kept until
  // move_done_to().
  bool keep_done_sounds = false;
};

// Everything but its constructor asks the heap for nothing.
class Mixer {
 public:
  // Voices at a time. Over that, the original's rule: the one with the shortest rest makes room, but none of
  // the listener's own, and none that loops.
  static constexpr std::size_t kMaxVoices = 1024;
  static constexpr std::size_t kDelay_frames = Limiter::kDelay_frames;

  explicit Mixer(const MixerSettings& settings = {});

  // From now on things move towards how they are in `scene`, and arrive after `frames` (5 ms at least, so
  // that nothing clicks).
  void follow(const Scene& scene, std::size_t frames);
  // At the next frame to be rendered. Places are heard as the last `scene` has it.
  void happen(const SoundEvents& events);
  // The next frames, left and right in turn, at kFramesPerSecond, each -1 to 1. `music`: as many, or none.
  void render(std::span<float> out_samples, std::span<const float> music = {});

  // Moves kept sounds that are done with to the end of the list, as many as it has room for without growing.
  void move_done_to(std::vector<SoundPtr>& io_list);

  MixerStats stats() const { return {voices_.size(), left_out_}; }

 private:
  static constexpr std::size_t kBlock_frames = 256;
  // Those that fade out have room beside those that play.
  static constexpr std::size_t kMaxWithEnding = 2 * kMaxVoices;

  struct Ambient {
    SoundPtr sound;
    std::size_t position = 0;
    Glide level;  // 0 to 255
  };

  void take_ambients(const std::array<SoundPtr, kAmbients>& sounds);
  void start(const StartedSound& what);
  void start(const StaticSound& what);
  void stop(const StoppedSound& what);
  void replace(std::int32_t entity, int channel);
  void begin(Voice voice);
  bool make_room();
  std::size_t skip_of_duplicate(const SoundPtr& sound);
  void aim_ambient(std::size_t kind);
  void mix_ambient(Ambient& io_ambient, const EarBuffers& io_ears);
  void render_block(std::span<float> out_samples, std::span<const float> music);
  void remove_ended();
  void be_done_with(SoundPtr sound);

  MixerSettings settings_;
  Scene scene_;
  std::vector<Voice> voices_;
  std::vector<SoundPtr> done_;
  std::array<Ambient, kAmbients> ambients_;
  Glide sound_volume_, music_volume_;
  bool has_scene_ = false;
  Muffle muffle_;
  Limiter limiter_;
  std::uint64_t started_count_ = 0;
  std::size_t left_out_ = 0;
  std::array<float, kBlock_frames> left_{}, right_{};
};

}  // namespace temblor::audio
