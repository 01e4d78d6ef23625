#include "app/demo/render_demo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/bench/frame_report.h"
#include "app/demo/demo_loading.h"
#include "app/demo/demo_run.h"
#include "app/demo/demo_sound.h"
#include "app/demo/film.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "app/files/sound_file.h"

namespace temblor::app {
namespace {

// At that rate.
std::size_t count_frames(const client::DemoLength& length, int frames_per_second) {
  const double seconds = std::max(0.0, length.last_time_s - length.first_time_s);
  return static_cast<std::size_t>(std::floor(seconds * frames_per_second)) + 1;
}

void print_notes(DemoRun& io_run) {
  for (const std::string& note : io_run.take_notes()) print_note(note);
}

// Plays and draws frames first to last; those before are played only, so that smoke and fire are as they
// would be. An error of the recording ends it there.
base::Status film_frames(DemoRun& io_run, const RenderOptions& options, double start_s, FrameRange frames,
                         Film& io_film) {
  Progress progress("frames");
  for (std::size_t number = 0; number < frames.end; ++number) {
    const double time_s = start_s + static_cast<double>(number) / options.frames_per_second;
    TRY(const bool goes_on, io_run.advance_to(time_s));
    print_notes(io_run);
    if (number >= frames.first) {
      const render::FrameStats stats = io_run.draw();
      TRY_STATUS(io_film.add(io_run.frame()));
      if (options.stats)
        fmt::print("frame {}\n{}", number, describe_frame(stats, io_run.frame().pixel_count()));
    }
    progress.update(number + 1, frames.end);
    if (!goes_on) break;
  }
  return base::Ok{};
}

SoundSpan sound_of(const client::DemoLength& length, FrameRange frames, int frames_per_second) {
  const auto time_s = [&](std::size_t frame) {
    return length.first_time_s + static_cast<double>(frame) / frames_per_second;
  };
  return {length.first_time_s, time_s(frames.first), time_s(frames.end)};
}

// Plays and draws into `options.out`; a film that can hold it gets the sound too, mixed before.
base::Status make_film(const LoadedDemo& demo, const RenderOptions& options, const SoundSpan& span,
                       FrameRange frames, const client::PresentationSettings& presentation,
                       const render::Settings& settings) {
  TRY(const OutputKind kind, output_kind(options.out));
  TRY(DemoRun run, DemoRun::start(demo, options.frame, presentation, settings));
  std::optional<TemporaryFile> sound;
  FilmOptions film_options{options.frame.size, options.frames_per_second, frames.first};
  if (kind == OutputKind::kMp4 && !options.no_sound) {
    TRY(sound, TemporaryFile::make(".wav"));
    film_options.sound_path = sound->path();
    const base::Status mixed = write_demo_sound(demo, presentation, span, sound->path(), NoteKinds::kOfSound);
    // A fault of the recording ends the pictures at the same place, and is told then.
    if (!mixed.ok() && mixed.error().file == sound->path()) return mixed;
  }
  TRY(Film film, Film::open(options.out, film_options, demo.look.palette));
  base::Status played = film_frames(run, options, span.recording_begins_s, frames, film);
  // What came before a fault is kept.
  TRY_STATUS(film.finish());
  return played;
}

}  // namespace

base::Status render_demo(const RenderOptions& options, const GameFolders& folders,
                         const client::PresentationSettings& presentation, const render::Settings& settings) {
  TRY(const LoadedDemo demo, load_demo(folders, options.demo));
  TRY(const client::DemoLength length, client::DemoPlayer::scan(demo.bytes, demo.name));
  const std::size_t frame_count = count_frames(length, options.frames_per_second);
  const FrameRange range = options.frame_range.value_or(FrameRange{0, kMaxFrames});
  const std::size_t first = range.first, end = std::min(frame_count, range.end);
  if (first >= end)
    return base::error(base::ErrorCode::kUsage, "--frames: {} has frames 0 to {} at {} a second", demo.name,
                       frame_count - 1, options.frames_per_second);
  TRY(const OutputKind kind, output_kind(options.out));
  const SoundSpan span = sound_of(length, {first, end}, options.frames_per_second);
  if (kind == OutputKind::kSound)
    TRY_STATUS(write_demo_sound(demo, presentation, span, options.out, NoteKinds::kAll));
  else
    TRY_STATUS(make_film(demo, options, span, {first, end}, presentation, settings));
  if (end < frame_count) return base::Ok{};
  if (length.cut_short)
    print_note(fmt::format("{}: the recording is cut off in its last message", demo.name));
  if (length.damage) return *length.damage;
  return base::Ok{};
}

}  // namespace temblor::app
