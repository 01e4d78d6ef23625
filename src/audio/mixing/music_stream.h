// Music for an audio callback. A separate thread decodes ahead into a lock-free ring, so the reader never
// waits.
//
//   game thread: play() --mutex--> decoder thread: decode --rings--> device thread: read()
//                                  piece and combat layer            piece + gain * layer
//
// The ring has one writer and one reader. Positions are frame counts that only grow; the index is the count
// modulo kRing_frames, and written_ - read_ never exceeds kRing_frames:
//
//   read_ ... dropped_ ........ written_
//   |  old music  |  ready music  |  free
//
// When another track starts, the frames before dropped_ are skipped. Where the signal breaks (a new track, a
// pause, an empty ring), the reader bridges the step, so nothing clicks.
//
// A combat layer is a second file, a loop whose length divides the track's. Both are decoded in step, into
// two rings with the same positions, so they stay together to the sample. The reader fades the layer, so a
// fade starts at once.
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

// Reads and opens a music file. Called once, on the decoder thread, so it may wait for the disk.
using OpenMusic = std::function<base::Result<MusicDecoder>()>;

class MusicStream {
 public:
  MusicStream();
  ~MusicStream();
  MusicStream(const MusicStream&) = delete;
  MusicStream& operator=(const MusicStream&) = delete;

  // How long the combat layer takes to rise from silence, and to fade away.
  static constexpr double kRise_s = 1, kFall_s = 6;

  // Game thread. Stops the current music and starts this one; null: silence. Never waits for a file.
  // `open_combat`: its combat layer; null if it has none.
  void play(OpenMusic open, OpenMusic open_combat = nullptr);
  // Game thread. Returns the reason why the last music could not be opened, once; null if it could.
  std::optional<base::Error> take_failure();
  // Game thread. Returns the reason why the last music plays without its combat layer, once.
  std::optional<base::Error> take_combat_failure();
  // Any thread. Whether the combat layer is heard, from now on.
  void set_combat(bool combat) { combat_ = combat; }
  // Any thread. A paused stream returns silence and keeps its position.
  void set_paused(bool paused) { paused_ = paused; }
  // Any thread. Whether the current music file is damaged.
  bool has_failed() const { return has_failed_; }

  // Device thread. Returns the next frames, left and right interleaved, and silence if none are ready. Never
  // waits or allocates.
  void read(std::span<float> out_samples);

  // The number of frames that are ready to be read.
  std::size_t frames_ready() const;

 private:
  static constexpr std::size_t kRing_frames = std::size_t{1} << 15;  // 0.7 s

  void run_decoder();
  void open_next(std::unique_lock<std::mutex>& io_lock);
  void fill();
  void decode_combat(std::span<float> out_samples);
  void copy_from_ring(std::span<float> out_samples, std::size_t from_frame);
  void add_combat(std::span<float> io_samples, std::size_t from_frame);
  void bridge(std::span<float> io_samples);

  std::vector<float> ring_ = std::vector<float>(2 * kRing_frames);
  std::vector<float> combat_ring_ = std::vector<float>(2 * kRing_frames);
  // Frame counts since the stream was made. The decoder thread writes the first two, the device thread the
  // last. A release store publishes the samples that the counter covers.
  std::atomic<std::size_t> written_{0}, dropped_{0}, read_{0};
  std::atomic<bool> paused_{false}, has_failed_{false}, combat_{false};

  // Device thread: the last frame, and the offset that keeps the next frames continuous with it.
  std::array<float, 2> last_{}, offset_{};
  bool was_playing_ = false;
  float combat_gain_ = 0;

  std::mutex mutex_;  // guards the five members below
  std::condition_variable wake_;
  OpenMusic next_, next_combat_;
  std::optional<base::Error> failure_, combat_failure_;
  bool has_next_ = false, is_quitting_ = false;
  // has_next_ || is_quitting_, readable without the mutex. The decoder checks it between pieces.
  std::atomic<bool> is_interrupted_{false};

  std::optional<MusicDecoder> decoder_, combat_decoder_;  // decoder thread only
  std::thread thread_;                                    // declared last: it uses everything above
};

}  // namespace temblor::audio
