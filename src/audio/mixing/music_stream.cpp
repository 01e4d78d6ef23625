#include "audio/mixing/music_stream.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "audio/sound.h"

namespace temblor::audio {
namespace {

constexpr std::size_t kPiece_frames = 2048;
// How long the decoder sleeps while the ring is full. The reader cannot wake it, because that could block.
constexpr auto kPollInterval = std::chrono::milliseconds(15);
// The share of a break's offset that remains after one frame: it fades within about 5 ms.
constexpr float kBridge = 0.98f;

}  // namespace

MusicStream::MusicStream() : thread_([this] { run_decoder(); }) {}

MusicStream::~MusicStream() {
  {
    const std::lock_guard lock(mutex_);
    is_quitting_ = true;
    is_interrupted_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void MusicStream::play(OpenMusic open, OpenMusic open_combat) {
  {
    const std::lock_guard lock(mutex_);
    std::swap(next_, open);
    std::swap(next_combat_, open_combat);
    has_next_ = true;
    is_interrupted_ = true;
    has_failed_ = false;  // the previous music may have failed
    failure_.reset();
    combat_failure_.reset();
  }
  wake_.notify_one();
}

std::optional<base::Error> MusicStream::take_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

std::optional<base::Error> MusicStream::take_combat_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(combat_failure_, std::nullopt);
}

// Marks the unread frames as dropped, since they belong to the previous music. Opens the file without the
// mutex, so play() never waits for a disk. A newer request hides a failure of this one.
void MusicStream::open_next(std::unique_lock<std::mutex>& io_lock) {
  const OpenMusic open = std::exchange(next_, nullptr);
  const OpenMusic open_combat = std::exchange(next_combat_, nullptr);
  has_next_ = is_interrupted_ = has_failed_ = false;
  decoder_.reset();
  combat_decoder_.reset();
  dropped_.store(written_, std::memory_order_release);
  if (open == nullptr) return;
  io_lock.unlock();
  base::Result<MusicDecoder> opened = open();
  std::optional<base::Result<MusicDecoder>> combat;
  if (opened.ok() && open_combat != nullptr) combat = open_combat();
  io_lock.lock();
  if (opened.ok())
    decoder_.emplace(std::move(opened).value());
  else if (!has_next_)
    failure_ = opened.error();
  if (combat && combat->ok())
    combat_decoder_.emplace(std::move(*combat).value());
  else if (combat && !has_next_)
    combat_failure_ = combat->error();
}

// The decoder thread. Without music it sleeps until play() or the destructor wakes it.
void MusicStream::run_decoder() {
  std::unique_lock lock(mutex_);
  while (!is_quitting_) {
    if (has_next_) open_next(lock);
    lock.unlock();
    fill();
    lock.lock();
    const auto is_woken = [&] { return is_quitting_ || has_next_; };
    if (decoder_)
      wake_.wait_for(lock, kPollInterval, is_woken);
    else
      wake_.wait(lock, is_woken);
  }
}

void MusicStream::fill() {
  if (!decoder_) return;
  std::size_t written = written_.load(std::memory_order_relaxed);
  while (!is_interrupted_ &&
         kRing_frames - (written - read_.load(std::memory_order_acquire)) >= kPiece_frames) {
    // Pieces divide the ring evenly, so none wraps around its end.
    const std::span<float> piece = std::span(ring_).subspan(2 * (written % kRing_frames), 2 * kPiece_frames);
    decoder_->read(piece);
    decode_combat(std::span(combat_ring_).subspan(2 * (written % kRing_frames), 2 * kPiece_frames));
    written += kPiece_frames;
    written_.store(written, std::memory_order_release);
  }
  if (!is_interrupted_) has_failed_ = decoder_->has_failed();
}

// Writes silence without a layer. A damaged layer is reported and dropped.
void MusicStream::decode_combat(std::span<float> out_samples) {
  if (!combat_decoder_) {
    std::fill(out_samples.begin(), out_samples.end(), 0.0f);
    return;
  }
  combat_decoder_->read(out_samples);
  if (!combat_decoder_->has_failed()) return;
  combat_decoder_.reset();
  const std::lock_guard lock(mutex_);
  if (!has_next_) combat_failure_ = base::malformed("the combat layer is damaged");
}

std::size_t MusicStream::frames_ready() const {
  const std::size_t from = std::max(read_.load(), dropped_.load());
  return written_.load() - from;
}

void MusicStream::copy_from_ring(std::span<float> out_samples, std::size_t from_frame) {
  const std::size_t at = 2 * (from_frame % kRing_frames);
  const std::size_t before_end = std::min(out_samples.size(), ring_.size() - at);
  std::copy_n(ring_.begin() + static_cast<std::ptrdiff_t>(at), before_end, out_samples.begin());
  std::copy_n(ring_.begin(), out_samples.size() - before_end,
              out_samples.begin() + static_cast<std::ptrdiff_t>(before_end));
}

// Adds the combat layer and moves its gain toward the target, by one step per frame.
void MusicStream::add_combat(std::span<float> io_samples, std::size_t from_frame) {
  constexpr auto kRise = static_cast<float>(1 / (kRise_s * kFramesPerSecond));
  constexpr auto kFall = static_cast<float>(1 / (kFall_s * kFramesPerSecond));
  const bool combat = combat_;
  if (!combat && combat_gain_ == 0) return;
  for (std::size_t i = 0; i < io_samples.size(); i += 2) {
    combat_gain_ = combat ? std::min(1.0f, combat_gain_ + kRise) : std::max(0.0f, combat_gain_ - kFall);
    const std::size_t at = 2 * ((from_frame + i / 2) % kRing_frames);
    io_samples[i] += combat_gain_ * combat_ring_[at];
    io_samples[i + 1] += combat_gain_ * combat_ring_[at + 1];
  }
}

// Adds the decaying offset: after a break, the signal slides from its last value instead of jumping. Offsets
// too small to hear become 0, because denormal numbers are slow.
void MusicStream::bridge(std::span<float> io_samples) {
  for (std::size_t i = 0; i < io_samples.size(); ++i) {
    float& offset = offset_[i % 2];
    io_samples[i] += offset;
    offset *= kBridge;
    if (offset < 1e-6f && offset > -1e-6f) offset = 0;
  }
}

void MusicStream::read(std::span<float> out_samples) {
  const std::size_t written = written_.load(std::memory_order_acquire);
  const std::size_t read = read_.load(std::memory_order_relaxed);
  const std::size_t from = std::max(read, dropped_.load(std::memory_order_acquire));
  // dropped_ may be newer than the value of written_ read above.
  const std::size_t ready = written > from && !paused_ ? written - from : 0;
  const std::size_t count = std::min(ready, out_samples.size() / 2);
  const std::span<float> music = out_samples.first(2 * count), silence = out_samples.subspan(2 * count);
  const auto start_bridge = [&](std::span<const float> next, const float* last) {
    offset_ = {last[0] - next[0], last[1] - next[1]};
  };
  if (count > 0) {
    copy_from_ring(music, from);
    add_combat(music, from);
    if (from != read || !was_playing_) start_bridge(music, last_.data());
    bridge(music);
    last_ = {music[music.size() - 2], music[music.size() - 1]};
  }
  if (!silence.empty()) {
    std::fill(silence.begin(), silence.end(), 0.0f);
    if (count > 0 || was_playing_) start_bridge(silence, last_.data());
    bridge(silence);
    last_ = {silence[silence.size() - 2], silence[silence.size() - 1]};
  }
  was_playing_ = silence.empty() && count > 0;
  read_.store(from + count, std::memory_order_release);
}

}  // namespace temblor::audio
