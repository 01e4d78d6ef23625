// A visitor: from stop to stop, and what there is to see and do at each.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "math/angles.h"
#include "scripted_player/decisions/brain.h"

namespace temblor::player {
namespace {

constexpr float kStop_units = 96;
constexpr float kLooksAside_deg = 22;
constexpr double kLooksAround_s = 5;
constexpr double kTakesWeapon_s = 0.15;
constexpr float kAim_deg = 25;
constexpr int kMaxPushes = 5;  // at a button

}  // namespace

std::optional<Task> Brain::task_for_stop(std::uint32_t at) {
  while (stop_ < map_->facts.stops.size()) {
    const Stop& stop = map_->facts.stops[stop_];
    std::optional<Task> planned;
    if (!stop.presses.empty() && !has_pressed_) {
      planned = task_for_button(at, stop);
    } else {
      Task task{.kind = TaskKind::kVisit, .box = {stop.at, stop.at}};
      task.look = math::Vec3(math::basis_from_angles(stop.look_deg).forward);
      task.stop = stop.number;
      task.stay_s = stop.stay_s;
      task.impulse = stop.impulse;
      task.describe = fmt::format("stop {}", stop.number);
      if (const int goal = map_->graph.nearest(stop.at, kStop_units); goal >= 0)
        task.goals = {static_cast<std::uint32_t>(goal)};
      planned = planner_.plan(at, std::move(task));
    }
    if (planned) return planned;
    complain(fmt::format("stop {} cannot be reached", stop.number));
    note_visited();
  }
  return std::nullopt;
}

std::optional<Task> Brain::task_for_button(std::uint32_t at, const Stop& stop) {
  for (const Activator& button : map_->facts.activators) {
    if (button.kind != ActivatorKind::kPress || button.target != stop.presses ||
        planner_.uses(button.entity) >= kMaxPushes)
      continue;
    Task task = planner_.task_for(TaskKind::kPress, button.entity);
    task.stop = stop.number;
    return planner_.plan(at, std::move(task));
  }
  return std::nullopt;
}

void Brain::note_visited() {
  planned_.reset();
  has_pressed_ = false;
  ++stop_;
}

// Looks from side to side; with a weapon, he holds it on what is before him.
void Brain::visit(const Self& self, double now_s, Steering& out) {
  const double here_s = now_s - phase_since_s_;
  const double aside =
      std::sin(here_s * 2 * std::numbers::pi / kLooksAround_s) * kLooksAside_deg * std::numbers::pi / 180;
  const auto turn = static_cast<float>(aside);
  const math::Vec3& ahead = task_->look;
  out.look_at =
      self.eye() + 200.0f * math::Vec3(ahead.x * std::cos(turn) - ahead.y * std::sin(turn),
                                       ahead.x * std::sin(turn) + ahead.y * std::cos(turn), ahead.z);
  if (task_->impulse == 0) return;
  if (here_s < kTakesWeapon_s)
    pending_impulse_ = task_->impulse;
  else
    fire_tolerance_deg_ = kAim_deg;
}

}  // namespace temblor::player
