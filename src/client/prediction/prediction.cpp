#include "client/prediction/prediction.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "client/prediction/near_solids.h"
#include "client/session/interpolation.h"

namespace temblor::client {
namespace {

// An error shrinks to 1/e (37 %) in this time.
constexpr double kFade_s = 0.04;
// Units. Smaller differences do not count as corrections.
constexpr float kMinCorrection = 0.01f;
// Units: twice the distance that bodies keep from the floor.
constexpr float kAboveFloor = 1.0f / 16;

// Returns submodel 12 for a model named "*12"; nothing for other models, and for the level itself.
std::optional<world::ModelIndex> find_brush_model(const Game& game, std::uint16_t number,
                                                  const world::Level& level) {
  if (number >= game.models.size() || !game.models[number].starts_with('*')) return std::nullopt;
  const std::string& name = game.models[number];
  std::uint32_t index = 0;
  std::from_chars(name.data() + 1, name.data() + name.size(), index);
  if (index == 0 || index >= level.models.size()) return std::nullopt;
  return world::ModelIndex{index};
}

// The game code that runs may know the class and make it solid; then the next acknowledgment corrects the
// prediction.
bool is_passable(const world::Level& level, world::ModelIndex model) {
  const std::size_t number = base::to_size(model);
  return number < level.brush_entities.size() && level.brush_entities[number].is_passable;
}

}  // namespace

// Copies what it needs, as the connection may read more packets before advance(). The pending part of a tick
// is converted from real time to game time, which may pass at another speed.
void Prediction::begin_frame(const Connection& connection, const net::Move& pending, double now_s) {
  parameters_ = connection.move_parameters();
  acknowledged_ = connection.acknowledged();
  acknowledgment_count_ = connection.acknowledgments();
  const std::span<const NumberedMove> sent = connection.sent_moves();
  moves_.assign(sent.begin(), sent.end());
  pending_ = pending;
  pending_s_ =
      parameters_ ? connection.since_last_move_s(now_s) / parameters_->tick_s * parameters_->world_tick_s : 0;
  now_s_ = now_s;
}

// The brush models near the player, and the water of Half-Life's levels, at their latest places.
void Prediction::update_solids(const ClientState& state, const world::Level& level) {
  state.copy_latest_places(places_);
  solids_.clear();
  liquids_.clear();
  for (const EntityPlace& place : places_) {
    const auto model = find_brush_model(state.game(), place.model, level);
    if (!model) continue;
    if (!is_passable(level, *model))
      solids_.push_back({place.number, *model, place.origin_world});
    else
      liquids_.push_back({*model, place.origin_world});  // only those of func_water are looked up
  }
  keep_nearest(solids_, level, acknowledged_->origin, kMaxSolids);
}

// Plays the moves with numbers above `after`, within the frame's effort.
void Prediction::play_sent_moves(std::uint32_t after, const PredictionWorld& world,
                                 PredictedPlayer& io_player) {
  for (const NumberedMove& sent : moves_)
    if (sent.number > after && is_predictable(io_player) && effort_ < kMaxEffort)
      effort_ += step(io_player, sent.move, parameters_->world_tick_s, world);
}

// Returns the offset from where the prediction has a mover to where it is drawn. Movers are drawn up to a
// packet late (interpolation), so a player on one is shown with the same lag.
math::Vec3 Prediction::compute_ride_lag(std::uint32_t ground, const PredictedPlayer& predicted,
                                        std::span<const InterpolatedEntity> drawn) const {
  const InterpolatedEntity* seen = ground != 0 ? find_entity(drawn, ground) : nullptr;
  if (seen == nullptr) return math::Vec3(0.0f);
  if (predicted.ride && predicted.ride_entity == ground) return seen->origin_world - predicted.ride->origin;
  for (const SolidModel& solid : solids_)
    if (solid.entity == ground) return seen->origin_world - solid.origin;
  return math::Vec3(0.0f);
}

// Adds the move that is still being collected to `latest`, for this frame only.
Prediction::ShownPlayer Prediction::predict_shown(const PredictedPlayer& latest, const PredictionWorld& world,
                                                  std::span<const InterpolatedEntity> drawn) {
  ShownPlayer shown{latest};
  movement::Body& body = shown.predicted.player.body;
  if (pending_s_ > 0 && is_predictable(latest) && effort_ < kMaxEffort)
    effort_ += step(shown.predicted, pending_, pending_s_, world);
  // At the start of a tick gravity has pulled only a little, so the fall may not reach the floor yet that the
  // whole tick's fall reaches. Keeps the player on the floor unless it has jumped.
  const bool has_left = body.velocity.z > 0 && !body.on_ground;
  const float fallen = latest.player.body.origin.z - body.origin.z;
  if (latest.player.body.on_ground && !body.on_ground && fallen > 0 && fallen < kAboveFloor)
    body.origin.z = latest.player.body.origin.z;
  shown.on_ground = body.on_ground || (latest.player.body.on_ground && !has_left);
  shown.ground = shown.on_ground ? body.ground : 0;
  shown.origin = body.origin + compute_ride_lag(shown.ground, shown.predicted, drawn);
  return shown;
}

// Turns the difference between two predictions of the same moment into an error that fades.
void Prediction::correct(const math::Vec3& before, const math::Vec3& now) {
  const math::Vec3 difference = before - now;
  const float distance = glm::length(difference);
  // A difference that is not a number counts as a teleport, not as a small error.
  if (!std::isfinite(distance) || is_teleport(before, now)) {
    report_.teleport_units = std::max(report_.teleport_units, distance);
    error_ = math::Vec3(0.0f);
    return;
  }
  if (distance > kMinCorrection) ++report_.corrections;
  report_.largest_units = std::max(report_.largest_units, distance);
  error_ += difference;
}

// The prediction needs every move since the acknowledged one. It is impossible right after the server starts
// to take numbered moves, and if more moves are pending than SentMoves keeps.
std::optional<PredictedMotion> Prediction::advance(const ClientState& state, const world::Level& level,
                                                   std::span<const InterpolatedEntity> drawn) {
  const Game& game = state.game();
  const bool is_known =
      parameters_ && acknowledged_ && game.view_entity == parameters_->entity && game.ending == Ending::kNone;
  const bool is_complete = is_known && (moves_.empty() || moves_.front().number <= acknowledged_->number + 1);
  if (!is_complete) {
    latest_.reset();
    error_ = math::Vec3(0.0f);
    return std::nullopt;
  }
  // The server does not run moves during a pause, so none are played.
  if (game.paused) {
    moves_.clear();
    pending_s_ = 0;
  }
  effort_ = 0;
  const ShownPlayer now = latest_ ? continue_prediction(state, level, drawn) : restart(state, level, drawn);
  if (effort_ >= kMaxEffort) {
    ++report_.abandoned_frames;
    latest_.reset();
    error_ = math::Vec3(0.0f);
    return std::nullopt;
  }
  last_played_ =
      moves_.empty() ? acknowledged_->number : std::max(moves_.back().number, acknowledged_->number);
  ground_ = now.ground;
  shown_at_s_ = now_s_;
  PredictedMotion motion{now.origin + error_, now.predicted.player.body.velocity, now.on_ground};
  if (level.is_half_life) motion.crouching_eyes_z = now.predicted.eyes_z;
  return motion;
}

PredictionWorld Prediction::make_world(const world::Level& level) const {
  return {level, solids_, parameters_->physics, liquids_};
}

// Starts over from the acknowledged state.
Prediction::ShownPlayer Prediction::restart(const ClientState& state, const world::Level& level,
                                            std::span<const InterpolatedEntity> drawn) {
  update_solids(state, level);
  const PredictionWorld world = make_world(level);
  latest_ = make_predicted_player(*acknowledged_);
  latest_->eyes_z = state.game().data.view_height;
  latest_base_ = acknowledgment_count_;
  play_sent_moves(acknowledged_->number, world, *latest_);
  return predict_shown(*latest_, world, drawn);
}

// Continues from the previous acknowledgment with the movers of then; if a newer one has arrived, compares
// with a restart from that.
Prediction::ShownPlayer Prediction::continue_prediction(const ClientState& state, const world::Level& level,
                                                        std::span<const InterpolatedEntity> drawn) {
  const PredictionWorld world = make_world(level);
  play_sent_moves(last_played_, world, *latest_);
  ShownPlayer now = predict_shown(*latest_, world, drawn);
  // A player who steps onto or off a lift that is drawn elsewhere than predicted glides instead of jumping.
  if (now.ground != ground_)
    error_ +=
        compute_ride_lag(ground_, now.predicted, drawn) - compute_ride_lag(now.ground, now.predicted, drawn);
  if (latest_base_ != acknowledgment_count_) {
    const ShownPlayer corrected = restart(state, level, drawn);
    correct(now.origin, corrected.origin);
    now = corrected;
  }
  const math::Vec3 old_error = error_;
  error_ *= static_cast<float>(std::exp(-std::max(now_s_ - shown_at_s_, 0.0) / kFade_s));
  report_.largest_jump_units = std::max(report_.largest_jump_units, glm::distance(old_error, error_));
  return now;
}

}  // namespace temblor::client
