// Players report to their team where they are (.loc files), and what they carry. In team chat, letters
// after a percent sign stand for it, as in ProQuake and DarkPlaces.
#pragma once

#include <string>
#include <string_view>

#include "client/session/client_state.h"

namespace temblor::host {

struct Host;

// Names of the places where the player is, and where it last died.
struct ChatPlaces {
  std::string here, of_death;
};

// Replaces %h (health), %a (armor), %r (rockets), %c (cells), %w (weapons), %p (power-ups), %l and %d
// (`places`), and %t (`time_s`, as minutes and seconds); %% is a percent sign. Everything else stays.
std::string expand_chat_macros(std::string_view text, const client::Game& game, const ChatPlaces& places,
                               double time_s);
// The same for a line that a player says in the game on the screen.
std::string expand_chat_macros(Host& io_host, std::string_view text);

// Registers "loc".
void add_location_command(Host& io_host);

}  // namespace temblor::host
