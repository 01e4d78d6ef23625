#include "audio/mixing/voice.h"

#include <limits>

#include "audio/mixing/mix_kernels.h"

namespace temblor::audio {
namespace {

constexpr std::size_t kFadeIn_frames = 96, kFadeOut_frames = 240;  // 2 and 5 ms
// While a fade and a movement overlap, their product is treated as linear over this many frames.
constexpr std::size_t kStraight_frames = 16;

// The listener's own sounds, such as its weapon, come from inside its head: neither distance nor side counts.
EarGains compute_gains(const Voice& voice, const Listener& listener) {
  if (voice.kind == VoiceKind::kStarted && voice.entity == listener.entity)
    return {voice.volume, voice.volume};
  return compute_ear_gains(listener, voice.origin_world, voice.volume, voice.attenuation);
}

std::size_t find_end(const Sound& sound) {
  return sound.loop ? sound.loop->end : sound.samples.size();
}

// The length of the next stretch, which ends where a ramp, the loop or the samples end, so that all gains
// change linearly within it.
std::size_t compute_stretch_frames(const Voice& voice, std::size_t wanted) {
  std::size_t frames = std::min(wanted, find_end(*voice.sound) - voice.position);
  for (const Glide* glide : {&voice.left, &voice.right, &voice.focus})
    if (glide->frames_left() > 0) frames = std::min(frames, glide->frames_left());
  if (voice.fade.frames_left() > 0) frames = std::min({frames, voice.fade.frames_left(), kStraight_frames});
  return frames;
}

// Computes the exact gains at both ends of the stretch; the kernel interpolates between them.
void mix_stretch(const Voice& voice, std::size_t frames, float* left, float* right) {
  if (voice.is_silent()) return;
  const auto count = static_cast<float>(frames);
  const auto at = [&](const Glide& glide, float place) { return glide.value() + glide.step() * place; };
  const float share = voice.fade.value() * voice.focus.value();
  const float share_end = at(voice.fade, count) * at(voice.focus, count);
  const float left_gain = voice.left.value() * share;
  const float right_gain = voice.right.value() * share;
  mix_simd({voice.sound->samples.data() + voice.position, frames, left, right, left_gain,
            (at(voice.left, count) * share_end - left_gain) / count, right_gain,
            (at(voice.right, count) * share_end - right_gain) / count});
}

// Moves past a stretch: advances the ramps, wraps around the loop, and detects the end.
void advance(Voice& io_voice, std::size_t frames) {
  io_voice.left.advance(frames);
  io_voice.right.advance(frames);
  io_voice.focus.advance(frames);
  const bool was_fading = io_voice.fade.frames_left() > 0;
  io_voice.fade.advance(frames);
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

void Glide::go_to(float target, std::size_t frames) {
  target_ = target;
  frames_left_ = target == value_ ? 0 : frames;
  if (frames == 0) value_ = target;
  step_ = frames_left_ > 0 ? (target - value_) / static_cast<float>(frames) : 0;
}

void Glide::advance(std::size_t frames) {
  if (frames_left_ == 0) return;
  frames_left_ -= frames;
  // The last step sets exactly the target, without rounding errors.
  value_ = frames_left_ == 0 ? target_ : value_ + step_ * static_cast<float>(frames);
  if (frames_left_ == 0) step_ = 0;
}

std::size_t Voice::frames_left() const {
  return sound->loop ? std::numeric_limits<std::size_t>::max() : sound->samples.size() - position;
}

void place_voice(Voice& io_voice, const Listener& listener) {
  const EarGains gains = compute_gains(io_voice, listener);
  io_voice.closeness = compute_closeness(listener, io_voice.origin_world);
  io_voice.left = Glide(gains.left);
  io_voice.right = Glide(gains.right);
}

void move_voice(Voice& io_voice, const Listener& listener, std::size_t frames) {
  const EarGains gains = compute_gains(io_voice, listener);
  io_voice.closeness = compute_closeness(listener, io_voice.origin_world);
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

void mix_voice(Voice& io_voice, const EarBuffers& io_ears) {
  std::size_t done = 0;
  while (done < io_ears.left.size() && !io_voice.has_ended) {
    const std::size_t frames = compute_stretch_frames(io_voice, io_ears.left.size() - done);
    mix_stretch(io_voice, frames, io_ears.left.data() + done, io_ears.right.data() + done);
    advance(io_voice, frames);
    done += frames;
    io_voice.is_new = false;
  }
}

}  // namespace temblor::audio
