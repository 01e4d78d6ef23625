// One sound being played: where it is, how loud in each ear, and how it begins and ends without a click.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "audio/mixing/spatial.h"
#include "audio/scene.h"

namespace temblor::audio {

// Goes to its target along a straight line.
class Glide {
 public:
  Glide() = default;
  explicit Glide(float value) : value_(value), target_(value) {}

  float value() const { return value_; }
  float target() const { return target_; }
  float step() const { return step_; }  // of each frame
  std::size_t frames_left() const { return frames_left_; }
  bool is_silent() const { return value_ == 0 && target_ == 0; }

  void go_to(float target, std::size_t frames);
  void pass(std::size_t frames);  // at most frames_left(), where that is not 0

 private:
  float value_ = 0, target_ = 0, step_ = 0;
  std::size_t frames_left_ = 0;
};

enum class VoiceKind : std::uint8_t { kStarted, kStatic };

struct Voice {
  SoundPtr sound;
  std::size_t position = 0;  // of the next sample
  VoiceKind kind = VoiceKind::kStarted;
  std::int32_t entity = kNoEntity;
  int channel = kFreeChannel;
  math::Vec3 origin_world{0.0f};
  float volume = 1, attenuation = 1;
  Glide left{}, right{};  // where it is heard
  Glide fade{1};          // how it begins and ends
  std::uint64_t number = 0;
  bool is_new = true;      // no frame of it was played yet
  bool is_ending = false;  // fades, and is gone then
  bool has_ended = false;

  bool is_silent() const { return (left.is_silent() && right.is_silent()) || fade.is_silent(); }
  // Frames until it ends; as many as there are numbers for one that loops.
  std::size_t frames_left() const;
};

// Both ears of a stretch of sound; equally long.
struct EarBuffers {
  std::span<float> left, right;
};

// As loud as the listener has it, at once or over that many frames.
void place_voice(Voice& io_voice, const Listener& listener);
void move_voice(Voice& io_voice, const Listener& listener, std::size_t frames);
void fade_in(Voice& io_voice);
void end_voice(Voice& io_voice);
// Adds what comes next of it, and moves on.
void mix_voice(Voice& io_voice, const EarBuffers& io_ears);

}  // namespace temblor::audio
