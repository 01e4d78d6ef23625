// What the server's packets say of entities: baselines, updates as differences from them, who is there, and
// how each has come to where it is. Numbers are in [0, net::kMaxEntities); memory grows to the highest one
// that was named and stays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/session/interpolation.h"
#include "client/session/seen_entity.h"
#include "net/protocol/server_message.h"

namespace temblor::client {

struct ClientSettings;

// The frames as the settings want them blended, or snapped; never blended for models that are not to be.
FrameBlend frames_at(const FrameChanges& frames, double time_s, std::uint16_t model,
                     const ClientSettings& settings);

class EntityTable {
 public:
  // Forgets everything but its memory.
  void begin_level();
  void set_baseline(std::uint16_t number, const net::Baseline& baseline);
  void add_static(const net::Baseline& entity);
  std::size_t static_count() const { return statics_.size(); }

  // From here on updates belong to a new packet.
  void begin_packet() { ++packet_, arriving_.clear(); }
  void update(const net::EntityUpdate& update, const PacketWindow& window);
  std::size_t memory_bytes() const;
  // Who had no update since begin_packet() is gone.
  void end_packet();

  // The last update of that entity showed it for the first time, or too far from the one before.
  bool has_jumped(std::uint16_t number) const;

  // Where the last packet has put them, in order of number.
  void latest(std::vector<EntityPlace>& out_places) const;

  struct Viewer {
    std::uint16_t entity = 0;  // shown even without a model: the view is in it
    std::size_t players = 0;   // color maps above that are none
  };
  // See ClientState::entities_at().
  std::span<const SeenEntity> at(double time_s, const Viewer& viewer, const ClientSettings& settings);

 private:
  struct Entity {
    net::Baseline baseline;
    net::Baseline now;  // as of the last update; its place is the motion's target
    std::uint8_t effects = 0;
    bool jumped = false;
    std::uint32_t packet = 0;  // of the last update
    Motion motion;
    FrameChanges frames;
    // For what is told by difference to the last time that at() was asked.
    bool jumped_since_asked = false, flash_since_asked = false;
    std::uint32_t asked = 0;
    math::Vec3 origin_when_asked_world{0.0f};
  };
  Entity& entity(std::uint16_t number);
  SeenEntity seen(std::uint16_t number, double time_s, const Viewer& viewer, const ClientSettings& settings);

  std::vector<Entity> entities_;  // by number
  std::vector<std::uint16_t> arriving_, shown_;
  std::vector<SeenEntity> statics_, seen_;
  // Count packets and questions; the fields of the same meaning in Entity start below both.
  std::uint32_t packet_ = 2, asked_ = 2;
};

}  // namespace temblor::client
