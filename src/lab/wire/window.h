// Reliable messages with many in flight, as in TCP with selective acknowledgments (Mathis, Mahdavi, Floyd,
// Romanow, "TCP Selective Acknowledgment Options", RFC 2018, 1996): messages arrive in order, and a lost one
// is resent alone. Every packet acknowledges:
//
//   +-------------------+------------------+--------------------------------+------------------+
//   | header (8 bytes)  | expected (u32)   | arrived (u64)                  | one message      |
//   | data, number      | next in order    | bit i: expected + 1 + i is here| or nothing       |
//   +-------------------+------------------+--------------------------------+------------------+
//
// A message counts as lost if three that were sent after it have arrived, or if no acknowledgment has come
// for the smoothed round trip and four deviations (Jacobson 1988; at least 0.1 s, as in net/transport). TCP's
// congestion control is left out: it would send less after each loss.
#pragma once

#include <cstdint>
#include <deque>
#include <map>

#include "base/bytes.h"
#include "base/function_ref.h"
#include "base/result.h"

namespace temblor::lab::wire {

class Window {
 public:
  using Sink = base::FunctionRef<void(base::Bytes packet)>;
  using Deliver = base::FunctionRef<void(base::Bytes message)>;

  // Sends a message, which must not be empty.
  void send(base::Bytes message, double now_s, Sink sink);
  // Resends what is lost.
  void resend(double now_s, Sink sink);
  // Sends an acknowledgment alone.
  void acknowledge(Sink sink) const;
  // Delivers the messages that are now in order. kMalformed for a packet that cannot be read.
  base::Status receive(base::Bytes packet, double now_s, Deliver deliver);

 private:
  struct Sent {
    base::ByteVector message{};
    double sent_at_s = 0;
    std::uint64_t order = 0;  // of its last transmission
    int count = 0;            // of transmissions
    bool has_arrived = false;
  };
  void transmit(std::uint32_t number, Sent& io_sent, double now_s, Sink sink);
  void mark_arrived(std::uint32_t number, double now_s);
  void update_round_trip(double sample_s);
  double resend_after_s() const;

  std::deque<Sent> sent_;  // from number first_sent_ on
  std::uint32_t first_sent_ = 0;
  std::uint64_t order_ = 0, newest_arrived_order_ = 0;
  double round_trip_s_ = -1, deviation_s_ = 0;  // negative: unknown

  std::uint32_t expected_ = 0;
  std::map<std::uint32_t, base::ByteVector> early_;  // arrived before an earlier one
};

}  // namespace temblor::lab::wire
