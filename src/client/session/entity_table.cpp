#include "client/session/entity_table.h"

#include <algorithm>

#include "client/session/client_state.h"

namespace temblor::client {

namespace {

Place place_of(const net::Baseline& entity) {
  return {entity.origin, entity.angles_deg};
}

net::Baseline with_update(net::Baseline entity, const net::EntityUpdate& update) {
  entity.model = update.model.value_or(entity.model);
  entity.frame = update.frame.value_or(entity.frame);
  entity.colormap = update.colormap.value_or(entity.colormap);
  entity.skin = update.skin.value_or(entity.skin);
  for (int axis = 0; axis < 3; ++axis) {
    const auto component = static_cast<std::size_t>(axis);
    entity.origin[axis] = update.origin[component].value_or(entity.origin[axis]);
    entity.angles_deg[axis] = update.angles_deg[component].value_or(entity.angles_deg[axis]);
  }
  entity.alpha = update.alpha.value_or(entity.alpha);
  entity.scale = update.scale.value_or(entity.scale);
  return entity;
}

bool blends_frames(std::uint16_t model, const ClientSettings& settings) {
  const bool no_lerp = model < settings.no_lerp_models.size() && settings.no_lerp_models[model];
  return settings.interpolate && !no_lerp;
}

void set_frames(SeenEntity& io_seen, const FrameBlend& frames) {
  io_seen.from_frame = frames.from;
  io_seen.to_frame = frames.to;
  io_seen.blend = frames.blend;
}

// All but its place and frames.
SeenEntity look_of(std::uint32_t number, const net::Baseline& entity, std::size_t players) {
  SeenEntity seen;
  seen.number = number;
  seen.model = entity.model;
  seen.skin = entity.skin;
  seen.colormap = entity.colormap <= players ? entity.colormap : std::uint8_t{0};
  seen.alpha = entity.alpha;
  seen.scale = entity.scale;
  return seen;
}

}  // namespace

FrameBlend frames_at(const FrameChanges& frames, double time_s, std::uint16_t model,
                     const ClientSettings& settings) {
  if (blends_frames(model, settings)) return frames.at(time_s);
  return {frames.frame(), frames.frame(), 0};
}

void EntityTable::begin_level() {
  entities_.clear();
  arriving_.clear();
  shown_.clear();
  statics_.clear();
}

EntityTable::Entity& EntityTable::entity(std::uint16_t number) {
  if (number >= entities_.size()) entities_.resize(number + std::size_t{1});
  return entities_[number];
}

void EntityTable::set_baseline(std::uint16_t number, const net::Baseline& baseline) {
  entity(number).baseline = baseline;
}

void EntityTable::add_static(const net::Baseline& entity) {
  const auto number = SeenEntity::kFirstStatic + static_cast<std::uint32_t>(statics_.size());
  SeenEntity seen = look_of(number, entity, 0);
  seen.origin_world = seen.previous_origin_world = entity.origin;
  seen.angles_deg = entity.angles_deg;
  set_frames(seen, {entity.frame, entity.frame, 0});
  statics_.push_back(seen);
}

void EntityTable::update(const net::EntityUpdate& update, const PacketWindow& window) {
  Entity& entity = this->entity(update.number);
  const net::Baseline now = with_update(entity.baseline, update);
  const bool was_there = entity.packet == packet_ || entity.packet + 1 == packet_;
  entity.effects = update.effects.value_or(std::uint8_t{0});
  entity.jumped = !was_there || is_teleport(entity.motion.target().origin_world, now.origin);
  entity.jumped_since_asked |= entity.jumped;
  entity.flash_since_asked &= was_there;

  if (entity.jumped)
    entity.motion.put(place_of(now));
  else if (update.step)
    entity.motion.step_to(place_of(now), window, update.next_think_s);
  else
    entity.motion.fly_to(place_of(now), window);

  if (!was_there || now.model != entity.now.model)
    entity.frames.show(now.frame);
  else
    entity.frames.update(now.frame, window.begin_s, update.next_think_s.value_or(kThinkInterval_s));
  if (entity.effects & kEffectMuzzleFlash) {
    entity.frames.flash();
    entity.flash_since_asked = true;
  }

  entity.now = now;
  if (entity.packet != packet_) arriving_.push_back(update.number);
  entity.packet = packet_;
}

void EntityTable::end_packet() {
  // Servers send them in order, but need not.
  shown_.assign(arriving_.begin(), arriving_.end());
  std::sort(shown_.begin(), shown_.end());
}

bool EntityTable::has_jumped(std::uint16_t number) const {
  return number < entities_.size() && entities_[number].jumped;
}

std::size_t EntityTable::memory_bytes() const {
  return entities_.size() * sizeof(Entity) + (arriving_.size() + shown_.size()) * sizeof(std::uint16_t) +
         (statics_.size() + seen_.size()) * sizeof(SeenEntity);
}

void EntityTable::latest(std::vector<EntityPlace>& out_places) const {
  out_places.clear();
  for (const std::uint16_t number : shown_)
    out_places.push_back(
        {number, entities_[number].now.model, entities_[number].motion.target().origin_world});
}

SeenEntity EntityTable::seen(std::uint16_t number, double time_s, const Viewer& viewer,
                             const ClientSettings& settings) {
  Entity& entity = entities_[number];
  SeenEntity seen = look_of(number, entity.now, viewer.players);
  const Place place = settings.interpolate ? entity.motion.at(time_s) : entity.motion.target();
  seen.origin_world = place.origin_world;
  seen.angles_deg = place.angles_deg;
  const bool came_from_elsewhere = entity.asked + 1 == asked_ && !entity.jumped_since_asked;
  seen.has_come = !came_from_elsewhere;
  seen.previous_origin_world = came_from_elsewhere ? entity.origin_when_asked_world : place.origin_world;
  set_frames(seen, frames_at(entity.frames, time_s, seen.model, settings));
  seen.effects = entity.effects;
  seen.muzzle_flash_now = entity.flash_since_asked;

  entity.jumped_since_asked = entity.flash_since_asked = false;
  entity.asked = asked_;
  entity.origin_when_asked_world = place.origin_world;
  return seen;
}

std::span<const SeenEntity> EntityTable::at(double time_s, const Viewer& viewer,
                                            const ClientSettings& settings) {
  ++asked_;
  seen_.clear();
  for (const std::uint16_t number : shown_) {
    const bool has_model = entities_[number].now.model != 0;
    // Entity 0 is the level itself.
    if (number != 0 && (has_model || number == viewer.entity))
      seen_.push_back(seen(number, time_s, viewer, settings));
  }
  seen_.insert(seen_.end(), statics_.begin(), statics_.end());
  return seen_;
}

}  // namespace temblor::client
