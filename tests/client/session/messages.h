// Helpers to build messages: a level with a few names, and packets as a server sends them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <string_view>

#include "client/session/client_state.h"

namespace temblor::test {

inline constexpr std::array<std::string_view, 4> kModels = {"maps/start.bsp", "progs/player.mdl",
                                                            "progs/ogre.mdl", "progs/flame.mdl"};
inline constexpr std::array<std::string_view, 2> kSounds = {"weapons/guncock.wav", "misc/menu1.wav"};
inline constexpr std::uint16_t kPlayerModel = 2, kOgreModel = 3, kFlameModel = 4;

inline net::ServerInfo server_info() {
  net::ServerInfo info;
  info.max_clients = 4;
  info.level_name = "Entrance";
  info.models = kModels;
  info.sounds = kSounds;
  return info;
}

inline void apply(client::ClientState& io_state, std::initializer_list<net::ServerMessage> messages) {
  for (const net::ServerMessage& message : messages) {
    const base::Status status = io_state.apply(message);
    ASSERT_TRUE(status.ok()) << net::message_name(message) << ": " << status.error().message();
  }
}

// Applies one packet: its time, then the messages.
inline void packet(client::ClientState& io_state, float time_s,
                   std::initializer_list<net::ServerMessage> messages) {
  apply(io_state, {net::Time{time_s}});
  apply(io_state, messages);
  io_state.end_packet();
}

inline client::ClientState state_in_level() {
  client::ClientState state;
  apply(state, {server_info(), net::SetView{1}});
  state.end_packet();
  state.events().clear();
  return state;
}

// A baseline with this model and place, and defaults for everything else.
inline net::EntityUpdate update_at(std::uint16_t number, std::uint16_t model, const math::Vec3& origin,
                                   const math::Vec3& angles_deg = math::Vec3(0.0f)) {
  net::EntityUpdate update;
  update.number = number;
  update.model = model;
  for (int axis = 0; axis < 3; ++axis) {
    update.origin[static_cast<std::size_t>(axis)] = origin[axis];
    update.angles_deg[static_cast<std::size_t>(axis)] = angles_deg[axis];
  }
  return update;
}

inline net::EntityUpdate with_frame(net::EntityUpdate update, std::uint16_t frame) {
  update.frame = frame;
  return update;
}
inline net::EntityUpdate with_effects(net::EntityUpdate update, std::uint8_t effects) {
  update.effects = effects;
  return update;
}
inline net::EntityUpdate in_steps(net::EntityUpdate update) {
  update.step = true;
  return update;
}

}  // namespace temblor::test
