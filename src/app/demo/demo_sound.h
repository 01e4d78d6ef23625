// Mixes the sound of a demo with the game's mixer, faster than real time, and writes it to a WAV file.
#pragma once

#include <string>

#include "app/demo/demo_loading.h"
#include "base/result.h"
#include "client/view/presentation.h"

namespace temblor::app {

// A part of a demo, on its own clock.
struct SoundSpan {
  // client::DemoLength::first_time_s
  double demo_start_s = 0;
  double first_s = 0, end_s = 0;
};

// Notes to print: only those about sounds, or also those about models and other files. A film draws the same
// demo and prints the others.
enum class NoteKinds { kSound, kAll };

// Writes the span as a WAV file. On damage in the demo, it keeps the sound before it and returns the error.
base::Status write_demo_sound(const LoadedDemo& demo, const client::PresentationSettings& presentation,
                              const SoundSpan& span, const std::string& path, NoteKinds notes);

}  // namespace temblor::app
