#include "lockstep/lockstep_game.h"

#include <fmt/format.h>

#include <algorithm>

#include "lockstep/peers/guest_peer.h"
#include "lockstep/peers/host_peer.h"

namespace temblor::lockstep {
namespace {

// After a longer wait the game continues where it was, instead of running faster.
constexpr double kMaxWait_s = 0.25;
// How long to wait for the other game's hashes, and how often to send them.
constexpr double kCompare_s = 2, kSendHashesEvery_s = 0.1;

}  // namespace

std::unique_ptr<LockstepGame> LockstepGame::host(SimulationSetup setup, GameStart start,
                                                 std::unique_ptr<platform::DatagramSocket> socket) {
  std::string version = start.program_version;
  return std::make_unique<LockstepGame>(std::move(setup), std::move(version),
                                        std::make_unique<HostPeer>(std::move(socket), std::move(start)));
}

std::unique_ptr<LockstepGame> LockstepGame::join(SimulationSetup setup, std::string program_version,
                                                 std::unique_ptr<platform::DatagramSocket> socket,
                                                 const platform::Address& host, std::uint64_t guest_id) {
  auto peer = std::make_unique<GuestPeer>(std::move(socket), host, program_version, guest_id);
  return std::make_unique<LockstepGame>(std::move(setup), std::move(program_version), std::move(peer));
}

LockstepGame::LockstepGame(SimulationSetup setup, std::string program_version, std::unique_ptr<Peer> peer)
    : setup_(std::move(setup)),
      program_version_(std::move(program_version)),
      peer_(std::move(peer)),
      link_(network_.open()) {}

LockstepGame::~LockstepGame() {
  peer_->leave("The host has left the game.");
}

void LockstepGame::step(double now_s) {
  const double passed_s = now_s_ < 0 ? 0 : std::clamp(now_s - now_s_, 0.0, kMaxWait_s);
  now_s_ = now_s;
  peer_->update(now_s);
  link_.update(now_s, simulation_ ? simulation_->protocol() : net::Protocol::kRmq);
  if (!ended_.empty()) return;
  if (!peer_->failure().empty()) return end(peer_->failure());
  if (difference_) return compare_games();
  if (!simulation_) {
    show_waiting();
    if (peer_->start() == nullptr) return;
    if (const base::Status begun = begin(); !begun.ok()) return end(begun.error().message());
  }
  unplayed_s_ = std::min(unplayed_s_ + passed_s, kMaxWait_s);
  play_due_ticks();
  peer_->update(now_s);
  link_.update(now_s, simulation_->protocol());
}

void LockstepGame::show_waiting() {
  const Waiting waiting = peer_->waiting();
  if (waiting.joined == shown_joined_ || waiting.players < 2) return;
  shown_joined_ = waiting.joined;
  link_.print(fmt::format("Lockstep: {} of {} players are here.\n", waiting.joined, waiting.players));
}

base::Status LockstepGame::begin() {
  const GameStart& start = *peer_->start();
  TRY_STATUS(check_files(setup_.library, setup_.program_file, program_version_, start));
  TRY(simulation_, Simulation::begin(setup_, start));
  replay_.emplace(start);
  next_input_ = start.delay_ticks;
  hash_game(simulation_->game(), hashes_[0]);
  return base::Ok{};
}

// An input is made when all ticks are played that it can depend on.
void LockstepGame::add_due_inputs() {
  for (const std::uint32_t delay = peer_->start()->delay_ticks; next_input_ <= ticks_ + delay; ++next_input_)
    peer_->add_input({link_.take_input(), hashes_[ticks_ % kKeptHashes].short_hash()});
}

void LockstepGame::play_due_ticks() {
  while (ended_.empty() && !difference_) {
    add_due_inputs();
    if (peer_->sets_pace() && unplayed_s_ < simulation_->tick_s()) return;
    const std::optional<std::vector<StampedInput>> inputs = peer_->take_tick();
    if (!inputs) return;
    if (peer_->sets_pace()) unplayed_s_ -= simulation_->tick_s();
    if (!has_same_games(*inputs)) return;
    play(*inputs);
    link_.update(now_s_, simulation_->protocol());
  }
}

// An input's hash is of the game `delay_ticks` before it takes effect. Players who have left send none.
bool LockstepGame::has_same_games(const std::vector<StampedInput>& inputs) {
  const std::uint32_t delay = peer_->start()->delay_ticks;
  if (ticks_ < delay) return true;
  const std::uint32_t made_at = ticks_ - delay;
  for (std::size_t player = 0; player < inputs.size(); ++player) {
    has_left_[player] |= inputs[player].input.leaves;
    if (has_left_[player] || inputs[player].hash == hashes_[made_at % kKeptHashes].short_hash()) continue;
    difference_ = {.tick = made_at, .player = player, .found_at_s = now_s_};
    return false;
  }
  return true;
}

void LockstepGame::play(const std::vector<StampedInput>& inputs) {
  std::vector<ClientInput> plain;
  for (const StampedInput& stamped : inputs) plain.push_back(stamped.input);
  if (const base::Status played = simulation_->play_tick(plain); !played.ok())
    return end(played.error().message());
  ++ticks_;
  GameHashes& hashes = hashes_[ticks_ % kKeptHashes];
  hash_game(simulation_->game(), hashes);
  replay_->add(inputs, hashes.state);
  for (std::size_t player = 0; player < inputs.size(); ++player) {
    const std::vector<MessageForClient> messages = simulation_->take_messages(player);
    if (player == peer_->player()) link_.forward(messages);
  }
}

void LockstepGame::compare_games() {
  if (now_s_ - difference_->sent_at_s > kSendHashesEvery_s) {
    difference_->sent_at_s = now_s_;
    const std::vector<std::uint32_t>& own = hashes_[difference_->tick % kKeptHashes].entities;
    peer_->send_hashes({.tick = difference_->tick, .hashes = own});
  }
  // The other computer needs this one's hashes, too, so wait a little even if all are here.
  const std::optional<EntityHashes>& theirs = peer_->received_hashes(difference_->player);
  const double waited_s = now_s_ - difference_->found_at_s;
  if (waited_s > (theirs ? kCompare_s / 4 : kCompare_s)) end(describe_difference(theirs));
}

std::string LockstepGame::describe_difference(const std::optional<EntityHashes>& theirs) {
  const std::string where =
      fmt::format("The game of player {} differs after tick {} ({:.1f} s)", difference_->player + 1,
                  difference_->tick, difference_->tick * simulation_->tick_s());
  if (!theirs || theirs->tick != difference_->tick)
    return fmt::format("{}. The other computer did not say where.", where);
  const std::optional<std::uint32_t> entity =
      find_first_difference(hashes_[difference_->tick % kKeptHashes].entities, theirs->hashes);
  if (!entity)
    return fmt::format("{}: the same entities, but other globals, time, or random numbers.", where);
  return fmt::format("{}, first in {}.", where, describe_entity(simulation_->game(), *entity));
}

void LockstepGame::end(std::string reason) {
  ended_ = std::move(reason);
  link_.end(ended_);
}

}  // namespace temblor::lockstep
