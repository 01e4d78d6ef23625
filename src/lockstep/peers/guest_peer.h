// A guest of a lockstep game: joins the host, and exchanges inputs with it.
#pragma once

#include <deque>
#include <memory>

#include "lockstep/peers/peer.h"
#include "platform/datagram_socket.h"

namespace temblor::lockstep {

class GuestPeer : public Peer {
 public:
  // `id`: a random number.
  GuestPeer(std::unique_ptr<platform::DatagramSocket> socket, const platform::Address& host,
            std::string program_version, std::uint64_t id);

  void update(double now_s) override;
  const GameStart* start() const override { return start_ ? &start_->start : nullptr; }
  std::size_t player() const override { return start_ ? start_->player : 0; }
  Waiting waiting() const override { return waiting_; }
  void add_input(StampedInput input) override;
  std::optional<std::vector<StampedInput>> take_tick() override;
  void send_hashes(const EntityHashes& hashes) override;
  const std::optional<EntityHashes>& received_hashes(std::size_t) const override {
    return hashes_.complete();
  }
  bool sets_pace() const override { return false; }
  const std::string& failure() const override { return failure_; }
  void leave(std::string_view reason) override;

 private:
  void receive();
  void handle(const Start& start);
  void handle(const Ticks& ticks);
  void send(double now_s);

  std::unique_ptr<platform::DatagramSocket> socket_;
  platform::Address host_;
  std::string program_version_;
  std::uint64_t id_;
  Waiting waiting_{};
  std::optional<Start> start_;
  std::deque<StampedInput> own_inputs_;  // which the host has not acknowledged, from first_input_ on
  std::uint32_t first_input_ = 0;
  std::deque<std::vector<StampedInput>> ticks_;  // to be taken
  std::uint32_t next_tick_ = 0;                  // the first tick that has not arrived
  HashCollector hashes_;
  std::string failure_;
  bool has_news_ = false;  // since the last packet was sent
  std::optional<double> heard_at_s_;
  double sent_at_s_ = -1, now_s_ = 0;
};

}  // namespace temblor::lockstep
