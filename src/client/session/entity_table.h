// The entities of a level as the server's packets describe them: baselines, updates relative to them, which
// entities exist, and the motion of each.
//
// Entity numbers are in [0, net::kMaxEntities). Memory grows to the highest number used and stays. The call
// order for each packet is begin_packet(), update() for each entity in it, end_packet(); then interpolate()
// for each frame until the next packet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/session/interpolated_entity.h"
#include "client/session/interpolation.h"
#include "net/protocol/server_message.h"

namespace temblor::client {

struct ClientSettings;

// Returns a model's frames at a time, blended or snapped as the settings say. `model`: its precache number.
FrameBlend blend_frames(const FrameChanges& frames, double time_s, std::uint16_t model,
                        const ClientSettings& settings);

class EntityTable {
 public:
  // Removes all entities; keeps the capacity.
  void begin_level();
  // Sets the values that updates of this entity are relative to.
  void set_baseline(std::uint16_t number, const net::Baseline& baseline);
  // Adds an entity that never changes, such as a torch.
  void add_static(const net::Baseline& entity);
  std::size_t static_count() const { return statics_.size(); }

  // Starts a new packet: the updates that follow belong to it.
  void begin_packet() { ++packet_, arriving_.clear(); }
  // Applies an update of the current packet.
  void update(const net::EntityUpdate& update, const PacketWindow& window);
  std::size_t memory_bytes() const;
  // Removes entities without an update since begin_packet().
  void end_packet();

  // Whether the last update showed the entity for the first time, or too far away for a glide.
  bool has_jumped(std::uint16_t number) const;

  // The entities where the last packet put them, sorted by number.
  void copy_latest(std::vector<EntityPlace>& out_places) const;

  struct Viewer {
    std::uint16_t entity = 0;  // returned even without a model, as the view is in it
    std::size_t players = 0;   // color maps above this number are ignored
  };
  // See ClientState::interpolate_entities().
  std::span<const InterpolatedEntity> interpolate(double time_s, const Viewer& viewer,
                                                  const ClientSettings& settings);

 private:
  struct Entity {
    net::Baseline baseline;
    net::Baseline now;  // as of the last update; its place is the target of the motion
    std::uint8_t effects = 0;
    bool jumped = false;
    // The packet of the last update, counted by packet_.
    std::uint32_t packet = 0;
    Motion motion;
    FrameChanges frames;
    // The changes since the last interpolate() call.
    bool jumped_since_query = false, flash_since_query = false;
    std::uint32_t query = 0;
    math::Vec3 origin_at_query_world{0.0f};
  };
  Entity& entity(std::uint16_t number);
  InterpolatedEntity interpolate_entity(std::uint16_t number, double time_s, const Viewer& viewer,
                                        const ClientSettings& settings);

  // Indexed by entity number.
  std::vector<Entity> entities_;
  // Entity numbers: of the packet that is being read, in order of arrival, and of the last complete one,
  // sorted.
  std::vector<std::uint16_t> arriving_, shown_;
  // Static entities, and the result of interpolate().
  std::vector<InterpolatedEntity> statics_, interpolated_;
  // Count packets and interpolate() calls. They start above the values in a new Entity.
  std::uint32_t packet_ = 2, query_ = 2;
};

}  // namespace temblor::client
