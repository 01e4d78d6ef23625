// The host's side of HUD programs (client/hud_program/hud_program.h): the services that a program gets, and
// the moments at which it runs. It reads variables, which the server's game code may set, so it never runs
// while a server tick does.
#pragma once

#include "client/hud_program/hud_program.h"
#include "command/console.h"

namespace temblor::host {

struct Host;

client::HudProgramServices hud_program_services(Host& io_host);
// Runs the program for a frame of this size, if there is a view and cl_nocsqc is not set.
void draw_hud_program(Host& io_host, int width, int height);
// Offers an event of the game to the program. Returns whether it consumed the event. Releases of keys are
// never consumed, so that no key stays held.
bool pass_event_to_hud_program(Host& io_host, const platform::InputEvent& event);
// Prints a text that the server has sent, unless the program takes it.
void print_server_text(Host& io_host, std::string_view text);
// Runs a console line that the server has sent, unless the program takes it.
void run_server_line(Host& io_host, std::string_view line);
// Offers a command that the console does not know. Returns whether the program handled it.
bool run_hud_program_command(Host& io_host, command::Console::Arguments arguments);

}  // namespace temblor::host
