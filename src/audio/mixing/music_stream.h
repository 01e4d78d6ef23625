// Music for an audio callback: decoded ahead on a thread of its own, so that whoever reads never waits.
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

// Reads and opens a file of music; on whichever thread decodes it.
using OpenMusic = std::function<base::Result<MusicDecoder>()>;

class MusicStream {
 public:
  MusicStream();
  ~MusicStream();
  MusicStream(const MusicStream&) = delete;
  MusicStream& operator=(const MusicStream&) = delete;

  // From the thread that made it, which never waits for a file. What played before stops; null: silence.
  void play(OpenMusic open);
  // Why what was to be played is not, once.
  std::optional<base::Error> take_failure();
  void set_paused(bool paused) { paused_ = paused; }
  // The file that is being played turned out to be damaged.
  bool has_failed() const { return has_failed_; }

  // From one other thread: the next frames, left and right in turn; silence where there are none yet. Neither
  // waits nor asks the heap for anything.
  void read(std::span<float> out_samples);

  // Frames that are ready to be read.
  std::size_t frames_ready() const;

 private:
  static constexpr std::size_t kRing_frames = std::size_t{1} << 15;  // 0.7 s

  void decode_ahead();
  void open_next(std::unique_lock<std::mutex>& io_lock);
  void fill();
  void take(std::span<float> out_samples, std::size_t from_frame);
  void bridge(std::span<float> io_samples);

  std::vector<float> ring_ = std::vector<float>(2 * kRing_frames);
  // Frames since the beginning. One thread writes each: the decoder's the first two, the reader's the last.
  std::atomic<std::size_t> written_{0}, dropped_{0}, read_{0};
  std::atomic<bool> paused_{false}, has_failed_{false};

  // The reader's: its last frame, and how far off it the next ones are made to begin.
  std::array<float, 2> last_{}, offset_{};
  bool was_playing_ = false;

  std::mutex mutex_;  // between play() and the decoder's thread
  std::condition_variable wake_;
  OpenMusic next_;
  std::optional<base::Error> failure_;
  bool has_next_ = false, quits_ = false;
  std::atomic<bool> is_called_{false};  // one of both, for who does not hold the mutex

  std::optional<MusicDecoder> decoder_;  // the decoder's thread's
  std::thread thread_;                   // last: it uses all of the above
};

}  // namespace temblor::audio
