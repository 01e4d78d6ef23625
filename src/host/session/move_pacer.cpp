#include "host/session/move_pacer.h"

#include <algorithm>

namespace temblor::host {
namespace {

int find_direction(int speed) {
  return (speed > 0) - (speed < 0);
}

// Turning is not an action: a mouse turns in most frames, and the picture shows it without the server.
bool has_other_action(const net::Move& a, const net::Move& b) {
  return a.buttons != b.buttons || find_direction(a.forward) != find_direction(b.forward) ||
         find_direction(a.side) != find_direction(b.side) || find_direction(a.up) != find_direction(b.up);
}

}  // namespace

bool MovePacer::is_due(const net::Move& next, double now_s) const {
  return now_s >= due_s_ || next.impulse != 0 || has_other_action(next, last_);
}

// The schedule keeps its rhythm, so that frames of about its rate are not skipped because of small
// differences. After a pause, and after a move that left early, it starts over.
void MovePacer::note_sent(const net::Move& move, double now_s) {
  const bool keeps_rhythm = now_s >= due_s_ && now_s - due_s_ < kInterval_s;
  due_s_ = (keeps_rhythm ? due_s_ : now_s) + kInterval_s;
  last_ = move;
}

}  // namespace temblor::host
