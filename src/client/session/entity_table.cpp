#include "client/session/entity_table.h"

#include <algorithm>

#include "client/session/client_state.h"

namespace temblor::client {

namespace {

Place to_place(const net::Baseline& entity) {
  return {entity.origin, entity.angles_deg};
}

// Applies the fields that an update contains to a copy of the baseline.
net::Baseline apply_update(net::Baseline entity, const net::EntityUpdate& update) {
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

// Whether frames of a model may be blended under these settings.
bool blends_frames(std::uint16_t model, const ClientSettings& settings) {
  const bool no_lerp = model < settings.no_lerp_models.size() && settings.no_lerp_models[model];
  return settings.interpolate && !no_lerp;
}

void set_frames(InterpolatedEntity& io_entity, const FrameBlend& frames) {
  io_entity.from_frame = frames.from;
  io_entity.to_frame = frames.to;
  io_entity.blend = frames.blend;
}

// Returns everything about an entity except its place and frames. A colormap number above the number of
// players is invalid and means none.
InterpolatedEntity make_appearance(std::uint32_t number, const net::Baseline& entity, std::size_t players) {
  InterpolatedEntity shown;
  shown.number = number;
  shown.model = entity.model;
  shown.skin = entity.skin;
  shown.colormap = entity.colormap <= players ? entity.colormap : std::uint8_t{0};
  shown.alpha = entity.alpha;
  shown.scale = entity.scale;
  return shown;
}

}  // namespace

FrameBlend blend_frames(const FrameChanges& frames, double time_s, std::uint16_t model,
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

// Grows the table to the highest number that has been used.
EntityTable::Entity& EntityTable::entity(std::uint16_t number) {
  if (number >= entities_.size()) entities_.resize(number + std::size_t{1});
  return entities_[number];
}

void EntityTable::set_baseline(std::uint16_t number, const net::Baseline& baseline) {
  entity(number).baseline = baseline;
}

// A static entity has no updates, so it is interpolated once and for all.
void EntityTable::add_static(const net::Baseline& entity) {
  const auto number = InterpolatedEntity::kFirstStatic + static_cast<std::uint32_t>(statics_.size());
  InterpolatedEntity shown = make_appearance(number, entity, 0);
  shown.origin_world = shown.previous_origin_world = entity.origin;
  shown.angles_deg = entity.angles_deg;
  set_frames(shown, {entity.frame, entity.frame, 0});
  statics_.push_back(shown);
}

// An update applies to the baseline, never to the previous update: fields that it lacks have the baseline's
// value. An entity that was absent, or moved too far, starts without motion.
void EntityTable::update(const net::EntityUpdate& update, const PacketWindow& window) {
  Entity& entity = this->entity(update.number);
  const net::Baseline now = apply_update(entity.baseline, update);
  // The last packet, or an earlier message of this one, had the entity.
  const bool was_there = entity.packet == packet_ || entity.packet + 1 == packet_;
  entity.effects = update.effects.value_or(std::uint8_t{0});
  entity.jumped = !was_there || is_teleport(entity.motion.target().origin_world, now.origin);
  entity.jumped_since_query |= entity.jumped;
  entity.flash_since_query &= was_there;

  // Monsters step ten times a second; everything else moves at the packet rate.
  if (entity.jumped)
    entity.motion.put(to_place(now));
  else if (update.step)
    entity.motion.step_to(to_place(now), window, update.next_think_s);
  else
    entity.motion.fly_to(to_place(now), window);

  if (!was_there || now.model != entity.now.model)
    entity.frames.show(now.frame);
  else
    entity.frames.update(now.frame, window.begin_s, update.next_think_s.value_or(kThinkInterval_s));
  if (entity.effects & kEffectMuzzleFlash) {
    entity.frames.flash();
    entity.flash_since_query = true;
  }

  entity.now = now;
  if (entity.packet != packet_) arriving_.push_back(update.number);
  entity.packet = packet_;
}

// Servers usually send entities in order, but need not. An entity that is not in the packet is no longer
// visible.
void EntityTable::end_packet() {
  // Servers usually send them in order, but need not.
  shown_.assign(arriving_.begin(), arriving_.end());
  std::sort(shown_.begin(), shown_.end());
}

bool EntityTable::has_jumped(std::uint16_t number) const {
  return number < entities_.size() && entities_[number].jumped;
}

std::size_t EntityTable::memory_bytes() const {
  return entities_.size() * sizeof(Entity) + (arriving_.size() + shown_.size()) * sizeof(std::uint16_t) +
         (statics_.size() + interpolated_.size()) * sizeof(InterpolatedEntity);
}

void EntityTable::copy_latest(std::vector<EntityPlace>& out_places) const {
  out_places.clear();
  for (const std::uint16_t number : shown_)
    out_places.push_back(
        {number, entities_[number].now.model, entities_[number].motion.target().origin_world});
}

// Also records where the entity was shown, so that the next call can tell the path in between, for trails.
InterpolatedEntity EntityTable::interpolate_entity(std::uint16_t number, double time_s, const Viewer& viewer,
                                                   const ClientSettings& settings) {
  Entity& entity = entities_[number];
  InterpolatedEntity shown = make_appearance(number, entity.now, viewer.players);
  const Place place = settings.interpolate ? entity.motion.at(time_s) : entity.motion.target();
  shown.origin_world = place.origin_world;
  shown.angles_deg = place.angles_deg;
  const bool came_from_elsewhere = entity.query + 1 == query_ && !entity.jumped_since_query;
  shown.is_new = !came_from_elsewhere;
  shown.previous_origin_world = came_from_elsewhere ? entity.origin_at_query_world : place.origin_world;
  set_frames(shown, blend_frames(entity.frames, time_s, shown.model, settings));
  shown.effects = entity.effects;
  shown.has_muzzle_flash = entity.flash_since_query;

  entity.jumped_since_query = entity.flash_since_query = false;
  entity.query = query_;
  entity.origin_at_query_world = place.origin_world;
  return shown;
}

std::span<const InterpolatedEntity> EntityTable::interpolate(double time_s, const Viewer& viewer,
                                                             const ClientSettings& settings) {
  ++query_;
  interpolated_.clear();
  for (const std::uint16_t number : shown_) {
    const bool has_model = entities_[number].now.model != 0;
    // Entity 0 is the level itself.
    if (number != 0 && (has_model || number == viewer.entity))
      interpolated_.push_back(interpolate_entity(number, time_s, viewer, settings));
  }
  interpolated_.insert(interpolated_.end(), statics_.begin(), statics_.end());
  return interpolated_;
}

}  // namespace temblor::client
