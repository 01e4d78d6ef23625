#include "lockstep/peers/guest_peer.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::lockstep {
namespace {

constexpr double kRepeatJoin_s = 0.5;

}  // namespace

GuestPeer::GuestPeer(std::unique_ptr<platform::DatagramSocket> socket, const platform::Address& host,
                     std::string program_version, std::uint64_t id)
    : socket_(std::move(socket)), host_(host), program_version_(std::move(program_version)), id_(id) {}

void GuestPeer::update(double now_s) {
  now_s_ = now_s;
  if (!heard_at_s_) heard_at_s_ = now_s;
  receive();
  if (failure_.empty() && now_s - *heard_at_s_ > kMaxSilence_s)
    failure_ = fmt::format("{} does not answer.", platform::to_text(host_));
  if (failure_.empty()) send(now_s);
}

void GuestPeer::receive() {
  while (const std::optional<platform::Datagram> datagram = socket_->receive()) {
    if (datagram->from != host_) continue;
    const std::optional<Packet> packet = read_packet(datagram->bytes, start_ ? start_->start.players : 0);
    if (!packet) continue;
    heard_at_s_ = now_s_;
    if (const auto* waiting = std::get_if<Waiting>(&*packet))
      waiting_ = *waiting;
    else if (const auto* start = std::get_if<Start>(&*packet))
      handle(*start);
    else if (const auto* ticks = std::get_if<Ticks>(&*packet))
      handle(*ticks);
    else if (const auto* hashes = std::get_if<EntityHashes>(&*packet))
      hashes_.add(*hashes);
    else if (const auto* refused = std::get_if<Refused>(&*packet); refused != nullptr && !start_)
      failure_ = refused->reason;
    else if (const auto* leave = std::get_if<Leave>(&*packet))
      failure_ = leave->reason;
  }
}

void GuestPeer::handle(const Start& start) {
  if (start_) return;
  start_ = start;
  first_input_ = start.start.delay_ticks;
  has_news_ = true;
}

void GuestPeer::handle(const Ticks& ticks) {
  if (!start_) return;
  for (std::size_t i = 0; i < ticks.ticks.size(); ++i) {
    if (std::uint64_t{ticks.first_tick} + i != next_tick_) continue;
    ticks_.push_back(ticks.ticks[i]);
    ++next_tick_;
    has_news_ = true;
  }
  while (!own_inputs_.empty() && first_input_ < ticks.next_input) {
    own_inputs_.pop_front();
    ++first_input_;
  }
}

void GuestPeer::send(double now_s) {
  if (!start_) {
    if (now_s - sent_at_s_ < kRepeatJoin_s && sent_at_s_ >= 0) return;
    sent_at_s_ = now_s;
    return socket_->send(host_, make_packet(Join{id_, program_version_}));
  }
  if (!std::exchange(has_news_, false) && now_s - sent_at_s_ < kResend_s) return;
  sent_at_s_ = now_s;
  socket_->send(host_,
                make_packet(Inputs{next_tick_, first_input_, {own_inputs_.begin(), own_inputs_.end()}}));
}

void GuestPeer::add_input(StampedInput input) {
  own_inputs_.push_back(std::move(input));
  has_news_ = true;
}

std::optional<std::vector<StampedInput>> GuestPeer::take_tick() {
  if (ticks_.empty()) return std::nullopt;
  std::vector<StampedInput> tick = std::move(ticks_.front());
  ticks_.pop_front();
  return tick;
}

void GuestPeer::send_hashes(const EntityHashes& hashes) {
  for (const base::ByteVector& packet : make_hash_packets(hashes)) socket_->send(host_, packet);
}

void GuestPeer::leave(std::string_view reason) {
  constexpr int kCopies = 3;  // nothing repeats them after we have left
  const base::ByteVector packet = make_packet(Leave{std::string(reason)});
  for (int i = 0; i < kCopies; ++i) socket_->send(host_, packet);
}

}  // namespace temblor::lockstep
