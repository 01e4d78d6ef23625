// When to send moves to servers that do not number them. Such a server plays the last move that has arrived
// until another one does, so an even stream of 72 moves per second would delay each key by half an interval
// on average. A move with another action therefore leaves at once, in the frame of the key.
#pragma once

#include "net/protocol/client_message.h"

namespace temblor::host {

class MovePacer {
 public:
  // The stock game draws at most 72 frames per second, and its clients send one move per frame.
  static constexpr double kInterval_s = 1.0 / 72;

  // Whether to send `next` in the frame at this time. Call note_sent() if it was sent.
  bool is_due(const net::Move& next, double now_s) const;
  void note_sent(const net::Move& move, double now_s);

 private:
  net::Move last_{};
  double due_s_ = 0;  // of the next move
};

}  // namespace temblor::host
