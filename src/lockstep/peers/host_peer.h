// The host of a lockstep game: gathers the players, puts their inputs together tick by tick, and sends the
// result to all. A player who leaves or falls silent leaves the game with the next tick, and the others go
// on.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "lockstep/peers/peer.h"
#include "platform/datagram_socket.h"

namespace temblor::lockstep {

class HostPeer : public Peer {
 public:
  // `socket` may be null in a game of one player. `start`: of the game.
  HostPeer(std::unique_ptr<platform::DatagramSocket> socket, GameStart start);

  void update(double now_s) override;
  const GameStart* start() const override { return is_complete() ? &start_ : nullptr; }
  std::size_t player() const override { return 0; }
  Waiting waiting() const override;
  void add_input(StampedInput input) override;
  std::optional<std::vector<StampedInput>> take_tick() override;
  void send_hashes(const EntityHashes& hashes) override;
  const std::optional<EntityHashes>& received_hashes(std::size_t player) const override {
    return guests_[player - 1].hashes.complete();
  }
  bool sets_pace() const override { return true; }
  const std::string& failure() const override { return failure_; }
  void leave(std::string_view reason) override;

 private:
  struct Guest {
    platform::Address address;
    std::uint64_t id = 0;
    bool has_start = false;  // it has sent inputs
    bool has_left = false;
    bool is_marked_left = false;        // an assembled tick says that it has left
    std::uint32_t next_tick = 0;        // the first assembled tick that it lacks
    std::deque<StampedInput> inputs{};  // which are not assembled yet
    HashCollector hashes{};
    double heard_at_s = 0, sent_at_s = -1;
  };

  bool is_complete() const { return guests_.size() + 1 == start_.players; }
  void receive();
  void handle(const platform::Address& from, const Join& join);
  void handle(Guest& io_guest, const Inputs& inputs);
  void handle_guest_packet(const platform::Address& from, const Packet& packet);
  void drop_silent_guests();
  void assemble();
  void send(Guest& io_guest, bool is_urgent);
  Guest* find(const platform::Address& address);
  std::uint32_t assembled_end() const { return first_tick_ + static_cast<std::uint32_t>(ticks_.size()); }

  std::unique_ptr<platform::DatagramSocket> socket_;
  GameStart start_;
  std::vector<Guest> guests_;  // by number; players' numbers are one higher
  std::deque<StampedInput> own_inputs_;
  // Assembled ticks from first_tick_ on; earlier ones were played here and have arrived everywhere.
  std::deque<std::vector<StampedInput>> ticks_;
  std::uint32_t first_tick_ = 0, taken_ticks_ = 0;
  bool has_new_ticks_ = false;  // since they were sent last
  std::string failure_;
  double now_s_ = 0;
};

}  // namespace temblor::lockstep
