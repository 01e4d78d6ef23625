// A voice: one sound that plays, its position, its loudness in each ear, and its fades.
//
//   gain of an ear = Glide of the ear (position, volume, listener) * fade (start and end) * focus (focus.h)
//
// A voice fades in, plays, and ends either with its samples or with a fade-out after end_voice(). The mixer
// owns the voices and removes those that have ended.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "audio/mixing/spatial.h"
#include "audio/scene.h"

namespace temblor::audio {

// A linear ramp: a value that moves to its target at a constant rate per frame.
class Glide {
 public:
  Glide() = default;
  explicit Glide(float value) : value_(value), target_(value) {}

  float value() const { return value_; }
  float target() const { return target_; }
  float step() const { return step_; }  // change per frame
  std::size_t frames_left() const { return frames_left_; }
  bool is_silent() const { return value_ == 0 && target_ == 0; }

  // Starts a ramp from the current value. 0 frames: jumps there.
  void go_to(float target, std::size_t frames);
  // Precondition: frames <= frames_left(), or the value stands still.
  void advance(std::size_t frames);

 private:
  float value_ = 0, target_ = 0, step_ = 0;
  std::size_t frames_left_ = 0;
};

// Static voices belong to no entity: they are never replaced or stopped one by one.
enum class VoiceKind : std::uint8_t { kStarted, kStatic };

struct Voice {
  SoundPtr sound;
  std::size_t position = 0;  // index of the next sample
  VoiceKind kind = VoiceKind::kStarted;
  std::int32_t entity = kNoEntity;
  int channel = kFreeChannel;
  math::Vec3 origin_world{0.0f};
  float volume = 1, attenuation = 1;
  bool is_threat = false;    // see StartedSound
  Glide left{}, right{};     // gains from the position
  Glide fade{1};             // the fade in and out
  Glide focus{1};            // softens threats that are not the nearest
  float closeness = 0;       // 1 at the listener, 0 at 1000 units or more
  std::uint64_t number = 0;  // orders voices by age; the oldest has the lowest number
  bool is_new = true;        // no frame has been played yet
  bool is_ending = false;    // fades out and then ends
  bool has_ended = false;

  bool is_silent() const { return (left.is_silent() && right.is_silent()) || fade.is_silent(); }
  // Frames until it ends; the largest std::size_t if it loops.
  std::size_t frames_left() const;
};

// The two channels of a block; both have the same length.
struct EarBuffers {
  std::span<float> left, right;
};

// Set the gains for this listener: place_voice() at once, move_voice() over `frames`.
void place_voice(Voice& io_voice, const Listener& listener);
void move_voice(Voice& io_voice, const Listener& listener, std::size_t frames);
void fade_in(Voice& io_voice);
// Starts the fade-out. A voice of which no frame was played ends at once; a second call does nothing.
void end_voice(Voice& io_voice);
// Adds the next samples to `io_ears` and advances the voice.
void mix_voice(Voice& io_voice, const EarBuffers& io_ears);

}  // namespace temblor::audio
