// Notes of a simulation: which state was shown at which time, and which input was played in which tick. None
// of it goes over the network.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lab/wire.h"

namespace temblor::lab::wire {

class Record {
 public:
  explicit Record(const World& world) : world_(world) {}

  // The viewer decoded these messages. Compares them with the recorded tick of the same time.
  void show(base::Bytes messages, double now_s);
  // The viewer computed this tick.
  void show_tick(std::size_t tick, double now_s) { shown_.push_back({now_s, tick}); }
  // `tick` was played with the viewer's inputs up to number `input`.
  void play(std::size_t tick, std::size_t input);
  void count_wrong_state() { ++wrong_states_; }
  void count_unreadable() { ++unreadable_; }
  void count_wrong_input() { ++wrong_inputs_; }

  // `input_times_s`: when each input was given; those before `warm_s` or after the end are left out.
  Transcript finish(const std::vector<double>& input_times_s, double warm_s, double end_s) &&;

 private:
  static constexpr std::size_t kNotPlayed = std::numeric_limits<std::size_t>::max();

  const World& world_;
  std::vector<Shown> shown_;
  std::vector<std::size_t> first_ticks_;  // by input: the first tick that follows it
  std::uint64_t wrong_states_ = 0, unreadable_ = 0, wrong_inputs_ = 0;
};

}  // namespace temblor::lab::wire
