#include "lab/wire/window.h"

#include <algorithm>
#include <cmath>

#include "net/wire/packet_header.h"

namespace temblor::lab::wire {
namespace {

constexpr std::size_t kWindowHeaderBytes = net::kPacketHeaderBytes + 4 + 8;
constexpr std::uint32_t kMaskBits = 64;
constexpr std::uint64_t kOvertakingPackets = 3;
// The peer answers in its next tick, so a round trip is not known better than this (RFC 6298).
constexpr double kGranularity_s = 0.02;
constexpr double kFirstResend_s = 1, kMinResend_s = 0.1;

std::uint64_t make_mask(std::uint32_t expected, const std::map<std::uint32_t, base::ByteVector>& early) {
  std::uint64_t mask = 0;
  for (const auto& [number, unused] : early)
    if (number - expected - 1 < kMaskBits) mask |= std::uint64_t{1} << (number - expected - 1);
  return mask;
}

void write_window_packet(const net::PacketHeader& header, std::uint32_t expected, std::uint64_t mask,
                         base::Bytes message, Window::Sink sink) {
  base::ByteWriter writer;
  writer.bytes(net::packet_header_bytes(header, kWindowHeaderBytes + message.size()));
  writer.u32(expected);
  writer.write(mask);
  writer.bytes(message);
  sink(writer.view());
}

}  // namespace

void Window::send(base::Bytes message, double now_s, Sink sink) {
  sent_.push_back({.message = base::ByteVector(message.begin(), message.end())});
  transmit(first_sent_ + static_cast<std::uint32_t>(sent_.size()) - 1, sent_.back(), now_s, sink);
}

void Window::transmit(std::uint32_t number, Sent& io_sent, double now_s, Sink sink) {
  io_sent.sent_at_s = now_s;
  io_sent.order = ++order_;
  ++io_sent.count;
  write_window_packet({net::PacketKind::kLastData, number}, expected_, make_mask(expected_, early_),
                      io_sent.message, sink);
}

void Window::acknowledge(Sink sink) const {
  write_window_packet({net::PacketKind::kUnreliable, 0}, expected_, make_mask(expected_, early_), {}, sink);
}

void Window::resend(double now_s, Sink sink) {
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    Sent& io_sent = sent_[i];
    if (io_sent.has_arrived) continue;
    const bool is_overtaken = io_sent.order + kOvertakingPackets <= newest_arrived_order_;
    const bool is_overdue = now_s - io_sent.sent_at_s > resend_after_s();
    if (is_overtaken || is_overdue)
      transmit(first_sent_ + static_cast<std::uint32_t>(i), io_sent, now_s, sink);
  }
}

base::Status Window::receive(base::Bytes packet, double now_s, Deliver deliver) {
  TRY(const net::PacketHeader header, net::read_packet_header(packet));
  base::ByteReader reader(packet.subspan(net::kPacketHeaderBytes));
  const std::uint32_t acknowledged = reader.u32();
  const auto mask = reader.read<std::uint64_t>();
  if (!reader.ok()) return base::malformed("packet of a window is too short");
  for (std::uint32_t number = first_sent_; number < acknowledged; ++number) mark_arrived(number, now_s);
  for (std::uint32_t bit = 0; bit < kMaskBits; ++bit)
    if ((mask >> bit & 1) != 0) mark_arrived(acknowledged + 1 + bit, now_s);
  for (; !sent_.empty() && sent_.front().has_arrived; ++first_sent_) sent_.pop_front();
  if (header.kind != net::PacketKind::kLastData || header.sequence < expected_) return base::Ok{};
  const base::Bytes message = reader.take(reader.remaining());
  early_.try_emplace(header.sequence, message.begin(), message.end());
  for (auto next = early_.find(expected_); next != early_.end(); next = early_.find(expected_)) {
    deliver(next->second);
    early_.erase(next);
    ++expected_;
  }
  return base::Ok{};
}

void Window::mark_arrived(std::uint32_t number, double now_s) {
  const std::size_t i = number - first_sent_;
  if (i >= sent_.size() || sent_[i].has_arrived) return;
  Sent& io_sent = sent_[i];
  io_sent.has_arrived = true;
  // If it was sent twice, nobody knows which one has arrived (Karn's rule).
  if (io_sent.count > 1) return;
  newest_arrived_order_ = std::max(newest_arrived_order_, io_sent.order);
  update_round_trip(now_s - io_sent.sent_at_s);
}

void Window::update_round_trip(double sample_s) {
  if (round_trip_s_ < 0) {
    round_trip_s_ = sample_s;
    deviation_s_ = sample_s / 2;
    return;
  }
  const double error_s = sample_s - round_trip_s_;
  round_trip_s_ += error_s / 8;
  deviation_s_ += (std::abs(error_s) - deviation_s_) / 4;
}

double Window::resend_after_s() const {
  return round_trip_s_ < 0
             ? kFirstResend_s
             : std::max(round_trip_s_ + std::max(4 * deviation_s_, kGranularity_s), kMinResend_s);
}

}  // namespace temblor::lab::wire
