// Peers that send each other their inputs. An input is played a fixed number of ticks after it was given, so
// that it has time to arrive. A peer plays a tick when it has the inputs of all peers, and otherwise waits.
//
//   +------------------+----------------+--------------+---------------+-----------------------------+
//   | header (8 bytes) | expected (u32) | played (u32) | hash (u32)    | runs of moves, at most two: |
//   |                  | next tick that | ticks that   | of the state  | first tick (u32), count     |
//   |                  | I need of you  | I have played| after them    | (u8), clc_moves             |
//   +------------------+----------------+--------------+---------------+-----------------------------+
//
// Each packet repeats the moves of the last ticks, so that a few lost packets lose none. If they are not
// acknowledged in time, the oldest ones are sent again. A peer's world is the recorded one: all peers would
// compute the same.
#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "base/hash.h"
#include "lab/wire/methods.h"
#include "net/wire/packet_header.h"

namespace temblor::lab::wire {
namespace {

struct PeerPacket {
  std::uint32_t expected = 0, played = 0, hash = 0;
};

net::Move make_peer_move(std::size_t peer, std::size_t input) {
  net::Move move = make_move(input, 0);
  move.up = static_cast<std::int16_t>(peer);
  return move;
}

class Peer : public Node {
 public:
  Peer(const Parts& parts, std::size_t number)
      : parts_(parts),
        number_(number),
        delay_(find_input_delay(parts.setup.link, parts.world.tick_s)),
        others_(static_cast<std::size_t>(parts.setup.players)) {
    // The first ticks have no inputs.
    for (Other& other : others_) other.expected = other.acknowledged = static_cast<std::uint32_t>(delay_);
  }

  void step(std::size_t number, double now_s, Send send) override {
    step_ = number;
    for (std::size_t peer = 0; peer < others_.size(); ++peer)
      if (peer != number_) send_moves(peer, send);
    play(now_s);
  }

  void receive(std::size_t from, base::Bytes packet, double now_s, Send) override {
    if (!read(from, packet)) parts_.record.count_unreadable();
    play(now_s);
  }

 private:
  struct Other {
    std::map<std::size_t, net::Move> moves;  // by tick, not played yet
    std::uint32_t expected = 0;              // the first tick whose move has not arrived
    std::uint32_t acknowledged = 0;          // it has my moves of all ticks before this one
  };

  net::Protocol protocol() const { return parts_.world.dialect.protocol; }

  // The move of a tick was given `delay_` steps before it.
  void write_run(std::size_t first_tick, std::size_t count, base::ByteWriter& io_writer) const {
    io_writer.u32(static_cast<std::uint32_t>(first_tick));
    io_writer.u8(static_cast<std::uint8_t>(count));
    for (std::size_t tick = first_tick; tick < first_tick + count; ++tick)
      if (!write_client_message(make_peer_move(number_, tick - delay_), protocol(), io_writer).ok())
        parts_.record.count_unreadable();
  }

  void send_moves(std::size_t peer, Send send) {
    base::ByteWriter body;
    body.u32(others_[peer].expected);
    body.u32(static_cast<std::uint32_t>(played_));
    body.u32(hash_);
    const std::size_t newest = step_ + delay_;
    const std::size_t count = std::min(net::kMovesInPacket, step_ + 1), first = newest + 1 - count;
    const std::size_t oldest = others_[peer].acknowledged;
    if (oldest < first && is_overdue(oldest))
      write_run(oldest, std::min(net::kMovesInPacket, first - oldest), body);
    write_run(first, count, body);
    base::ByteWriter packet;
    packet.bytes(net::packet_header_bytes({net::PacketKind::kUnreliable, static_cast<std::uint32_t>(step_)},
                                          net::kPacketHeaderBytes + body.size()));
    packet.bytes(body.view());
    send(peer, packet.view());
  }

