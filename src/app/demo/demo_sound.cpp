#include "app/demo/demo_sound.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/demo/demo_playback.h"
#include "app/demo/sound_file.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "audio/mixer.h"
#include "audio/music_decoder.h"

namespace temblor::app {
namespace {

// The listener's position is sampled at every event and at least this often.
constexpr double kStep_s = 1.0 / 60;

// Runs the mixer along a demo. Between two moments, volumes and positions are interpolated by the mixer.
//
//   moment 1          moment 2        sound frames, 48000 per second
//      |------ mix ------|            mixed_frame_ is the end of this range
//   |<- kDelay_frames ->|             the mixer's output is late by this much
class SoundTrack {
 public:
  SoundTrack(const LoadedDemo& demo, const SoundSpan& span, SoundFile& out)
      : demo_(demo), start_frame_(frame_at(span.first_s)), end_frame_(frame_at(span.end_s)), out_(out) {}

  // Mixes up to the moment and gives the mixer the scene at that moment. Mixing begins at the first moment.
  void advance(double time_s, client::AudioScene& io_audio, std::uint8_t music_track) {
    const std::int64_t frame = frame_at(time_s);
    if (!begun_) mixed_frame_ = frame;
    begun_ = true;
    if (frame > mixed_frame_) {
      mixer_.set_scene(io_audio.scene(), static_cast<std::size_t>(frame - mixed_frame_));
      mix_until(frame);
    } else {
      mixer_.set_scene(io_audio.scene(), 0);
    }
    mixer_.handle_events(io_audio.events());
    io_audio.events().clear();
    play_music(music_track);
  }
  // Mixes to the end of the span, and further by the mixer's delay to get the last frames out of it.
  void finish() { mix_until(end_frame_ + static_cast<std::int64_t>(audio::Mixer::kDelay_frames)); }

  // The first error of the file.
  const base::Status& written() const { return written_; }

 private:
  static std::int64_t frame_at(double time_s) { return std::llround(time_s * audio::kFramesPerSecond); }

  void mix_until(std::int64_t frame) {
    constexpr std::int64_t kPiece_frames = 4096;
    while (mixed_frame_ < frame) {
      const auto count = static_cast<std::size_t>(std::min(frame - mixed_frame_, kPiece_frames));
      samples_.resize(2 * count);
      music_samples_.resize(music_ ? 2 * count : 0);
      if (music_) music_->read(music_samples_);
      mixer_.render(samples_, music_samples_);
      // The output belongs to earlier frames, by the mixer's delay.
      const std::int64_t first = mixed_frame_ - static_cast<std::int64_t>(audio::Mixer::kDelay_frames);
      write_part(first);
      mixed_frame_ += static_cast<std::int64_t>(count);
    }
  }

  // Writes the part of `samples_` that is inside the span. `first` is the frame of the first sample.
  void write_part(std::int64_t first) {
    const auto count = static_cast<std::int64_t>(samples_.size() / 2);
    const std::int64_t from = std::clamp(start_frame_ - first, std::int64_t{0}, count);
    const std::int64_t to = std::clamp(end_frame_ - first, from, count);
    if (!written_.ok() || from == to) return;
    written_ = out_.add(std::span(samples_).subspan(2 * static_cast<std::size_t>(from),
                                                    2 * static_cast<std::size_t>(to - from)));
  }

  // Starts a track from its beginning if it is not playing. Missing music is normal: stock Quake had it on
  // the CD.
  void play_music(std::uint8_t track) {
    if (track == track_) return;
    track_ = track;
    music_.reset();
    const base::Result<assets::MusicFile> file = demo_.library.music(track);
    if (!file.ok()) return;
    const base::Result<base::ByteVector> bytes = file->read();
    if (!bytes.ok()) return print_note(bytes.error().message() + "; no music");
    base::Result<audio::MusicDecoder> music = audio::MusicDecoder::open(*bytes).with_file(file->name);
    if (music.ok())
      music_.emplace(std::move(music).value());
    else
      print_note(music.error().message() + "; no music");
  }

  const LoadedDemo& demo_;
  std::int64_t start_frame_, end_frame_;
  SoundFile& out_;
  audio::Mixer mixer_;
  std::optional<audio::MusicDecoder> music_;
  std::uint8_t track_ = 0;
  bool begun_ = false;
  std::int64_t mixed_frame_ = 0;
  std::vector<float> samples_, music_samples_;
  base::Status written_ = base::Ok{};
};

// Prints what has gone wrong since the last call.
void print_notes(client::Presentation& io_presentation, NoteKinds notes) {
  for (const std::string& note :
       notes == NoteKinds::kAll ? io_presentation.take_notes() : io_presentation.audio_scene().take_notes())
    print_note(note);
}

// Plays the demo from its start to the end of the span. The start matters, because sounds may still be
// playing.
base::Status play(DemoPlayback& io_playback, const SoundTrack& track, const SoundSpan& span,
                  NoteKinds notes) {
  Progress progress("sound");
  TRY_STATUS(io_playback.advance_by_packet());
  const auto steps = static_cast<std::size_t>(std::ceil((span.end_s - span.demo_start_s) / kStep_s));
  for (std::size_t step = 1; step <= steps; ++step) {
    const double time_s = span.demo_start_s + static_cast<double>(step) * kStep_s;
    TRY(const bool has_more, io_playback.advance_to(std::min(span.end_s, time_s)));
    TRY_STATUS(track.written());
    print_notes(io_playback.presentation(), notes);
    progress.update(step, steps);
    if (!has_more) break;
  }
  return base::Ok{};
}

}  // namespace

base::Status write_demo_sound(const LoadedDemo& demo, const client::PresentationSettings& presentation,
                              const SoundSpan& span, const std::string& path, NoteKinds notes) {
  client::PresentationSettings settings = presentation;
  settings.sound = true;
  TRY(SoundFile file, SoundFile::open(path, audio::kFramesPerSecond));
  TRY(DemoPlayback playback, DemoPlayback::open(demo, settings));
  SoundTrack track(demo, span, file);
  playback.set_moment_handler([&](double time_s) {
    track.advance(time_s, playback.presentation().audio_scene(), playback.state().game().music_track);
  });
  const base::Status played = play(playback, track, span, notes);
  if (played.ok()) track.finish();
  TRY_STATUS(track.written());
  TRY_STATUS(file.finish());
  return played;
}

}  // namespace temblor::app
