// Tours: the player visits the tour stops of a level in order, and at each one looks around, presses a button
// first, or fires a weapon. README.md lists the keys of stops.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "math/angles.h"
#include "scripted_player/decisions/brain.h"

namespace temblor::player {
namespace {

constexpr float kStop_units = 96;
// Looks this far to both sides, once in kLooksAround_s.
constexpr float kLooksAside_deg = 22;
constexpr double kLooksAround_s = 5;
// Time to change the weapon before it fires.
constexpr double kTakesWeapon_s = 0.15;
constexpr float kTourAim_deg = 25;
constexpr int kMaxPresses = 5;

}  // namespace

// Returns the task of the current stop: its button, then the visit. Skips stops that cannot be reached.
std::optional<Task> Brain::plan_stop(std::uint32_t at) {
  while (stop_ < map_->facts.stops.size()) {
    const Stop& stop = map_->facts.stops[stop_];
    std::optional<Task> planned;
    if (!stop.presses.empty() && !has_pressed_) {
      planned = plan_button(at, stop);
    } else {
      Task task{.kind = TaskKind::kVisit, .box = {stop.at, stop.at}};
      task.look = math::Vec3(math::basis_from_angles(stop.look_deg).forward);
      task.stop = stop.number;
      task.stay_s = stop.stay_s;
      task.impulse = stop.impulse;
      task.description = fmt::format("stop {}", stop.number);
      if (const int goal = map_->graph.find_nearest(stop.at, kStop_units); goal >= 0)
        task.goals = {static_cast<std::uint32_t>(goal)};
      planned = planner_.plan(at, std::move(task));
    }
    if (planned) return planned;
    report_problem(fmt::format("stop {} cannot be reached", stop.number));
    finish_stop();
  }
  return std::nullopt;
}

std::optional<Task> Brain::plan_button(std::uint32_t at, const Stop& stop) {
  for (const Activator& button : map_->facts.activators) {
    if (button.kind != ActivatorKind::kPress || button.target != stop.presses ||
        planner_.uses(button.entity) >= kMaxPresses)
      continue;
    Task task = planner_.make_task(TaskKind::kPress, button.entity);
    task.stop = stop.number;
    return planner_.plan(at, std::move(task));
  }
  return std::nullopt;
}

void Brain::finish_stop() {
  planned_.reset();
  has_pressed_ = false;
  ++stop_;
}

// Looks from side to side in a sine wave. With an impulse, it selects the weapon and then fires while the
// view is roughly ahead.
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
    fire_tolerance_deg_ = kTourAim_deg;
}

}  // namespace temblor::player
