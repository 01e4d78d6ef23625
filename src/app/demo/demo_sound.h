// A recording's sound: what the player heard, mixed as in the game.
#pragma once

#include <string>

#include "app/demo/demo_loading.h"
#include "base/result.h"
#include "client/view/presentation.h"

namespace temblor::app {

// Which part of the recording, on its own clock.
struct SoundSpan {
  double recording_begins_s = 0;  // client::DemoLength::first_time_s
  double first_s = 0, end_s = 0;
};

// Which notes are printed: those of sounds, or with them those of models and all else.
enum class NoteKinds { kOfSound, kAll };

// Writes it as a WAV file. What came before a fault of the recording is kept, and the fault returned.
base::Status write_demo_sound(const LoadedDemo& demo, const client::PresentationSettings& presentation,
                              const SoundSpan& span, const std::string& path, NoteKinds notes);

}  // namespace temblor::app
