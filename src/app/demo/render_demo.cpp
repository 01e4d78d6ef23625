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
#include "app/demo/sound_file.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"

namespace temblor::app {
namespace {

// Returns how many frames the whole demo has at that rate. The first one is at first_time_s, the last not
// after last_time_s.
std::size_t count_frames(const client::DemoLength& length, int frames_per_second) {
  const double seconds = std::max(0.0, length.last_time_s - length.first_time_s);
  return static_cast<std::size_t>(std::floor(seconds * frames_per_second)) + 1;
}

void print_notes(DemoRun& io_run) {
  for (const std::string& note : io_run.take_notes()) print_note(note);
}

// Draws the frames of the range. Frames before it are played without being drawn, so that particles and
// lights are in the state that they would have. An error in the demo ends the film there.
base::Status film_frames(DemoRun& io_run, const RenderOptions& options, double start_s, FrameRange frames,
                         Film& io_film) {
  Progress progress("frames");
  for (std::size_t number = 0; number < frames.end; ++number) {
    const double time_s = start_s + static_cast<double>(number) / options.frames_per_second;
    TRY(const bool has_more, io_run.advance_to(time_s));
    print_notes(io_run);
    if (number >= frames.first) {
      TRY(const render::FrameStats stats, io_run.draw());
      TRY_STATUS(io_film.add(io_run.frame()));
      if (options.stats)
        fmt::print("frame {}\n{}", number, describe_frame(stats, io_run.frame().pixel_count()));
    }
    progress.update(number + 1, frames.end);
    if (!has_more) break;
  }
  return base::Ok{};
}

// Returns the time from the first frame to the end of the last one.
SoundSpan compute_sound_span(const client::DemoLength& length, FrameRange frames, int frames_per_second) {
  const auto time_s = [&](std::size_t frame) {
    return length.first_time_s + static_cast<double>(frame) / frames_per_second;
  };
  return {length.first_time_s, time_s(frames.first), time_s(frames.end)};
}

// Draws the frames to `options.out`. An .mp4 film also gets the sound, which is mixed to a temporary file
// first.
base::Status make_film(const LoadedDemo& demo, const RenderOptions& options, const SoundSpan& span,
                       FrameRange frames, const client::PresentationSettings& presentation,
                       const render::Settings& settings) {
  TRY(const OutputKind kind, find_output_kind(options.out));
  TRY(DemoRun run, DemoRun::start(demo, options.frame, presentation, settings));
  std::optional<TemporaryFile> sound;
  FilmOptions film_options{options.frame.size, options.frames_per_second, frames.first};
  if (kind == OutputKind::kMp4 && !options.no_sound) {
    TRY(sound, TemporaryFile::make(".wav"));
    film_options.sound_path = sound->path();
    const base::Status mixed = write_demo_sound(demo, presentation, span, sound->path(), NoteKinds::kSound);
    // Damage in the demo ends the pictures at the same place and is reported there, so only file errors
    // matter here.
    if (!mixed.ok() && mixed.error().file == sound->path()) return mixed;
  }
  TRY(Film film, Film::open(options.out, film_options, demo.look.palette));
  base::Status played = film_frames(run, options, span.demo_start_s, frames, film);
  // Finish the film before returning an error, so that everything before the damage is kept.
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
    return base::error(base::ErrorCode::kUsage, "--frames: {} has frames 0 to {} at {} frames per second",
                       demo.name, frame_count - 1, options.frames_per_second);
  TRY(const OutputKind kind, find_output_kind(options.out));
  const SoundSpan span = compute_sound_span(length, {first, end}, options.frames_per_second);
  if (kind == OutputKind::kSound)
    TRY_STATUS(write_demo_sound(demo, presentation, span, options.out, NoteKinds::kAll));
  else
    TRY_STATUS(make_film(demo, options, span, {first, end}, presentation, settings));
  // The end of the demo matters only if it was rendered.
  if (end < frame_count) return base::Ok{};
  if (length.is_truncated)
    print_note(fmt::format("{}: the demo is truncated in its last message", demo.name));
  if (length.damage) return *length.damage;
  return base::Ok{};
}

}  // namespace temblor::app
