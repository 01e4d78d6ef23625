// A network in virtual time, which delays and loses packets, and the clocks of its nodes: a queue of events
// in the order of time. Events of the same time keep the order in which they were made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "lab/wire.h"
#include "lab/wire/random_numbers.h"

namespace temblor::lab::wire {

struct Event {
  enum class Kind : std::uint8_t { kStep, kArrival };
  double at_s = 0;
  std::uint64_t order = 0;
  Kind kind = Kind::kStep;
  std::size_t node = 0;    // whose clock it is, or where the packet arrives
  std::size_t from = 0;    // of an arrival
  std::size_t number = 0;  // of a step
  base::ByteVector packet{};
};

class Network {
 public:
  // `viewer`: the node whose traffic counts.
  Network(const Setup& setup, std::size_t viewer, double end_s);

  void add_step(std::size_t node, std::size_t number, double at_s);
  // Every packet begins with the engine's header (net/wire/packet_header.h).
  void send(std::size_t from, std::size_t to, base::Bytes packet, double now_s);

  bool is_empty() const { return events_.empty(); }
  Event take_next();
  // Writes the traffic and the losses into a transcript.
  void report(Transcript& io_transcript) const;

 private:
  struct IsLater {
    bool operator()(const Event& a, const Event& b) const {
      return a.at_s != b.at_s ? a.at_s > b.at_s : a.order > b.order;
    }
  };
  bool is_lost(std::size_t to, base::Bytes packet, double now_s);

  Link link_;
  double warm_s_, end_s_;
  std::optional<double> lose_one_at_s_;
  std::size_t viewer_;
  RandomNumbers random_;
  std::priority_queue<Event, std::vector<Event>, IsLater> events_;
  std::uint64_t order_ = 0, lost_ = 0;
  Traffic to_viewer_, from_viewer_;
};

}  // namespace temblor::lab::wire
