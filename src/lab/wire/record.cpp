#include "lab/wire/record.h"

#include <algorithm>
#include <utility>

namespace temblor::lab::wire {
namespace {

constexpr std::uint8_t kTimeMessage = 7;  // svc_time

}  // namespace

void Record::show(base::Bytes messages, double now_s) {
  base::ByteReader reader(messages);
  const std::uint8_t kind = reader.u8();
  const float time_s = reader.f32();
  const auto found = std::ranges::lower_bound(world_.ticks, time_s, {}, &WorldTick::time_s);
  const bool is_right = reader.ok() && kind == kTimeMessage && found != world_.ticks.end() &&
                        std::ranges::equal(messages, found->messages);
  if (is_right)
    show_tick(static_cast<std::size_t>(found - world_.ticks.begin()), now_s);
  else
    count_wrong_state();
}

void Record::play(std::size_t tick, std::size_t input) {
  if (input >= first_ticks_.size()) first_ticks_.resize(input + 1, kNotPlayed);
  // Input that was lost is part of the next one that arrives: buttons are still held.
  for (std::size_t i = input + 1; i-- > 0 && first_ticks_[i] == kNotPlayed;) first_ticks_[i] = tick;
}

Transcript Record::finish(const std::vector<double>& input_times_s, double warm_s, double end_s) && {
  Transcript transcript{.shown = std::move(shown_),
                        .wrong_states = wrong_states_,
                        .unreadable = unreadable_,
                        .wrong_inputs = wrong_inputs_,
                        .end_s = end_s};
  const std::size_t count = std::min(input_times_s.size(), first_ticks_.size());
  for (std::size_t i = 0; i < count; ++i)
    if (input_times_s[i] >= warm_s && input_times_s[i] < end_s && first_ticks_[i] != kNotPlayed)
      transcript.inputs.push_back({input_times_s[i], first_ticks_[i]});
  return transcript;
}

}  // namespace temblor::lab::wire
