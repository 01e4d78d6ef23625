// The stages of a host frame, in the order in which run_frame() calls them.
//
// The order keeps latency low: the wait comes before input is read, and a key press takes effect
// in the same frame, in its commands, moves and picture:
//
//   key event -> binding -> console command -> move to the server -> prediction -> scene -> picture
#pragma once

namespace temblor::host {

struct Host;

// Waits until the next frame is due, so that frames come at an even rate, and reads the clock. Input is read
// after the wait, so that it is fresh.
void wait_for_frame(Host& io_host);
// Handles the window's events: keys run their bindings, the mouse and sticks turn the view.
void read_input(Host& io_host);
// Runs pending console commands. Starts the attract mode after the first ones if they started no game. Then
// switches to other game folders if a command requested it.
void run_commands(Host& io_host);
// Applies the variables that changed: window, player name and colors, mouse capture, text input.
void apply_variables(Host& io_host);
// Reads packets from the server, prints its text, and runs the console commands that it sends, if they are
// allowed. Adds a notice if the connection was lost.
void read_network(Host& io_host);
// Turns the view, sends the moves that are due, and starts this frame's prediction.
void look_and_move(Host& io_host);
// Advances the game or the demo to this frame's moment and builds its scene. A game that cannot be shown ends
// with a notice.
void make_scene(Host& io_host);
// Shows the notices of this frame in the menu.
void show_notices(Host& io_host);
// Passes the scene's sounds, the menus' clicks and the music to the mixer.
void play_sound(Host& io_host);
// Draws the view, the overlay and the menus, and shows them in the window. The ticks of our own server run in
// parallel on the worker thread, or after the picture is shown.
void draw_and_show(Host& io_host);

}  // namespace temblor::host
