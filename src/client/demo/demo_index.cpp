#include "client/demo/demo_index.h"

#include <algorithm>

namespace temblor::client {

void append_static_sounds(const Events& events, std::vector<net::SpawnStaticSound>& io_sounds) {
  if (events.new_level) io_sounds.clear();
  io_sounds.insert(io_sounds.end(), events.static_sounds.begin(), events.static_sounds.end());
}

// The callback runs before the packet's events are counted, so an entry's counters cover the packets before
// it, and restoring the entry replays its own packet.
base::Result<DemoIndex> DemoIndex::make(DemoPlayer& io_player) {
  DemoIndex index;
  EffectCounts effects;
  std::vector<net::SpawnStaticSound> static_sounds;
  TRY(index.length_, io_player.play_to_end([&] {
    const Events& events = io_player.state().events();
    index.add(io_player, effects, static_sounds);
    if (!events.marks.empty()) index.mark_times_s_.push_back(io_player.packet_time_s());
    Effects::count(events, effects);
    append_static_sounds(events, static_sounds);
  }));
  return index;
}

void DemoIndex::add(const DemoPlayer& player, const EffectCounts& effects,
                    const std::vector<net::SpawnStaticSound>& static_sounds) {
  const double time_s = player.packet_time_s();
  const bool begins_level = player.state().events().new_level;
  packet_times_s_.push_back(time_s);
  if (!entries_.empty() && !begins_level && time_s < entries_.back().time_s + spacing_s_) return;
  if (entries_.size() == kMaxEntries) drop_every_second();
  entries_.push_back({player.place(), time_s, begins_level, effects, static_sounds});
  bytes_ += count_bytes(entries_.back());
  while (bytes_ > kMaxBytes && entries_.size() > 2) drop_every_second();
}

std::size_t DemoIndex::count_bytes(const Entry& entry) {
  return entry.place.memory_bytes() + entry.static_sounds.size() * sizeof(net::SpawnStaticSound);
}

// Drops every second entry. The first stays, as everything before the second starts there.
void DemoIndex::drop_every_second() {
  std::size_t kept = 0;
  bytes_ = 0;
  for (std::size_t i = 0; i < entries_.size(); i += 2) {
    if (i != kept) entries_[kept] = std::move(entries_[i]);
    bytes_ += count_bytes(entries_[kept]);
    ++kept;
  }
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(kept), entries_.end());
  spacing_s_ *= 2;
}

// The start of a level needs no lead-in, as no effects from before it exist. Falls back to the first entry,
// which is the first packet.
const DemoIndex::Entry& DemoIndex::find_entry_before(double time_s, double lead_s) const {
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
    if (entry->time_s <= time_s - lead_s || (entry->begins_level && entry->time_s < time_s)) return *entry;
  return entries_.front();
}

const DemoIndex::Entry& DemoIndex::find_level_start(double time_s) const {
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
    if (entry->begins_level && entry->time_s < time_s) return *entry;
  return entries_.front();
}

bool DemoIndex::has_marks_before(double time_s) const {
  const auto first =
      std::lower_bound(mark_times_s_.begin(), mark_times_s_.end(), find_level_start(time_s).time_s);
  return first != mark_times_s_.end() && *first < time_s;
}

}  // namespace temblor::client
