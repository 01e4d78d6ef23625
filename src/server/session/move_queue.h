// The numbered moves of one client that wait to be played: each once and in order, however the network brings
// them. A tick plays one; where none has come, the player stays as he is for that tick and catches up when
// they are here, so that what his client predicts from the same moves comes true.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "server/game.h"

namespace temblor::server {

class MoveQueue {
 public:
  // Moves that may wait; the oldest go, their buttons and impulse to the next.
  static constexpr std::size_t kMaxWaiting = 32;
  // Ticks that a player stays for want of moves, before he goes on as he last did.
  static constexpr int kMaxHeldTicks = 18;

  // The moves of one packet, oldest first, and the number of the last one. Numbers that came before are
  // passed over. Those that have got lost are replaced by the one before them, a few at most.
  void add(std::uint32_t last_number, std::span<const PlayerInput> moves);
  // What to play this tick: none, one, or some more to catch up. Over time no more than a tick's move each
  // tick (and a hundredth, for clocks that differ).
  std::span<const PlayerInput> take();
  // Numbers begin anew, but what may be played does not: nobody gets ahead by it.
  void restart();
  // Time stands still: what waits is passed over.
  void skip();

  bool has_begun() const { return has_begun_; }
  // Of the last move that was played.
  std::uint32_t played() const { return played_; }

 private:
  struct Waiting {
    std::uint32_t number;
    PlayerInput input;
  };
  void push(std::uint32_t number, const PlayerInput& input);
  void play_next();
  std::size_t left_over();

  std::deque<Waiting> waiting_;
  std::vector<PlayerInput> turn_;
  PlayerInput last_{};             // added
  std::uint32_t next_number_ = 0;  // to be added
  std::uint32_t played_ = 0;
  bool has_begun_ = false;
  int held_ticks_ = 0;
  double credit_ = 4;  // moves that may be played; the first packet brings some
  // The fewest that were left waiting by a tick lately: so many are not needed against the network's jitter.
  std::size_t fewest_left_ = kMaxWaiting;
  int ticks_counted_ = 0;
};

}  // namespace temblor::server
