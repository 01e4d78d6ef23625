#include "client/prediction/prediction.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "client/prediction/near_solids.h"
#include "client/session/interpolation.h"

namespace temblor::client {
namespace {

constexpr double kFade_s = 0.04;  // in which an error shrinks to a third
constexpr float kSameness = 0.01f;
constexpr float kAboveFloor = 1.0f / 16;  // twice what bodies stop from it

// "*12": the twelfth of the level's models.
std::optional<world::ModelIndex> brush_model(const Game& game, std::uint16_t number,
                                             const world::Level& level) {
  if (number >= game.models.size() || !game.models[number].starts_with('*')) return std::nullopt;
  const std::string& name = game.models[number];
  std::uint32_t index = 0;
  std::from_chars(name.data() + 1, name.data() + name.size(), index);
  if (index == 0 || index >= level.models.size()) return std::nullopt;
  return world::ModelIndex{index};
}

}  // namespace

void Prediction::begin_frame(const Connection& connection, const net::Move& doing, double now_s) {
  terms_ = connection.move_parameters();
  told_ = connection.acknowledged();
  told_count_ = connection.acknowledgements();
  const std::span<const NumberedMove> sent = connection.sent_moves();
  moves_.assign(sent.begin(), sent.end());
  doing_ = doing;
  doing_for_s_ = terms_ ? connection.since_last_move_s(now_s) / terms_->tick_s * terms_->world_tick_s : 0;
  now_s_ = now_s;
}

void Prediction::take_up_solids(const ClientState& state, const world::Level& level) {
  state.latest_places(places_);
  solids_.clear();
  for (const EntityPlace& place : places_)
    if (const auto model = brush_model(state.game(), place.model, level))
      solids_.push_back({place.number, *model, place.origin_world});
  keep_nearest(solids_, level, told_->origin, kMaxSolids);
}

void Prediction::play_sent_moves(std::uint32_t after, const PredictionWorld& world,
                                 PredictedPlayer& io_whole) {
  for (const NumberedMove& sent : moves_)
    if (sent.number > after && is_predictable(io_whole) && effort_ < kMaxEffort)
      effort_ += step(io_whole, sent.move, terms_->world_tick_s, world);
}

// How far a mover is drawn from where the prediction has it.
math::Vec3 Prediction::lag_of(std::uint32_t ground, const PredictedPlayer& predicted,
                              std::span<const SeenEntity> drawn) const {
  const SeenEntity* seen = ground != 0 ? find_entity(drawn, ground) : nullptr;
  if (seen == nullptr) return math::Vec3(0.0f);
  if (predicted.ride && predicted.ride_entity == ground) return seen->origin_world - predicted.ride->origin;
  for (const SolidModel& solid : solids_)
    if (solid.entity == ground) return seen->origin_world - solid.origin;
  return math::Vec3(0.0f);
}

Prediction::Shown Prediction::shown(const PredictedPlayer& whole, const PredictionWorld& world,
                                    std::span<const SeenEntity> drawn) {
  Shown shown{whole};
  movement::Body& body = shown.predicted.player.body;
  if (doing_for_s_ > 0 && is_predictable(whole) && effort_ < kMaxEffort)
    effort_ += step(shown.predicted, doing_, doing_for_s_, world);
  // The beginning of a tick's fall does not reach the floor that the whole of it does.
  const bool has_left = body.velocity.z > 0 && !body.on_ground;
  const float fallen = whole.player.body.origin.z - body.origin.z;
  if (whole.player.body.on_ground && !body.on_ground && fallen > 0 && fallen < kAboveFloor)
    body.origin.z = whole.player.body.origin.z;
  shown.on_ground = body.on_ground || (whole.player.body.on_ground && !has_left);
  shown.ground = shown.on_ground ? body.ground : 0;
  shown.origin = body.origin + lag_of(shown.ground, shown.predicted, drawn);
  return shown;
}

void Prediction::correct(const math::Vec3& before, const math::Vec3& now) {
  const math::Vec3 difference = before - now;
  const float distance = glm::length(difference);
  // What is no number is no small mistake either.
  if (!std::isfinite(distance) || is_teleport(before, now)) {
    report_.unpredicted_units = std::max(report_.unpredicted_units, distance);
    error_ = math::Vec3(0.0f);
    return;
  }
  if (distance > kSameness) ++report_.corrections;
  report_.largest_units = std::max(report_.largest_units, distance);
  error_ += difference;
}

std::optional<OwnMotion> Prediction::advance(const ClientState& state, const world::Level& level,
                                             std::span<const SeenEntity> drawn) {
  const Game& game = state.game();
  const bool is_known = terms_ && told_ && game.view_entity == terms_->entity && game.ending == Ending::kNone;
  const bool is_complete = is_known && (moves_.empty() || moves_.front().number <= told_->number + 1);
  if (!is_complete) {
    whole_.reset();
    error_ = math::Vec3(0.0f);
    return std::nullopt;
  }
  if (game.paused) {
    moves_.clear();
    doing_for_s_ = 0;
  }
  effort_ = 0;
  const Shown now = whole_ ? go_on(state, level, drawn) : begin(state, level, drawn);
  if (effort_ >= kMaxEffort) {
    ++report_.given_up;
    whole_.reset();
    error_ = math::Vec3(0.0f);
    return std::nullopt;
  }
  played_ = moves_.empty() ? told_->number : std::max(moves_.back().number, told_->number);
  ground_ = now.ground;
  shown_at_s_ = now_s_;
  return OwnMotion{now.origin + error_, now.predicted.player.body.velocity, now.on_ground};
}

PredictionWorld Prediction::world_around(const ClientState& state, const world::Level& level) const {
  return {level, solids_, settings_of(*terms_), state.game().data.view_height};
}

// From the server's word.
Prediction::Shown Prediction::begin(const ClientState& state, const world::Level& level,
                                    std::span<const SeenEntity> drawn) {
  take_up_solids(state, level);
  const PredictionWorld world = world_around(state, level);
  whole_ = predicted_from(*told_);
  whole_from_ = told_count_;
  play_sent_moves(told_->number, world, *whole_);
  return shown(*whole_, world, drawn);
}

// As it would go on by the word before, among the movers as they were told then; then by the new one.
Prediction::Shown Prediction::go_on(const ClientState& state, const world::Level& level,
                                    std::span<const SeenEntity> drawn) {
  const PredictionWorld world = world_around(state, level);
  play_sent_moves(played_, world, *whole_);
  Shown now = shown(*whole_, world, drawn);
  // Onto a lift that is drawn somewhere else than it is predicted, or off it: no step, a glide.
  if (now.ground != ground_)
    error_ += lag_of(ground_, now.predicted, drawn) - lag_of(now.ground, now.predicted, drawn);
  if (whole_from_ != told_count_) {
    const Shown right = begin(state, level, drawn);
    correct(now.origin, right.origin);
    now = right;
  }
  const math::Vec3 whole_error = error_;
  error_ *= static_cast<float>(std::exp(-std::max(now_s_ - shown_at_s_, 0.0) / kFade_s));
  report_.largest_jump_units = std::max(report_.largest_jump_units, glm::distance(whole_error, error_));
  return now;
}

}  // namespace temblor::client
