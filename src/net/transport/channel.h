// One connection's packets, at either end: NetQuake's reliable messages (one fragment in flight, each
// acknowledged, sent again until it is) and unreliable ones (the newest counts, what is late is dropped).
//
// A value without socket or clock: bytes and the time go in, messages come out as results and packets through
// the sink that each call is given. Time is any clock in seconds that does not go back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/function_ref.h"
#include "base/result.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

// Content of a packet that stock peers take in any protocol; reliable messages are cut into pieces of this.
constexpr std::size_t kFragmentBytes = 1024;

// What a peer that speaks `protocol` takes in one message.
struct MessageLimits {
  std::size_t reliable_bytes = 8000;
  std::size_t unreliable_bytes = kFragmentBytes;
};
// 15: 8000 and 1024. 666 and 999: 64000, and unreliable ones 1400 (what passes networks in one piece) or,
// to a peer of this process, 64000.
MessageLimits limits_of(Protocol protocol, bool is_local);

struct ChannelSettings {
  MessageLimits sent{};
  // A peer whose message is longer than this is to be dropped.
  std::size_t max_received_bytes = 65535;
  // Reliable messages that wait, the one in flight included.
  std::size_t queue_bytes = 256 * 1024;
  // A fragment is sent again after this; sooner once the round trip is known, but never before the least.
  double resend_s = 1.0;
  double least_resend_s = 0.1;
};

struct ChannelStatistics {
  std::uint64_t packets_in = 0, packets_out = 0, bytes_in = 0, bytes_out = 0;
  std::uint64_t resent = 0;      // reliable fragments
  std::uint64_t duplicates = 0;  // reliable fragments that had come before
  std::uint64_t lost = 0;        // unreliable ones, from the gaps in their sequence
  std::uint64_t stale = 0;       // unreliable ones dropped for being late, or too far ahead to be believed
};

struct ChannelMessage {
  base::Bytes bytes;  // valid until the channel's next receive()
  bool reliable = false;
};

struct PacketHeader;

class Channel {
 public:
  using Sink = base::FunctionRef<void(base::Bytes packet)>;

  explicit Channel(const ChannelSettings& settings = {}) : settings_(settings) {}

  // Queues a message and sends its first fragment if nothing is in flight. kTooLarge, and nothing is queued,
  // for one longer than the peer takes and when the queue is full: the owner drops a peer that reads so
  // slowly. CHECKs that it is not empty.
  base::Status send_reliable(base::Bytes message, double now_s, Sink send);
  // No reliable message waits or is in flight: the next one goes out at once.
  bool can_send_reliable() const { return queued_sizes_.empty(); }
  std::size_t queued_bytes() const { return queued_.size(); }
  // kTooLarge for one longer than the peer takes.
  base::Status send_unreliable(base::Bytes message, Sink send);
  // Sends again what was not acknowledged in time. Call it every tick.
  void update(double now_s, Sink send);

  // Takes one packet: the message that it completes, if any. Errors: kMalformed for what is no packet of a
  // connection; nothing has changed, and anybody may have sent it. kTooLarge for a reliable message that is
  // longer than allowed: the connection cannot go on.
  base::Result<std::optional<ChannelMessage>> receive(base::Bytes packet, double now_s, Sink send);

  // For messages from here on; what is queued stays.
  void set_sent_limits(const MessageLimits& limits) { settings_.sent = limits; }
  const MessageLimits& sent_limits() const { return settings_.sent; }
  const ChannelStatistics& statistics() const { return statistics_; }
  // Smoothed, of reliable fragments; nothing until one has been acknowledged at its first sending.
  std::optional<double> round_trip_s() const { return round_trip_s_; }

 private:
  void send_packet(const PacketHeader& header, base::Bytes content, Sink send);
  void send_fragment(double now_s, Sink send);
  void receive_acknowledgement(std::uint32_t sequence, double now_s, Sink send);
  std::optional<ChannelMessage> receive_unreliable(std::uint32_t sequence, base::Bytes content);
  base::Result<std::optional<ChannelMessage>> receive_fragment(const PacketHeader& header,
                                                               base::Bytes content, Sink send);
  void learn_round_trip(double sample_s);
  double resend_after_s() const;

  ChannelSettings settings_;
  ChannelStatistics statistics_;

  // Sending. Of the first message in the queue, `acknowledged_bytes_` have arrived and one fragment is out.
  // The messages lie one behind the other, so that a warm channel asks the heap for nothing.
  base::ByteVector queued_;
  std::vector<std::size_t> queued_sizes_;
  std::size_t acknowledged_bytes_ = 0;
  std::uint32_t fragment_sequence_ = 0;  // of the fragment in flight, or of the next
  int sendings_ = 0;                     // of the fragment in flight
  double sent_at_s_ = 0;
  std::uint32_t unreliable_sequence_ = 0;  // of the next

  std::optional<double> round_trip_s_;
  double round_trip_deviation_s_ = 0;

  // Receiving.
  std::uint32_t expected_fragment_ = 0, expected_unreliable_ = 0;
  base::ByteVector assembled_;
  bool assembled_is_whole_ = false;  // and was handed out
  base::ByteVector packet_;          // being sent; kept for its memory
};

}  // namespace temblor::net
