#include "net/transport/channel.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

// Packet loss cannot explain a larger jump of the unreliable sequence: at 200 packets a second it would be
// longer than the connection timeout. Such a packet is forged, and accepting it would make all genuine
// packets look stale.
constexpr std::uint32_t kMaxUnreliableGap = 65535;

// Gains of the round trip estimator; the timeout is mean + kDeviations * deviation (Jacobson 1988).
constexpr double kSampleWeight = 1.0 / 8, kDeviationWeight = 1.0 / 4, kDeviations = 4;

}  // namespace

PeerPlace find_peer_place(const platform::Address& peer) {
  if (peer.is_local()) return PeerPlace::kSameProcess;
  return peer.is_loopback() ? PeerPlace::kSameMachine : PeerPlace::kNetwork;
}

MessageLimits message_limits_for(Protocol protocol, PeerPlace place) {
  constexpr std::size_t kLongest = 64000, kOnePacket = 1400;
  const bool is_stock = protocol == Protocol::kNetQuake;
  MessageLimits limits;
  if (!is_stock) limits = {.reliable_bytes = kLongest, .unreliable_bytes = kOnePacket};
  if (place == PeerPlace::kSameProcess || (!is_stock && place == PeerPlace::kSameMachine))
    limits.unreliable_bytes = kLongest;
  return limits;
}

base::Status Channel::send_reliable(base::Bytes message, double now_s, Sink send) {
  CHECK(!message.empty());
  if (message.size() > settings_.sent.reliable_bytes)
    return base::error(base::ErrorCode::kTooLarge,
                       "reliable message of {} bytes exceeds the peer's limit of {}", message.size(),
                       settings_.sent.reliable_bytes);
  if (queued_.size() + message.size() > settings_.queue_bytes)
    return base::error(base::ErrorCode::kTooLarge,
                       "reliable queue is full: {} bytes wait, {} more exceed its {}", queued_.size(),
                       message.size(), settings_.queue_bytes);
  queued_.insert(queued_.end(), message.begin(), message.end());
  queued_sizes_.push_back(message.size());
  if (queued_sizes_.size() == 1) send_fragment(now_s, send);
  return base::Ok{};
}

base::Status Channel::send_unreliable(base::Bytes message, Sink send) {
  if (message.size() > settings_.sent.unreliable_bytes)
    return base::error(base::ErrorCode::kTooLarge,
                       "unreliable message of {} bytes exceeds the peer's limit of {}", message.size(),
                       settings_.sent.unreliable_bytes);
  send_packet({PacketKind::kUnreliable, unreliable_sequence_++}, message, send);
  return base::Ok{};
}

void Channel::update(double now_s, Sink send) {
  if (queued_sizes_.empty() || now_s - sent_at_s_ < resend_after_s()) return;
  ++statistics_.resent;
  send_fragment(now_s, send);
}

base::Result<std::optional<ChannelMessage>> Channel::receive(base::Bytes packet, double now_s, Sink send) {
  TRY(const PacketHeader header, read_packet_header(packet));
  ++statistics_.packets_in;
  statistics_.bytes_in += packet.size();
  const base::Bytes content = packet.subspan(kPacketHeaderBytes);
  switch (header.kind) {
    case PacketKind::kAck:
      receive_acknowledgment(header.sequence, now_s, send);
      return std::optional<ChannelMessage>{};
    case PacketKind::kUnreliable:
      return receive_unreliable(header.sequence, content);
    case PacketKind::kData:
    case PacketKind::kLastData:
      break;
  }
  return receive_fragment(header, content, send);
}

// One buffer for header and content, because a datagram socket sends one block of bytes.
void Channel::send_packet(const PacketHeader& header, base::Bytes content, Sink send) {
  const auto head = packet_header_bytes(header, kPacketHeaderBytes + content.size());
  packet_.assign(head.begin(), head.end());
  packet_.insert(packet_.end(), content.begin(), content.end());
  ++statistics_.packets_out;
  statistics_.bytes_out += packet_.size();
  send(packet_);
}

