#include "lab/wire/network.h"

#include "net/wire/packet_header.h"

namespace temblor::lab::wire {
namespace {

bool is_mere_acknowledgment(base::Bytes packet) {
  const auto header = net::read_packet_header(packet);
  return header.ok() && header->kind == net::PacketKind::kAck;
}

}  // namespace

Network::Network(const Setup& setup, std::size_t viewer, double end_s)
    : link_(setup.link),
      warm_s_(setup.warm_s),
      end_s_(end_s),
      lose_one_at_s_(setup.lose_one_at_s),
      viewer_(viewer),
      random_(setup.seed) {}

void Network::add_step(std::size_t node, std::size_t number, double at_s) {
  events_.push({.at_s = at_s, .order = order_++, .node = node, .number = number});
}

bool Network::is_lost(std::size_t to, base::Bytes packet, double now_s) {
  if (lose_one_at_s_ && now_s >= *lose_one_at_s_ && to == viewer_ && !is_mere_acknowledgment(packet)) {
    lose_one_at_s_.reset();
    return true;
  }
  // Drawn for each packet, so that the warm time does not change later draws.
  const bool is_unlucky = random_.fraction() < link_.loss;
  return is_unlucky && now_s >= warm_s_;
}

void Network::send(std::size_t from, std::size_t to, base::Bytes packet, double now_s) {
  if (now_s >= warm_s_ && now_s < end_s_ && (from == viewer_ || to == viewer_)) {
    Traffic& io_traffic = to == viewer_ ? to_viewer_ : from_viewer_;
    io_traffic.bytes += packet.size() + kInternetHeaderBytes;
    ++io_traffic.packets;
  }
  if (is_lost(to, packet, now_s)) {
    ++lost_;
    return;
  }
  const double delay_s = link_.delay_s + link_.jitter_s * random_.fraction();
  events_.push({.at_s = now_s + delay_s,
                .order = order_++,
                .kind = Event::Kind::kArrival,
                .node = to,
                .from = from,
                .packet = base::ByteVector(packet.begin(), packet.end())});
}

Event Network::take_next() {
  Event event = events_.top();
  events_.pop();
  return event;
}

void Network::report(Transcript& io_transcript) const {
  io_transcript.to_viewer = to_viewer_;
  io_transcript.from_viewer = from_viewer_;
  io_transcript.lost = lost_;
}

}  // namespace temblor::lab::wire