  // Whether an acknowledgment of this tick's move should have come: after a round trip, and a tick at each
  // end.
  bool is_overdue(std::size_t tick) const {
    const Link& link = parts_.setup.link;
    const double since_s = static_cast<double>(step_ + delay_ - tick) * parts_.world.tick_s;
    return since_s > 2 * (link.delay_s + link.jitter_s + parts_.world.tick_s);
  }

  bool read(std::size_t from, base::Bytes packet) {
    if (!net::read_packet_header(packet).ok()) return false;
    base::ByteReader reader(packet.subspan(net::kPacketHeaderBytes));
    PeerPacket head;
    head.expected = reader.u32();
    head.played = reader.u32();
    head.hash = reader.u32();
    Other& other = others_[from];
    other.acknowledged = std::max(other.acknowledged, head.expected);
    if (head.played > 0 && head.played <= hashes_.size() && hashes_[head.played - 1] != head.hash)
      parts_.record.count_wrong_state();
    while (reader.ok() && reader.remaining() > 0)
      if (!read_run(reader, other)) return false;
    while (other.moves.contains(other.expected)) ++other.expected;
    return reader.ok();
  }

  bool read_run(base::ByteReader& io_reader, Other& io_other) const {
    const std::size_t first = io_reader.u32(), count = io_reader.u8();
    base::ByteWriter example;
    if (!write_client_message(net::Move{}, protocol(), example).ok()) return false;
    net::ClientMessageReader moves(io_reader.take(count * example.size()), protocol());
    for (std::size_t tick = first; tick < first + count; ++tick) {
      const auto move = moves.next();
      if (!move.ok() || !*move || !std::holds_alternative<net::Move>(**move)) return false;
      if (tick >= io_other.expected) io_other.moves.try_emplace(tick, std::get<net::Move>(**move));
    }
    return true;
  }

  bool has_all_moves(std::size_t tick) const {
    for (std::size_t peer = 0; peer < others_.size(); ++peer)
      if (peer != number_ && tick >= others_[peer].expected) return false;
    return true;
  }

  // Plays all ticks that are due.
  void play(double now_s) {
    for (; played_ <= step_ && played_ < parts_.world.ticks.size() && has_all_moves(played_); ++played_) {
      for (std::size_t peer = 0; peer < others_.size(); ++peer)
        if (peer != number_ && played_ >= delay_) take_move(peer);
      hash_ = static_cast<std::uint32_t>(base::hash_with_bytes(hash_, parts_.world.ticks[played_].messages));
      hashes_.push_back(hash_);
      if (number_ != kViewer) continue;
      if (played_ >= delay_) parts_.record.play(played_, played_ - delay_);
      parts_.record.show_tick(played_, now_s);
    }
  }

  void take_move(std::size_t peer) {
    const auto found = others_[peer].moves.find(played_);
    const net::Move right = make_peer_move(peer, played_ - delay_);
    if (found == others_[peer].moves.end() || find_input(found->second) != find_input(right) ||
        found->second.up != right.up)
      return parts_.record.count_wrong_input();
    others_[peer].moves.erase(found);
  }

  Parts parts_;
  std::size_t number_, delay_;
  std::vector<Other> others_;  // by peer; its own is unused
  std::size_t step_ = 0, played_ = 0;
  std::uint32_t hash_ = 0;
  std::vector<std::uint32_t> hashes_;  // by tick
};

}  // namespace

std::size_t find_input_delay(const Link& link, double tick_s) {
  return static_cast<std::size_t>(std::ceil((link.delay_s + link.jitter_s) / tick_s)) + 1;
}

Nodes make_lockstep_nodes(const Parts& parts) {
  Nodes nodes;
  for (std::size_t peer = 0; peer < static_cast<std::size_t>(parts.setup.players); ++peer)
    nodes.push_back(std::make_unique<Peer>(parts, peer));
  return nodes;
}

}  // namespace temblor::lab::wire
