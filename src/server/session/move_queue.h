// The moves of one client on their way into the game, with or without numbers.
// Stock clients send moves without numbers. The last one holds for every tick until the next one arrives:
// each tick plays one move.
// Our clients number their moves, and repeat the last few in each packet. Each number is played once and in
// order, however the network delivers them, one per tick. In a tick for which none has arrived, the player
// stands still. It catches up when the moves arrive, so that what the client predicts from the same moves
// comes true:
//    packets:     1   2   3 lost   2 3 4   5
//    tick plays:  1   2     -       3 4    5
// Credit limits how many moves a client may play in the long run, so that sending more does not make it
// faster.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "server/game.h"

namespace temblor::server {

class MoveQueue {
 public:
  // Numbered moves that may wait. If there are more, the oldest is dropped; its buttons and impulse pass to
  // the next.
  static constexpr std::size_t kMaxWaiting = 32;
  // Ticks in which a player stands still for lack of moves, before its last move is repeated.
  static constexpr int kMaxHeldTicks = 18;

  // Adds the moves of one packet, oldest first. `last_number` is the number of the last one; empty: they have
  // no numbers, and the last one holds from now on. Numbers that were added before are ignored, and lost ones
  // are replaced by the move before them, up to a few. A move without a number ends the numbering, and the
  // next numbered one starts it again.
  void add(std::optional<std::uint32_t> last_number, std::span<const PlayerInput> moves);
  // The moves to play in this tick, oldest first: none, one, or more to catch up. In the long run it is one
  // per tick, plus 1 % for clocks that differ. Valid until the next call.
  std::span<const PlayerInput> take_due();
  // Drops the moves that are due: the game is paused.
  void skip();

  // Whether the client's current moves have numbers.
  bool is_numbered() const { return is_numbered_; }
  // The number of the last move that was played.
  std::uint32_t last_played() const { return played_; }

 private:
  struct Waiting {
    std::uint32_t number;
    PlayerInput input;
  };
  void hold(PlayerInput input);
  void restart();
  void push(std::uint32_t number, const PlayerInput& input);
  void play_next();
  std::size_t count_surplus();

  PlayerInput held_{};  // the last move without a number
  bool is_numbered_ = false;
  std::deque<Waiting> waiting_;
  std::vector<PlayerInput> due_;   // what take_due() returned last
  PlayerInput last_{};             // the newest move with a number
  std::uint32_t next_number_ = 0;  // which add() expects
  // The number of the last move that was played, or skipped.
  std::uint32_t played_ = 0;
  int held_ticks_ = 0;  // ticks in a row without a move
  double credit_ = 4;   // moves that may be played; the first packet brings a few at once
  // The smallest number of moves that a tick left waiting in the last half second: this many are not needed
  // as a reserve against jitter.
  std::size_t fewest_left_ = kMaxWaiting;
  int ticks_counted_ = 0;
};

}  // namespace temblor::server
