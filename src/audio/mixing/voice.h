// A voice: one sound that plays, its position, its loudness in each ear, and its fades.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "audio/mixing/spatial.h"
#include "audio/scene.h"

namespace temblor::audio {

// A value that moves to its target along a straight line.
class Glide {
 public:
  Glide() = default;
  explicit Glide(float value) : value_(value), target_(value) {}

  float value() const { return value_; }
  float target() const { return target_; }
  float step() const { return step_; }  // change per frame
  std::size_t frames_left() const { return frames_left_; }
  bool is_silent() const { return value_ == 0 && target_ == 0; }

  void go_to(float target, std::size_t frames);
  void pass(std::size_t frames);  // advances; at most frames_left() unless that is 0

 private:
  float value_ = 0, target_ = 0, step_ = 0;
  std::size_t frames_left_ = 0;
};

enum class VoiceKind : std::uint8_t { kStarted, kStatic };

struct Voice {
  SoundPtr sound;
  std::size_t position = 0;  // index of the next sample
  VoiceKind kind = VoiceKind::kStarted;
  std::int32_t entity = kNoEntity;
  int channel = kFreeChannel;
  math::Vec3 origin_world{0.0f};
  float volume = 1, attenuation = 1;
  Glide left{}, right{};  // gains from the position
  Glide fade{1};          // the fade in and out
  std::uint64_t number = 0;
  bool is_new = true;      // no frame has been played yet
  bool is_ending = false;  // fades out and then ends
  bool has_ended = false;

  bool is_silent() const { return (left.is_silent() && right.is_silent()) || fade.is_silent(); }
  // Frames until it ends; the largest std::size_t if it loops.
  std::size_t frames_left() const;
};

// The two channels of a block; both have the same length.
struct EarBuffers {
  std::span<float> left, right;
};

// Sets the gains for this listener, at once or over `frames`.
void place_voice(Voice& io_voice, const Listener& listener);
void move_voice(Voice& io_voice, const Listener& listener, std::size_t frames);
void fade_in(Voice& io_voice);
void end_voice(Voice& io_voice);
// Adds the next samples to `io_ears` and advances the voice.
void mix_voice(Voice& io_voice, const EarBuffers& io_ears);

}  // namespace temblor::audio
