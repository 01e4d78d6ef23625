// The packet layer of one connection, the same for client and server. It carries two kinds of messages:
//
// - Reliable messages arrive once and in order. A message is cut into fragments of 1024 bytes. One fragment
//   is in flight at a time; it is sent again until the peer acknowledges its sequence number (stop and wait).
// - Unreliable messages are one packet each. Lost ones are not repeated, and one that arrives after a newer
//   one is dropped.
//
// Every packet begins with the header of NetQuake (wire/packet_header.h):
//
//   +----------------+----------------+---------------------------------+
//   | flags  u16 BE  | size  u16 BE   | sequence u32 BE                 |
//   +----------------+----------------+---------------------------------+
//   | content: a fragment, an unreliable message, or nothing (an ack)   |
//   +-------------------------------------------------------------------+
//
// Reliable fragments and unreliable messages count their sequence numbers separately.
//
// The resend timeout follows the measured round trip (Jacobson, "Congestion Avoidance and Control", 1988); a
// fragment that was sent twice gives no sample (Karn's rule).
//
// A Channel is a value without socket or clock: the caller passes bytes and time, and gets messages as
// results and packets through a sink. Time is any clock in seconds that never goes back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/function_ref.h"
#include "base/result.h"
#include "net/protocol/protocol.h"
#include "platform/address.h"

namespace temblor::net {

// Size of a reliable fragment, and the largest packet content that stock peers accept in every protocol.
constexpr std::size_t kFragmentBytes = 1024;

// The largest messages that a peer accepts.
struct MessageLimits {
  std::size_t reliable_bytes = 8000;
  std::size_t unreliable_bytes = kFragmentBytes;
};
enum class PeerPlace : std::uint8_t { kNetwork, kSameMachine, kSameProcess };
PeerPlace find_peer_place(const platform::Address& peer);
// Limits of a peer that speaks `protocol`. Stock clients of protocol 15 accept 1024 bytes even on the same
// machine. 1400 bytes fit one packet of any network.
//
//                      reliable   unreliable: network   same machine   same process
//   protocol 15            8000               1024           1024          64000
//   protocols 666, 999    64000               1400          64000          64000
MessageLimits message_limits_for(Protocol protocol, PeerPlace place);

struct ChannelSettings {
  MessageLimits sent{};
  // The owner should drop a peer that sends a longer reliable message.
  std::size_t max_received_bytes = 65535;
  // Capacity for reliable messages that wait, including the one in flight.
  std::size_t queue_bytes = 256 * 1024;
  // Resend timeout until the round trip is known; later its upper bound. min_resend_s is the lower bound.
  double resend_s = 1.0;
  double min_resend_s = 0.1;
};

struct ChannelStatistics {
  std::uint64_t packets_in = 0, packets_out = 0, bytes_in = 0, bytes_out = 0;
  std::uint64_t resent = 0;      // reliable fragments sent again
  std::uint64_t duplicates = 0;  // reliable fragments received again
  std::uint64_t lost = 0;        // unreliable messages, counted from gaps in the sequence
  std::uint64_t stale = 0;       // unreliable messages dropped: too old, or too far ahead to be genuine
};

struct ChannelMessage {
  base::Bytes bytes;  // valid until the channel's next receive()
  bool reliable = false;
};

struct PacketHeader;

class Channel {
 public:
  // Receives each packet that the channel sends; the bytes are valid only during the call.
  using Sink = base::FunctionRef<void(base::Bytes packet)>;

  explicit Channel(const ChannelSettings& settings = {}) : settings_(settings) {}

  // Queues a message, and sends its first fragment if nothing is in flight. Returns kTooLarge and queues
  // nothing if the message exceeds the peer's limit or the queue is full; the owner should drop a peer that
  // reads so slowly. CHECKs that the message is not empty.
  base::Status send_reliable(base::Bytes message, double now_s, Sink send);
  // True if the queue is empty, so that the next reliable message leaves at once.
  bool can_send_reliable() const { return queued_sizes_.empty(); }
  std::size_t queued_bytes() const { return queued_.size(); }
  // How many fragments the peer has acknowledged.
  std::uint32_t acknowledged_fragments() const { return fragment_sequence_; }
  // Returns kTooLarge and sends nothing if the message exceeds the peer's limit.
  base::Status send_unreliable(base::Bytes message, Sink send);
  // Sends the fragment in flight again if its acknowledgment is overdue. Call it every tick.
  void update(double now_s, Sink send);

  // Handles one packet, and returns the message that it completes, if any. Errors: kMalformed if the bytes
  // are not a packet of a connection; the channel is unchanged, because anybody may have forged the packet.
  // kTooLarge if a reliable message exceeds max_received_bytes; the connection is unusable then.
  base::Result<std::optional<ChannelMessage>> receive(base::Bytes packet, double now_s, Sink send);

  // Applies to later messages; queued messages stay.
  void set_sent_limits(const MessageLimits& limits) { settings_.sent = limits; }
  const MessageLimits& sent_limits() const { return settings_.sent; }
  const ChannelStatistics& statistics() const { return statistics_; }
  // Smoothed round trip of reliable fragments in seconds; nullopt until the first sample.
  std::optional<double> round_trip_s() const { return round_trip_s_; }

 private:
  void send_packet(const PacketHeader& header, base::Bytes content, Sink send);
  void send_fragment(double now_s, Sink send);
  void receive_acknowledgment(std::uint32_t sequence, double now_s, Sink send);
  std::optional<ChannelMessage> receive_unreliable(std::uint32_t sequence, base::Bytes content);
  base::Result<std::optional<ChannelMessage>> receive_fragment(const PacketHeader& header,
                                                               base::Bytes content, Sink send);
  void update_round_trip(double sample_s);
  double resend_after_s() const;

  ChannelSettings settings_;
  ChannelStatistics statistics_;

  // Sending. The queued messages are stored back to back, so that a warm channel allocates nothing:
  //
  //   queued_        | first message                      | second message | ...
  //                  | acknowledged_bytes_ | in flight    |
  //   queued_sizes_  [ size of the first,                   size of the second, ... ]
  base::ByteVector queued_;
  std::vector<std::size_t> queued_sizes_;
  std::size_t acknowledged_bytes_ = 0;   // of the first message
  std::uint32_t fragment_sequence_ = 0;  // of the fragment in flight, or of the next one
  int send_count_ = 0;                   // how often the fragment in flight was sent
  double sent_at_s_ = 0;
  std::uint32_t unreliable_sequence_ = 0;  // of the next unreliable message

  std::optional<double> round_trip_s_;
  double round_trip_deviation_s_ = 0;

  // Receiving.
  std::uint32_t expected_fragment_ = 0, expected_unreliable_ = 0;
  base::ByteVector assembled_;       // fragments of the message that is arriving
  bool assembled_is_whole_ = false;  // assembled_ was returned; the next fragment starts a new message
  base::ByteVector packet_;          // scratch of send_packet(); keeps its memory
};

}  // namespace temblor::net
