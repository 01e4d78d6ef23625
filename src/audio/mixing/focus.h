// Keeps the nearest threat the clearest: while voices of several creatures sound, those of the farther ones
// are softer than their distance alone makes them.
//
//   closeness = 1 - distance / 1000
//   focus     = (closeness / closeness of the nearest threat)^2, at least kMinFocus
//
// One voice alone, and voices from the same distance, are as loud as in the original, so only the balance of
// simultaneous voices changes. Four voices at 600 units add up to the loudness of one at 150 units; the focus
// lowers them by 9 dB. A change takes a few hundredths of a second, as one of the listener's attention does.
#pragma once

#include <span>

#include "audio/mixing/voice.h"

namespace temblor::audio {

constexpr float kMinFocus = 0.35f;  // -9 dB

// Sets where the focus of each voice moves to. `enabled` false: every voice returns to full loudness. Voices
// that fade out neither count nor change.
void aim_focus(std::span<Voice> io_voices, bool enabled);

}  // namespace temblor::audio
