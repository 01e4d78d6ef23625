#include "net/transport/channel.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

// An unreliable packet further ahead than this was not preceded by lost ones: at 200 packets a second it is
// longer than the silence after which a connection is given up. Somebody made it up, and to believe it would
// make everything that follows late.
constexpr std::uint32_t kMaxUnreliableGap = 65535;

// Of the estimate of the round trip (Jacobson, Congestion Avoidance and Control, 1988).
constexpr double kSampleWeight = 1.0 / 8, kDeviationWeight = 1.0 / 4, kDeviations = 4;

}  // namespace

MessageLimits limits_of(Protocol protocol, bool is_local) {
  if (protocol == Protocol::kNetQuake) return {};
  return {64000, is_local ? std::size_t{64000} : std::size_t{1400}};
}

base::Status Channel::send_reliable(base::Bytes message, double now_s, Sink send) {
  CHECK(!message.empty());
  if (message.size() > settings_.sent.reliable_bytes)
    return base::error(base::ErrorCode::kTooLarge, "a reliable message of {} bytes, the peer takes {}",
                       message.size(), settings_.sent.reliable_bytes);
  if (queued_.size() + message.size() > settings_.queue_bytes)
    return base::error(base::ErrorCode::kTooLarge,
                       "{} bytes of reliable messages wait, no room for {} more of at most {}",
                       queued_.size(), message.size(), settings_.queue_bytes);
  queued_.insert(queued_.end(), message.begin(), message.end());
  queued_sizes_.push_back(message.size());
  if (queued_sizes_.size() == 1) send_fragment(now_s, send);
  return base::Ok{};
}

base::Status Channel::send_unreliable(base::Bytes message, Sink send) {
  if (message.size() > settings_.sent.unreliable_bytes)
    return base::error(base::ErrorCode::kTooLarge, "an unreliable message of {} bytes, the peer takes {}",
                       message.size(), settings_.sent.unreliable_bytes);
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
      receive_acknowledgement(header.sequence, now_s, send);
      return std::optional<ChannelMessage>{};
    case PacketKind::kUnreliable:
      return receive_unreliable(header.sequence, content);
    case PacketKind::kData:
    case PacketKind::kLastData:
      break;
  }
  return receive_fragment(header, content, send);
}

void Channel::send_packet(const PacketHeader& header, base::Bytes content, Sink send) {
  const auto head = packet_header_bytes(header, kPacketHeaderBytes + content.size());
  packet_.assign(head.begin(), head.end());
  packet_.insert(packet_.end(), content.begin(), content.end());
  ++statistics_.packets_out;
  statistics_.bytes_out += packet_.size();
  send(packet_);
}

void Channel::send_fragment(double now_s, Sink send) {
  const base::Bytes message = base::Bytes(queued_).first(queued_sizes_.front());
  const base::Bytes rest = message.subspan(acknowledged_bytes_);
  const bool is_last = rest.size() <= kFragmentBytes;
  ++sendings_;
  sent_at_s_ = now_s;
  send_packet({is_last ? PacketKind::kLastData : PacketKind::kData, fragment_sequence_},
              rest.first(std::min(rest.size(), kFragmentBytes)), send);
}

void Channel::receive_acknowledgement(std::uint32_t sequence, double now_s, Sink send) {
  if (queued_sizes_.empty() || sequence != fragment_sequence_) return;  // of one acknowledged before
  // Of a fragment that was sent twice, nobody knows which sending this answers (Karn's rule).
  if (sendings_ == 1) learn_round_trip(now_s - sent_at_s_);
  sendings_ = 0;
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
  // Also what came before: its acknowledgement was lost, and the peer waits for one.
  send_packet({PacketKind::kAck, header.sequence}, {}, send);
  if (header.sequence != expected_fragment_) {
    ++statistics_.duplicates;
    return std::optional<ChannelMessage>{};
  }
  if (assembled_is_whole_) assembled_.clear();
  assembled_is_whole_ = false;
  if (assembled_.size() + content.size() > settings_.max_received_bytes)
    return base::error(base::ErrorCode::kTooLarge, "a reliable message is longer than {} bytes",
                       settings_.max_received_bytes);
  ++expected_fragment_;
  assembled_.insert(assembled_.end(), content.begin(), content.end());
  if (header.kind != PacketKind::kLastData) return std::optional<ChannelMessage>{};
  assembled_is_whole_ = true;
  return std::optional<ChannelMessage>{ChannelMessage{assembled_, true}};
}

void Channel::learn_round_trip(double sample_s) {
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
  return std::clamp(expected_s, settings_.least_resend_s, settings_.resend_s);
}

}  // namespace temblor::net
