#include "server/session/move_queue.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace temblor::server {
namespace {

constexpr std::uint32_t kMaxReplaced = 8;
constexpr double kCreditEachTick = 1.01, kMaxCredit = 20;
// More than this wait only after the network stood still.
constexpr std::size_t kManyWaiting = 12;
constexpr std::size_t kMaxEachTick = 2;
constexpr double kFirstCredit = 4;
constexpr int kTicksToCount = 36;

}  // namespace

void MoveQueue::restart() {
  const double credit = std::min(credit_, kFirstCredit);
  *this = MoveQueue{};
  credit_ = credit;
}

void MoveQueue::add(std::uint32_t last_number, std::span<const PlayerInput> moves) {
  const auto count = static_cast<std::uint32_t>(moves.size());
  // Behind the last of all numbers there is none.
  if (count == 0 || last_number < count || last_number == std::numeric_limits<std::uint32_t>::max()) return;
  const std::uint32_t first_number = last_number - (count - 1);
  if (!has_begun_) {
    has_begun_ = true;
    next_number_ = first_number;
    played_ = first_number - 1;
  } else if (first_number > next_number_) {
    const std::uint32_t lost = std::min(first_number - next_number_, kMaxReplaced);
    PlayerInput replacement = last_;
    replacement.impulse = 0;
    for (std::uint32_t number = first_number - lost; number < first_number; ++number)
      push(number, replacement);
  }
  for (std::uint32_t i = 0; i < count; ++i)
    if (first_number + i >= next_number_) push(first_number + i, moves[i]);
}

void MoveQueue::push(std::uint32_t number, const PlayerInput& input) {
  waiting_.push_back({number, input});
  last_ = input;
  next_number_ = number + 1;
  if (waiting_.size() <= kMaxWaiting) return;
  const PlayerInput oldest = waiting_.front().input;
  waiting_.pop_front();
  PlayerInput& heir = waiting_.front().input;
  heir.buttons |= oldest.buttons;
  if (heir.impulse == 0) heir.impulse = oldest.impulse;
}

void MoveQueue::play_next() {
  turn_.push_back(waiting_.front().input);
  played_ = waiting_.front().number;
  waiting_.pop_front();
  credit_ -= 1;
}

// Moves that have been waiting for nothing, found out from time to time.
std::size_t MoveQueue::left_over() {
  fewest_left_ = std::min(fewest_left_, waiting_.size());
  if (++ticks_counted_ < kTicksToCount) return 0;
  ticks_counted_ = 0;
  return std::exchange(fewest_left_, kMaxWaiting);
}

std::span<const PlayerInput> MoveQueue::take() {
  turn_.clear();
  credit_ = std::min(credit_ + kCreditEachTick, kMaxCredit);
  if (waiting_.empty()) {
    left_over();
    if (++held_ticks_ <= kMaxHeldTicks) return {};
    credit_ -= 1;
    last_.impulse = 0;
    turn_.push_back(last_);
    return turn_;
  }
  play_next();
  const auto can_play_more = [&] { return !waiting_.empty() && credit_ >= 1 && turn_.size() < kMaxEachTick; };
  while (waiting_.size() > kManyWaiting && can_play_more()) play_next();
  for (std::size_t more = left_over(); more > 0 && can_play_more(); --more) play_next();
  // Paid back move by move: who sends now and then does not slow his own time.
  held_ticks_ = std::max(0, held_ticks_ - static_cast<int>(turn_.size()));
  return turn_;
}

void MoveQueue::skip() {
  if (!waiting_.empty()) played_ = waiting_.back().number;
  waiting_.clear();
}

}  // namespace temblor::server
