// Merges events that wait for the device thread. A sound device may hang for minutes, and the backlog must
// not grow without bound.
#pragma once

#include <cstddef>

#include "audio/scene.h"

namespace temblor::audio {

// The maximum length of each list after folding. The newest entries stay, but of static sounds the oldest.
constexpr std::size_t kMaxFolded = 1024;

// Appends `next` to `io_events`. The mixer behaves as if both had arrived one right after the other: a sound
// that would be replaced or stopped at once is left out. (One exception: a sound stopped on kFreeChannel
// keeps playing if its entity starts another sound on that channel.)
void fold(const SoundEvents& next, SoundEvents& io_events);

}  // namespace temblor::audio