// For the first copy and for resends alike: what is in flight depends only on acknowledged_bytes_.
void Channel::send_fragment(double now_s, Sink send) {
  const base::Bytes message = base::Bytes(queued_).first(queued_sizes_.front());
  const base::Bytes rest = message.subspan(acknowledged_bytes_);
  const bool is_last = rest.size() <= kFragmentBytes;
  ++send_count_;
  sent_at_s_ = now_s;
  send_packet({is_last ? PacketKind::kLastData : PacketKind::kData, fragment_sequence_},
              rest.first(std::min(rest.size(), kFragmentBytes)), send);
}

void Channel::receive_acknowledgment(std::uint32_t sequence, double now_s, Sink send) {
  if (queued_sizes_.empty() || sequence != fragment_sequence_) return;  // duplicate of an old one
  // After a resend, the acknowledgment may answer either copy: no sample (Karn's rule).
  if (send_count_ == 1) update_round_trip(now_s - sent_at_s_);
  send_count_ = 0;
  ++fragment_sequence_;
  acknowledged_bytes_ += kFragmentBytes;
  if (const std::size_t size = queued_sizes_.front(); acknowledged_bytes_ >= size) {
    queued_.erase(queued_.begin(), queued_.begin() + static_cast<std::ptrdiff_t>(size));
    queued_sizes_.erase(queued_sizes_.begin());
    acknowledged_bytes_ = 0;
  }
  if (!queued_sizes_.empty()) send_fragment(now_s, send);
}

std::optional<ChannelMessage> Channel::receive_unreliable(std::uint32_t sequence, base::Bytes content) {
  // Unsigned: an old packet gives a huge gap. Sequence numbers wrap around the same way.
  const std::uint32_t gap = sequence - expected_unreliable_;
  if (gap > kMaxUnreliableGap) {
    ++statistics_.stale;
    return std::nullopt;
  }
  statistics_.lost += gap;
  expected_unreliable_ = sequence + 1;
  return ChannelMessage{content, false};
}

base::Result<std::optional<ChannelMessage>> Channel::receive_fragment(const PacketHeader& header,
                                                                      base::Bytes content, Sink send) {
  // Acknowledge duplicates too: the peer repeats a fragment because it lost our acknowledgment.
  send_packet({PacketKind::kAck, header.sequence}, {}, send);
  if (header.sequence != expected_fragment_) {
    ++statistics_.duplicates;
    return std::optional<ChannelMessage>{};
  }
  if (assembled_is_whole_) assembled_.clear();
  assembled_is_whole_ = false;
  if (assembled_.size() + content.size() > settings_.max_received_bytes)
    return base::error(base::ErrorCode::kTooLarge, "reliable message exceeds {} bytes",
                       settings_.max_received_bytes);
  ++expected_fragment_;
  assembled_.insert(assembled_.end(), content.begin(), content.end());
  if (header.kind != PacketKind::kLastData) return std::optional<ChannelMessage>{};
  assembled_is_whole_ = true;
  return std::optional<ChannelMessage>{ChannelMessage{assembled_, true}};
}

void Channel::update_round_trip(double sample_s) {
  if (!round_trip_s_) {
    round_trip_s_ = sample_s;
    round_trip_deviation_s_ = sample_s / 2;
    return;
  }
  const double off_s = sample_s - *round_trip_s_;
  *round_trip_s_ += off_s * kSampleWeight;
  round_trip_deviation_s_ += (std::abs(off_s) - round_trip_deviation_s_) * kDeviationWeight;
}

double Channel::resend_after_s() const {
  if (!round_trip_s_) return settings_.resend_s;
  const double expected_s = *round_trip_s_ + kDeviations * round_trip_deviation_s_;
  return std::clamp(expected_s, settings_.min_resend_s, settings_.resend_s);
}

}  // namespace temblor::net
