#include "audio/mixing/fold_events.h"

#include <algorithm>

namespace temblor::audio {
namespace {

// Appends an entry; drops the oldest one if the list is full.
template <typename T>
void add_bounded(const T& added, std::vector<T>& io_list) {
  if (io_list.size() >= kMaxFolded) io_list.erase(io_list.begin());
  io_list.push_back(added);
}

void start(const StartedSound& added, SoundEvents& io_events) {
  const auto has_same_channel = [&](const auto& other) {
    return other.entity == added.entity && other.channel == added.channel;
  };
  // The mixer applies starts before stops, so an earlier stop must not hit this later start.
  std::erase_if(io_events.stopped, has_same_channel);
  if (added.channel != kFreeChannel && added.channel != kAnyChannel)
    std::erase_if(io_events.started, has_same_channel);
  add_bounded(added, io_events.started);
}

void stop(const StoppedSound& added, SoundEvents& io_events) {
  const auto has_same_channel = [&](const auto& other) {
    return other.entity == added.entity && other.channel == added.channel;
  };
  std::erase_if(io_events.started, has_same_channel);
  // The stop also applies to a sound that already plays.
  std::erase_if(io_events.stopped, has_same_channel);
  add_bounded(added, io_events.stopped);
}

}  // namespace

// A full stop cancels all earlier starts and stops. Ambients are replaced as a whole, so the last set wins.
void fold(const SoundEvents& next, SoundEvents& io_events) {
  if (next.stops_all) {
    io_events.stops_all = true;
    io_events.statics.clear();
    io_events.started.clear();
    io_events.stopped.clear();
  }
  if (next.new_ambients) {
    io_events.new_ambients = true;
    io_events.ambients = next.ambients;
  }
  for (const StaticSound& added : next.statics)
    if (io_events.statics.size() < kMaxFolded) io_events.statics.push_back(added);
  for (const StartedSound& added : next.started) start(added, io_events);
  for (const StoppedSound& added : next.stopped) stop(added, io_events);
}

}  // namespace temblor::audio
