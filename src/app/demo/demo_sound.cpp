#include "app/demo/demo_sound.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/demo/demo_playback.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "app/files/sound_file.h"
#include "audio/mixer.h"
#include "audio/music_decoder.h"

namespace temblor::app {
namespace {

// How often the listener is asked for where he is, besides whenever something happens.
constexpr double kStep_s = 1.0 / 60;

// The mixer run along a recording: between two moments, things glide from how they were to how they are.
class SoundTrack {
 public:
  SoundTrack(const LoadedDemo& demo, const SoundSpan& span, SoundFile& out)
      : demo_(demo), start_frame_(frame_at(span.first_s)), end_frame_(frame_at(span.end_s)), out_(out) {}

  // The first moment is where mixing begins.
  void live_through(double time_s, client::AudioScene& io_audio, std::uint8_t music_track) {
    const std::int64_t frame = frame_at(time_s);
    if (!begun_) mixed_frame_ = frame;
    begun_ = true;
    if (frame > mixed_frame_) {
      mixer_.follow(io_audio.scene(), static_cast<std::size_t>(frame - mixed_frame_));
      mix_until(frame);
    } else {
      mixer_.follow(io_audio.scene(), 0);
    }
    mixer_.happen(io_audio.events());
    io_audio.events().clear();
    play_music(music_track);
  }
  // Until the span's end, and as long as the mixer holds back.
  void finish() { mix_until(end_frame_ + static_cast<std::int64_t>(audio::Mixer::kDelay_frames)); }

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
      // What comes out belongs to frames a little before.
      const std::int64_t first = mixed_frame_ - static_cast<std::int64_t>(audio::Mixer::kDelay_frames);
      keep(first);
      mixed_frame_ += static_cast<std::int64_t>(count);
    }
  }

  // What of `samples_`, which begin at that frame, lies in the span.
  void keep(std::int64_t first) {
    const auto count = static_cast<std::int64_t>(samples_.size() / 2);
    const std::int64_t from = std::clamp(start_frame_ - first, std::int64_t{0}, count);
    const std::int64_t to = std::clamp(end_frame_ - first, from, count);
    if (!written_.ok() || from == to) return;
    written_ = out_.add(std::span(samples_).subspan(2 * static_cast<std::size_t>(from),
                                                    2 * static_cast<std::size_t>(to - from)));
  }

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

void print_notes(client::Presentation& io_presentation, NoteKinds notes) {
  for (const std::string& note :
       notes == NoteKinds::kAll ? io_presentation.take_notes() : io_presentation.audio_scene().take_notes())
    print_note(note);
}

base::Status play(DemoPlayback& io_playback, const SoundTrack& track, const SoundSpan& span,
                  NoteKinds notes) {
  Progress progress("moments of sound");
  TRY_STATUS(io_playback.advance_by_packet());
  const auto steps = static_cast<std::size_t>(std::ceil((span.end_s - span.recording_begins_s) / kStep_s));
  for (std::size_t step = 1; step <= steps; ++step) {
    const double time_s = span.recording_begins_s + static_cast<double>(step) * kStep_s;
    TRY(const bool goes_on, io_playback.advance_to(std::min(span.end_s, time_s)));
    TRY_STATUS(track.written());
    print_notes(io_playback.presentation(), notes);
    progress.update(step, steps);
    if (!goes_on) break;
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
  playback.on_moment([&](double time_s) {
    track.live_through(time_s, playback.presentation().audio_scene(), playback.state().game().music_track);
  });
  const base::Status played = play(playback, track, span, notes);
  if (played.ok()) track.finish();
  TRY_STATUS(track.written());
  TRY_STATUS(file.finish());
  return played;
}

}  // namespace temblor::app
