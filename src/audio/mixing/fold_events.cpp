#include "audio/mixing/fold_events.h"

#include <algorithm>

namespace temblor::audio {
namespace {

// Drops the oldest entries.
template <typename T>
void add_bounded(const T& what, std::vector<T>& io_list) {
  if (io_list.size() >= kMaxFolded) io_list.erase(io_list.begin());
  io_list.push_back(what);
}

void start(const StartedSound& what, SoundEvents& io_events) {
  const auto is_its_place = [&](const auto& other) {
    return other.entity == what.entity && other.channel == what.channel;
  };
  // The mixer applies starts before stops, so an earlier stop must not hit this later start.
  std::erase_if(io_events.stopped, is_its_place);
  if (what.channel != kFreeChannel && what.channel != kAnyChannel)
    std::erase_if(io_events.started, is_its_place);
  add_bounded(what, io_events.started);
}

void stop(const StoppedSound& what, SoundEvents& io_events) {
  const auto is_its_place = [&](const auto& other) {
    return other.entity == what.entity && other.channel == what.channel;
  };
  std::erase_if(io_events.started, is_its_place);
  // The stop also applies to a sound that already plays.
  std::erase_if(io_events.stopped, is_its_place);
  add_bounded(what, io_events.stopped);
}

}  // namespace

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
  for (const StaticSound& what : next.statics)
    if (io_events.statics.size() < kMaxFolded) io_events.statics.push_back(what);
  for (const StartedSound& what : next.started) start(what, io_events);
  for (const StoppedSound& what : next.stopped) stop(what, io_events);
}

}  // namespace temblor::audio
