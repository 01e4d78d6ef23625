// Music for an audio callback. A separate thread decodes ahead into a lock-free ring, so the reader never
// waits.
//
//   game thread: play() --mutex--> decoder thread: decode --ring--> device thread: read()
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "audio/music_decoder.h"

namespace temblor::audio {

// Reads and opens a music file. Called on the decoder thread.
using OpenMusic = std::function<base::Result<MusicDecoder>()>;

class MusicStream {
 public:
  MusicStream();
  ~MusicStream();
  MusicStream(const MusicStream&) = delete;
  MusicStream& operator=(const MusicStream&) = delete;

  // Game thread. Stops the current music and starts this one; null: silence. Never waits for a file.
  void play(OpenMusic open);
  // Returns once why the last music could not be opened.
  std::optional<base::Error> take_failure();
  void set_paused(bool paused) { paused_ = paused; }
  // Whether the file that plays is damaged.
  bool has_failed() const { return has_failed_; }

  // Device thread. Returns the next frames, left and right interleaved, and silence if none are ready. Never
  // waits or allocates.
  void read(std::span<float> out_samples);

  // The number of frames that are ready to be read.
  std::size_t frames_ready() const;

 private:
  static constexpr std::size_t kRing_frames = std::size_t{1} << 15;  // 0.7 s

  void decode_ahead();
  void open_next(std::unique_lock<std::mutex>& io_lock);
  void fill();
  void take(std::span<float> out_samples, std::size_t from_frame);
  void bridge(std::span<float> io_samples);

  std::vector<float> ring_ = std::vector<float>(2 * kRing_frames);
  // Frame counts since the stream was made. The decoder thread writes the first two, the device thread the
  // last.
  std::atomic<std::size_t> written_{0}, dropped_{0}, read_{0};
  std::atomic<bool> paused_{false}, has_failed_{false};

  // Device thread: the last frame, and the offset that keeps the next frames continuous with it.
  std::array<float, 2> last_{}, offset_{};
  bool was_playing_ = false;

  std::mutex mutex_;  // guards the four members below
  std::condition_variable wake_;
  OpenMusic next_;
  std::optional<base::Error> failure_;
  bool has_next_ = false, quits_ = false;
  std::atomic<bool> is_called_{false};  // has_next_ || quits_, readable without the mutex

  std::optional<MusicDecoder> decoder_;  // decoder thread only
  std::thread thread_;                   // declared last: it uses everything above
};

}  // namespace temblor::audio
