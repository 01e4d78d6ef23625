// Merges events that wait for the device thread: a sound device may hang for minutes.
#pragma once

#include <cstddef>

#include "audio/scene.h"

namespace temblor::audio {

// The most entries of each list after folding. The last ones stay; of static sounds, the first.
constexpr std::size_t kMaxFolded = 1024;

// Appends `next` to `io_events`. The mixer behaves as if both had arrived one right after the other: a sound
// that is replaced or stopped at once is left out. (One exception: a sound stopped on kFreeChannel keeps
// playing if its entity starts another sound on that channel.)
void fold(const SoundEvents& next, SoundEvents& io_events);

}  // namespace temblor::audio
