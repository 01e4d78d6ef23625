#include "lockstep/peers/host_peer.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::lockstep {
namespace {

constexpr double kRepeatStart_s = 0.25;
// No honest guest is so far ahead: it makes one input for each tick that it gets.
constexpr std::size_t kMaxWaitingInputs = 256;

}  // namespace

HostPeer::HostPeer(std::unique_ptr<platform::DatagramSocket> socket, GameStart start)
    : socket_(std::move(socket)), start_(std::move(start)) {
  CHECK(socket_ != nullptr || start_.players == 1, "a game of {} players needs a network", start_.players);
  ticks_.assign(start_.delay_ticks, std::vector<StampedInput>(start_.players));
}

Waiting HostPeer::waiting() const {
  return {static_cast<std::uint8_t>(guests_.size() + 1), start_.players};
}

void HostPeer::update(double now_s) {
  now_s_ = now_s;
  receive();
  drop_silent_guests();
  assemble();
  const bool is_urgent = std::exchange(has_new_ticks_, false);
  for (Guest& guest : guests_) send(guest, is_urgent);
}

void HostPeer::receive() {
  if (!socket_) return;
  while (const std::optional<platform::Datagram> datagram = socket_->receive()) {
    const std::optional<Packet> packet = read_packet(datagram->bytes, start_.players);
    if (!packet) continue;
    if (const auto* join = std::get_if<Join>(&*packet))
      handle(datagram->from, *join);
    else
      handle_guest_packet(datagram->from, *packet);
  }
}

HostPeer::Guest* HostPeer::find(const platform::Address& address) {
  const auto found = std::ranges::find(guests_, address, &Guest::address);
  return found == guests_.end() ? nullptr : &*found;
}

void HostPeer::handle(const platform::Address& from, const Join& join) {
  const auto reply = [&](const Packet& packet) { socket_->send(from, make_packet(packet)); };
  if (Guest* const guest = find(from); guest != nullptr && guest->id == join.id) {
    guest->heard_at_s = now_s_;
  } else if (join.program_version != start_.program_version) {
    return reply(Refused{fmt::format("The game needs {}.", start_.program_version)});
  } else if (is_complete() || guest != nullptr) {
    return reply(Refused{"The game has begun, or is full."});
  } else {
    guests_.push_back({.address = from, .id = join.id, .heard_at_s = now_s_});
  }
  reply(waiting());
}

void HostPeer::handle_guest_packet(const platform::Address& from, const Packet& packet) {
  Guest* const guest = find(from);
  if (guest == nullptr || guest->has_left) return;
  guest->heard_at_s = now_s_;
  if (const auto* inputs = std::get_if<Inputs>(&packet))
    handle(*guest, *inputs);
  else if (const auto* hashes = std::get_if<EntityHashes>(&packet))
    guest->hashes.add(*hashes);
  else if (std::holds_alternative<Leave>(packet))
    guest->has_left = true;
}

// A guest's inputs follow those that are assembled and waiting; repeated ones are skipped.
void HostPeer::handle(Guest& io_guest, const Inputs& inputs) {
  if (!is_complete()) return;
  io_guest.has_start = true;
  if (inputs.next_tick <= assembled_end())
    io_guest.next_tick = std::max(io_guest.next_tick, inputs.next_tick);
  for (std::size_t i = 0; i < inputs.inputs.size(); ++i) {
    const std::uint64_t tick = std::uint64_t{inputs.first_tick} + i;
    if (tick == std::uint64_t{assembled_end()} + io_guest.inputs.size() &&
        io_guest.inputs.size() < kMaxWaitingInputs)
      io_guest.inputs.push_back(inputs.inputs[i]);
  }
}

// A guest that goes before the game begins makes room for another one.
void HostPeer::drop_silent_guests() {
  for (Guest& guest : guests_)
    if (now_s_ - guest.heard_at_s > kMaxSilence_s) guest.has_left = true;
  if (!is_complete()) std::erase_if(guests_, [](const Guest& guest) { return guest.has_left; });
}

void HostPeer::assemble() {
  const auto is_ready = [](const Guest& guest) { return guest.has_left || !guest.inputs.empty(); };
  while (!own_inputs_.empty() && std::ranges::all_of(guests_, is_ready)) {
    std::vector<StampedInput>& tick = ticks_.emplace_back();
    tick.push_back(std::move(own_inputs_.front()));
    own_inputs_.pop_front();
    for (Guest& guest : guests_) {
      if (guest.inputs.empty()) {
        tick.push_back({.input = {.leaves = !std::exchange(guest.is_marked_left, true)}});
        continue;
      }
      tick.push_back(std::move(guest.inputs.front()));
      guest.inputs.pop_front();
    }
    has_new_ticks_ = true;
  }
}

void HostPeer::send(Guest& io_guest, bool is_urgent) {
  if (!is_complete() || io_guest.has_left) return;
  if (now_s_ - io_guest.sent_at_s < (io_guest.has_start ? (is_urgent ? 0 : kResend_s) : kRepeatStart_s))
    return;
  io_guest.sent_at_s = now_s_;
  if (!io_guest.has_start) {
    const auto player = static_cast<std::uint8_t>(&io_guest - guests_.data() + 1);
    return socket_->send(io_guest.address, make_packet(Start{player, start_}));
  }
  Ticks ticks{.next_input = assembled_end() + static_cast<std::uint32_t>(io_guest.inputs.size()),
              .first_tick = std::max(io_guest.next_tick, first_tick_)};
  ticks.ticks.assign(ticks_.begin() + (ticks.first_tick - first_tick_), ticks_.end());
  socket_->send(io_guest.address, make_packet(ticks));
}

void HostPeer::add_input(StampedInput input) {
  own_inputs_.push_back(std::move(input));
  assemble();
}

std::optional<std::vector<StampedInput>> HostPeer::take_tick() {
  if (taken_ticks_ == assembled_end()) return std::nullopt;
  std::vector<StampedInput> tick = ticks_[taken_ticks_ - first_tick_];
  ++taken_ticks_;
  std::uint32_t needed = taken_ticks_;
  for (const Guest& guest : guests_)
    if (!guest.has_left) needed = std::min(needed, guest.next_tick);
  while (first_tick_ < needed) {
    ticks_.pop_front();
    ++first_tick_;
  }
  return tick;
}

void HostPeer::send_hashes(const EntityHashes& hashes) {
  const std::vector<base::ByteVector> packets = make_hash_packets(hashes);
  for (const Guest& guest : guests_)
    for (const base::ByteVector& packet : packets) socket_->send(guest.address, packet);
}

void HostPeer::leave(std::string_view reason) {
  constexpr int kCopies = 3;  // nothing repeats them after we have left
  const base::ByteVector packet = make_packet(Leave{std::string(reason)});
  for (const Guest& guest : guests_)
    for (int i = 0; i < kCopies; ++i) socket_->send(guest.address, packet);
}

}  // namespace temblor::lockstep
