// Events that nobody has taken up yet, made one: a sound device may hang for minutes.
#pragma once

#include <cstddef>

#include "audio/scene.h"

namespace temblor::audio {

// What of a kind a folded one holds at most; the last ones count, but of static sounds the first.
constexpr std::size_t kMaxFolded = 1024;

// Adds what happened after `io_events`. For the mixer it is as if both happened one after the other without
// any time between: what is replaced or stopped at once is left out. (One that was to be stopped on
// kFreeChannel goes on if its entity starts another there.)
void fold(const SoundEvents& next, SoundEvents& io_events);

}  // namespace temblor::audio
