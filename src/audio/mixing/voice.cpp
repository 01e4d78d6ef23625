#include "audio/mixing/voice.h"

#include <limits>

#include "audio/mixing/mix_kernels.h"

namespace temblor::audio {
namespace {

constexpr std::size_t kFadeIn_frames = 96, kFadeOut_frames = 240;  // 2 and 5 ms
// While a fade and a movement overlap, their product is treated as linear over this many frames.
constexpr std::size_t kStraight_frames = 16;

// A player's own sounds are equally loud in both ears at any distance, as in stock Quake.
EarGains compute_gains(const Voice& voice, const Listener& listener) {
  if (voice.kind == VoiceKind::kStarted && voice.entity == listener.entity)
    return {voice.volume, voice.volume};
  return compute_ear_gains(listener, voice.origin_world, voice.volume, voice.attenuation);
}

std::size_t find_end(const Sound& sound) {
  return sound.loop ? sound.loop->end : sound.samples.size();
}

// The length of the next stretch over which all gains change linearly.
std::size_t stretch_frames(const Voice& voice, std::size_t wanted) {
  std::size_t frames = std::min(wanted, find_end(*voice.sound) - voice.position);
  for (const Glide* glide : {&voice.left, &voice.right})
    if (glide->frames_left() > 0) frames = std::min(frames, glide->frames_left());
  if (voice.fade.frames_left() > 0) frames = std::min({frames, voice.fade.frames_left(), kStraight_frames});
  return frames;
}

// Adds a stretch in which the gains change linearly: the product of two linear gains is close to linear over
// kStraight_frames. The kernel takes a start and a step for each ear.
void add_stretch(const Voice& voice, std::size_t frames, float* left, float* right) {
  if (voice.is_silent()) return;
  const auto count = static_cast<float>(frames);
  const auto at = [&](const Glide& glide, float place) { return glide.value() + glide.step() * place; };
  const float fade_end = at(voice.fade, count);
  const float left_gain = voice.left.value() * voice.fade.value();
  const float right_gain = voice.right.value() * voice.fade.value();
  mix_simd({voice.sound->samples.data() + voice.position, frames, left, right, left_gain,
            (at(voice.left, count) * fade_end - left_gain) / count, right_gain,
            (at(voice.right, count) * fade_end - right_gain) / count});
}

// Advances the voice by `frames`, which must not go past the end of its sound or of a glide.
void pass(Voice& io_voice, std::size_t frames) {
  io_voice.left.pass(frames);
  io_voice.right.pass(frames);
  const bool was_fading = io_voice.fade.frames_left() > 0;
  io_voice.fade.pass(frames);
  if (io_voice.is_ending && was_fading && io_voice.fade.frames_left() == 0) io_voice.has_ended = true;
  io_voice.position += frames;
  const Sound& sound = *io_voice.sound;
  if (io_voice.position < find_end(sound)) return;
  if (sound.loop)
    io_voice.position = sound.loop->start;
  else
    io_voice.has_ended = true;
}

}  // namespace

// With 0 frames the value jumps. A glide that is under way turns to the new target from where it is.
void Glide::go_to(float target, std::size_t frames) {
  target_ = target;
  frames_left_ = target == value_ ? 0 : frames;
  if (frames == 0) value_ = target;
  step_ = frames_left_ > 0 ? (target - value_) / static_cast<float>(frames) : 0;
}

void Glide::pass(std::size_t frames) {
  if (frames_left_ == 0) return;
  frames_left_ -= frames;
  // At the end it has exactly the target's value, without rounding errors.
  value_ = frames_left_ == 0 ? target_ : value_ + step_ * static_cast<float>(frames);
  if (frames_left_ == 0) step_ = 0;
}

std::size_t Voice::frames_left() const {
  return sound->loop ? std::numeric_limits<std::size_t>::max() : sound->samples.size() - position;
}

void place_voice(Voice& io_voice, const Listener& listener) {
  const EarGains gains = compute_gains(io_voice, listener);
  io_voice.left = Glide(gains.left);
  io_voice.right = Glide(gains.right);
}

void move_voice(Voice& io_voice, const Listener& listener, std::size_t frames) {
  const EarGains gains = compute_gains(io_voice, listener);
  io_voice.left.go_to(gains.left, frames);
  io_voice.right.go_to(gains.right, frames);
}

void fade_in(Voice& io_voice) {
  io_voice.fade = Glide(0);
  io_voice.fade.go_to(1, kFadeIn_frames);
}

void end_voice(Voice& io_voice) {
  if (io_voice.is_ending) return;
  io_voice.is_ending = true;
  // A voice that was never heard need not fade out.
  if (io_voice.is_new) io_voice.has_ended = true;
  io_voice.fade.go_to(0, kFadeOut_frames);
}

// Splits the block at the ends of glides, of the loop, and of the sound, so that the kernel needs no
// branches.
void mix_voice(Voice& io_voice, const EarBuffers& io_ears) {
  std::size_t done = 0;
  while (done < io_ears.left.size() && !io_voice.has_ended) {
    const std::size_t frames = stretch_frames(io_voice, io_ears.left.size() - done);
    add_stretch(io_voice, frames, io_ears.left.data() + done, io_ears.right.data() + done);
    pass(io_voice, frames);
    done += frames;
    io_voice.is_new = false;
  }
}

}  // namespace temblor::audio
