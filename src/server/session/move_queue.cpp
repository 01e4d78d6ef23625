#include "server/session/move_queue.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace temblor::server {
namespace {

constexpr std::uint32_t kMaxReplaced = 8;  // lost moves in a row
// Moves. A client's clock may be 1 % faster than ours; the maximum allows it to catch up after a stall.
constexpr double kCreditEachTick = 1.01, kMaxCredit = 20;
constexpr std::size_t kManyWaiting = 12;  // so many wait only after the network stalled
constexpr std::size_t kMaxEachTick = 2;
constexpr double kFirstCredit = 4;
constexpr int kTicksToCount = 36;  // half a second

}  // namespace

// Numbers start again, but not the credit: a client gains nothing by restarting.
void MoveQueue::restart() {
  const double credit = std::min(credit_, kFirstCredit);
  *this = MoveQueue{};
  credit_ = credit;
}

void MoveQueue::hold(PlayerInput input) {
  // An impulse that was not played yet must not get lost.
  if (input.impulse == 0) input.impulse = held_.impulse;
  if (is_numbered_) restart();
  held_ = input;
}

// Replacing lost moves keeps the time that they stood for: a player with packet loss moves on at full speed.
// The client's prediction will differ, and is corrected by the next acknowledgment.
void MoveQueue::add(std::optional<std::uint32_t> numbered, std::span<const PlayerInput> moves) {
  const auto count = static_cast<std::uint32_t>(moves.size());
  if (count == 0) return;
  if (!numbered) return hold(moves.back());
  const std::uint32_t last_number = *numbered;
  // The largest number has no successor.
  if (last_number < count || last_number == std::numeric_limits<std::uint32_t>::max()) return;
  const std::uint32_t first_number = last_number - (count - 1);
  if (!is_numbered_) {
    is_numbered_ = true;
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

// Buttons of a dropped move pass to its successor, so that a short press of a button is not lost.
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
  due_.push_back(waiting_.front().input);
  played_ = waiting_.front().number;
  waiting_.pop_front();
  credit_ -= 1;
}

// Once every kTicksToCount ticks: how many moves have been waiting all the time, and can be played early.
// Otherwise 0. Without this, a stall would leave the player with a lasting delay.
std::size_t MoveQueue::count_surplus() {
  fewest_left_ = std::min(fewest_left_, waiting_.size());
  if (++ticks_counted_ < kTicksToCount) return 0;
  ticks_counted_ = 0;
  return std::exchange(fewest_left_, kMaxWaiting);
}

// Held moves (without numbers) need no credit: each tick plays exactly one.
std::span<const PlayerInput> MoveQueue::take_due() {
  due_.clear();
  const PlayerInput held = held_;
  held_.impulse = 0;
  if (!is_numbered_) {
    due_.push_back(held);
    return due_;
  }
  credit_ = std::min(credit_ + kCreditEachTick, kMaxCredit);
  if (waiting_.empty()) {
    count_surplus();
    if (++held_ticks_ <= kMaxHeldTicks) return {};
    credit_ -= 1;
    last_.impulse = 0;
    due_.push_back(last_);
    return due_;
  }
  play_next();
  const auto can_play_more = [&] { return !waiting_.empty() && credit_ >= 1 && due_.size() < kMaxEachTick; };
  while (waiting_.size() > kManyWaiting && can_play_more()) play_next();
  for (std::size_t more = count_surplus(); more > 0 && can_play_more(); --more) play_next();
  // Reduced move by move, so that the time of a client that sends rarely does not slow down.
  held_ticks_ = std::max(0, held_ticks_ - static_cast<int>(due_.size()));
  return due_;
}

void MoveQueue::skip() {
  held_.impulse = 0;
  if (!waiting_.empty()) played_ = waiting_.back().number;
  waiting_.clear();
}

}  // namespace temblor::server
