#include "audio/mixer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "audio/mixing/focus.h"
#include "audio/mixing/mix_kernels.h"
#include "base/check.h"
#include "base/hash.h"

namespace temblor::audio {
namespace {

constexpr std::size_t kMinGlide_frames = 240;  // 5 ms
// The original's rate: 100 of 255 levels per second.
constexpr float kAmbientFade_per_frame = 100.0f / kFramesPerSecond;
constexpr std::size_t kMaxSkipped_frames = kFramesPerSecond / 10;

bool is_playing(const Voice& voice) {
  return !voice.is_ending && !voice.has_ended;
}

// Missing sounds arrive as null: they replace other sounds but play nothing.
bool can_be_heard(const SoundPtr& sound) {
  return sound != nullptr && !sound->samples.empty();
}

}  // namespace

Mixer::Mixer(const MixerSettings& settings) : settings_(settings) {
  voices_.reserve(kMaxWithEnding);
  if (settings_.keep_finished_sounds) finished_.reserve(kMaxWithEnding);
}

void Mixer::set_scene(const Scene& scene, std::size_t frames) {
  const std::size_t glide = std::max(frames, kMinGlide_frames);
  scene_ = scene;
  for (Voice& voice : voices_) move_voice(voice, scene_.listener, glide);
  sound_volume_.go_to(scene_.volumes.sounds, has_scene_ ? glide : 0);
  music_volume_.go_to(scene_.volumes.music, has_scene_ ? glide : 0);
  muffle_.set_target(scene_.listener.underwater ? std::clamp(scene_.volumes.muffled_underwater, 0.0f, 1.0f)
                                                : 0.0f);
  for (std::size_t kind = 0; kind < kAmbients; ++kind) update_ambient_target(kind);
  has_scene_ = true;
}

void Mixer::handle_events(const SoundEvents& events) {
  if (events.stops_all)
    for (Voice& voice : voices_) end_voice(voice);
  if (events.new_ambients) replace_ambients(events.ambients);
  for (const StaticSound& sound : events.statics) start(sound);
  for (const StartedSound& sound : events.started) start(sound);
  for (const StoppedSound& sound : events.stopped) stop(sound);
}

// Fades at a constant rate, so that the duration depends on how far the level has to go.
void Mixer::update_ambient_target(std::size_t kind) {
  Glide& level = ambients_[kind].level;
  const float target =
      ambients_[kind].sound ? compute_ambient_level(scene_.ambient_levels[kind], scene_.volumes.ambient) : 0;
  if (target == level.target()) return;  // already fading there
  const float frames = std::abs(target - level.value()) / kAmbientFade_per_frame;
  level.go_to(target, static_cast<std::size_t>(std::ceil(frames)));
}

// A replaced sound fades out as a separate voice: it continues at the same sample with the same gain, so the
// change is seamless. The new sound rises from silence.
void Mixer::replace_ambients(const std::array<SoundPtr, kAmbients>& sounds) {
  for (std::size_t kind = 0; kind < kAmbients; ++kind) {
    Ambient& ambient = ambients_[kind];
    const SoundPtr sound = can_be_heard(sounds[kind]) ? sounds[kind] : nullptr;
    if (ambient.sound == sound) continue;
    if (ambient.sound && voices_.size() < kMaxWithEnding) {
      const float gain = ambient.level.value() / 255;
      Voice voice{.sound = ambient.sound,
                  .position = ambient.position,
                  .volume = 0,
                  .left = Glide(gain),
                  .right = Glide(gain),
                  .is_new = false};
      end_voice(voice);
      voices_.push_back(std::move(voice));
    }
    retire_sound(std::exchange(ambient.sound, sound));
    ambient.position = 0;
    ambient.level = Glide(0);
    update_ambient_target(kind);
  }
}

void Mixer::start(const StartedSound& started) {
  end_replaced_voice(started.entity, started.channel);
  if (!can_be_heard(started.sound)) return;
  add_voice({.sound = started.sound,
             .position = choose_duplicate_skip(started.sound),
             .entity = started.entity,
             .channel = started.channel,
             .origin_world = started.origin_world,
             .volume = started.volume,
             .attenuation = started.attenuation,
             .is_threat = is_threat(started)});
}

void Mixer::start(const StaticSound& started) {
  if (!can_be_heard(started.sound)) return;
  add_voice({.sound = started.sound,
             .kind = VoiceKind::kStatic,
             .origin_world = started.origin_world,
             .volume = started.volume,
             .attenuation = started.attenuation});
}

void Mixer::stop(const StoppedSound& stopped) {
  for (Voice& voice : voices_)
    if (voice.kind == VoiceKind::kStarted && voice.entity == stopped.entity &&
        voice.channel == stopped.channel)
      end_voice(voice);
}

// Ends the oldest sound of the entity that the channel may replace (the original's rule).
void Mixer::end_replaced_voice(std::int32_t entity, int channel) {
  if (channel == kFreeChannel) return;
  Voice* oldest = nullptr;
  for (Voice& voice : voices_) {
    if (voice.kind != VoiceKind::kStarted || voice.entity != entity || !is_playing(voice)) continue;
    if (channel != kAnyChannel && voice.channel != channel) continue;
    if (oldest == nullptr || voice.number < oldest->number) oldest = &voice;
  }
  if (oldest != nullptr) end_voice(*oldest);
}

// The listener's own sounds, loops, and sounds that are equally loud everywhere threaten nobody from a place.
bool Mixer::is_threat(const StartedSound& started) const {
  return started.is_threat && started.entity != scene_.listener.entity && !started.sound->loop &&
         started.attenuation > 0;
}

// Returns the sample at which the sound should start. Two copies of a sound that start in the same frame
// would add up to one louder sound, and copies a few samples apart would sound hollow. The second copy
// therefore starts up to kMaxSkipped_frames into the sound; the offset is pseudorandom but deterministic.
std::size_t Mixer::choose_duplicate_skip(const SoundPtr& sound) {
  const auto same = [&](const Voice& voice) { return voice.is_new && voice.sound == sound; };
  if (std::none_of(voices_.begin(), voices_.end(), same)) return 0;
  const std::size_t max_skip = std::min(kMaxSkipped_frames, sound->samples.size());
  return static_cast<std::size_t>(base::mix_bits(started_count_) % max_skip);
}

// Ends a voice by the rule of kMaxVoices if all are in use. Returns false if every playing voice must stay.
bool Mixer::make_room() {
  if (voices_.size() >= kMaxWithEnding) return false;
  const auto playing = std::count_if(voices_.begin(), voices_.end(), is_playing);
  if (static_cast<std::size_t>(playing) < kMaxVoices) return true;
  Voice* shortest = nullptr;
  for (Voice& voice : voices_) {
    if (!is_playing(voice) || voice.sound->loop || voice.entity == scene_.listener.entity) continue;
    if (shortest == nullptr || voice.frames_left() < shortest->frames_left()) shortest = &voice;
  }
  if (shortest != nullptr) end_voice(*shortest);
  return shortest != nullptr;
}

void Mixer::add_voice(Voice voice) {
  ++started_count_;
  if (!make_room()) {
    ++left_out_;
    return;
  }
  voice.number = started_count_;
  place_voice(voice, scene_.listener);
  fade_in(voice);
  voices_.push_back(std::move(voice));
}

// Mixes one stretch at a time: up to the end of the block, of the loop, or of the level's fade, because the
// gain must be linear within a stretch.
void Mixer::mix_ambient(Ambient& io_ambient, const EarBuffers& io_ears) {
  constexpr float kFull = 1.0f / 255;
  std::size_t done = 0;
  while (done < io_ears.left.size()) {
    Glide& level = io_ambient.level;
    const SoundLoop loop = io_ambient.sound->loop.value_or(SoundLoop{0, io_ambient.sound->samples.size()});
    std::size_t frames = std::min(io_ears.left.size() - done, loop.end - io_ambient.position);
    if (level.frames_left() > 0) frames = std::min(frames, level.frames_left());
    if (!level.is_silent())
      mix_simd({io_ambient.sound->samples.data() + io_ambient.position, frames, io_ears.left.data() + done,
                io_ears.right.data() + done, level.value() * kFull, level.step() * kFull,
                level.value() * kFull, level.step() * kFull});
    level.advance(frames);
    io_ambient.position += frames;
    if (io_ambient.position == loop.end) io_ambient.position = loop.start;
    done += frames;
  }
}

// Keeps the sound alive for the thread that may free memory: this could be its last reference.
void Mixer::retire_sound(SoundPtr sound) {
  if (settings_.keep_finished_sounds && sound && finished_.size() < finished_.capacity())
    finished_.push_back(std::move(sound));
}

// The last voice fills each gap, so voices_ is unordered.
void Mixer::remove_ended() {
  for (std::size_t i = 0; i < voices_.size();) {
    // When the list is full, ended voices keep their places until the list is emptied.
    const bool has_room = !settings_.keep_finished_sounds || finished_.size() < finished_.capacity();
    if (!voices_[i].has_ended || !has_room) {
      ++i;
      continue;
    }
    retire_sound(std::move(voices_[i].sound));
    if (i + 1 < voices_.size()) voices_[i] = std::move(voices_.back());
    voices_.pop_back();
  }
}

// Renders at most kBlock_frames through the chain drawn in the header. Music is neither muffled nor affected
// by the sound volume.
void Mixer::render_block(std::span<float> out_samples, std::span<const float> music) {
  const std::size_t count = out_samples.size() / 2;
  const EarBuffers ears{std::span(left_).first(count), std::span(right_).first(count)};
  std::fill(ears.left.begin(), ears.left.end(), 0.0f);
  std::fill(ears.right.begin(), ears.right.end(), 0.0f);
  aim_focus(voices_, scene_.volumes.focus);
  for (Voice& voice : voices_) mix_voice(voice, ears);
  for (Ambient& ambient : ambients_)
    if (ambient.sound) mix_ambient(ambient, ears);
  muffle_.process(ears.left, ears.right);
  for (std::size_t i = 0; i < count; ++i) {
    ears.left[i] *= sound_volume_.value();
    ears.right[i] *= sound_volume_.value();
    if (!music.empty()) {
      ears.left[i] += music[2 * i] * music_volume_.value();
      ears.right[i] += music[2 * i + 1] * music_volume_.value();
    }
    sound_volume_.advance(1);
    music_volume_.advance(1);
  }
  limiter_.process(ears.left, ears.right);
  for (std::size_t i = 0; i < count; ++i) {
    out_samples[2 * i] = ears.left[i];
    out_samples[2 * i + 1] = ears.right[i];
  }
  remove_ended();
}

void Mixer::render(std::span<float> out_samples, std::span<const float> music) {
  CHECK(out_samples.size() % 2 == 0 && (music.empty() || music.size() == out_samples.size()));
  while (!out_samples.empty()) {
    const std::size_t size = std::min(out_samples.size(), 2 * kBlock_frames);
    render_block(out_samples.first(size), music.empty() ? music : music.first(size));
    out_samples = out_samples.subspan(size);
    if (!music.empty()) music = music.subspan(size);
  }
}

void Mixer::move_finished_to(std::vector<SoundPtr>& io_list) {
  while (!finished_.empty() && io_list.size() < io_list.capacity()) {
    io_list.push_back(std::move(finished_.back()));
    finished_.pop_back();
  }
}

}  // namespace temblor::audio
