#include "audio/mixing/focus.h"

#include <algorithm>
#include <cmath>

namespace temblor::audio {
namespace {

// Seconds from full loudness to silence and back. A near voice must be clear from its first syllable; the
// others return slowly, so that pauses between its shouts do not pump.
constexpr float kFall_s = 0.06f, kRise_s = 0.6f;

bool is_audible_threat(const Voice& voice) {
  const bool audible = voice.left.target() > 0 || voice.right.target() > 0;
  return voice.is_threat && audible && !voice.is_ending && !voice.has_ended;
}

float compute_focus(float closeness, float nearest) {
  const float share = closeness / nearest;
  return std::max(kMinFocus, share * share);
}

void move_focus(Voice& io_voice, float target) {
  Glide& focus = io_voice.focus;
  if (target == focus.target()) return;
  // The voice rises from silence, so its first frame may have any gain.
  if (io_voice.is_new) return focus.go_to(target, 0);
  const float seconds = std::abs(target - focus.value()) * (target < focus.value() ? kFall_s : kRise_s);
  focus.go_to(target, static_cast<std::size_t>(std::ceil(seconds * kFramesPerSecond)));
}

}  // namespace

void aim_focus(std::span<Voice> io_voices, bool enabled) {
  float nearest = 0;
  if (enabled)
    for (const Voice& voice : io_voices)
      if (is_audible_threat(voice)) nearest = std::max(nearest, voice.closeness);
  for (Voice& voice : io_voices) {
    if (!voice.is_threat || voice.is_ending) continue;
    move_focus(voice, nearest > 0 ? compute_focus(voice.closeness, nearest) : 1);
  }
}

}  // namespace temblor::audio
