// Starting, saving and leaving games, and the other files that are written during a game: screenshots,
// pictures of saved games, console text.
//
// These are the player's actions, called by console commands and menus. Session (session/session.h) holds the
// game; the functions here coordinate it with the demos, the recording, the menu and the console.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "render/frame_buffer.h"

namespace temblor::host {

struct Host;

// Starts a new game on a level. If there is no such level, the running game continues.
base::Status start_map(Host& io_host, std::string_view map);
// Continues a saved game, "NAME" or "NAME.sav". If there is none, the running game continues.
base::Status load_game(Host& io_host, std::string_view name);
// Saves the game of our own server as NAME.sav, and the next frame's view as NAME.png. The menu shows the
// title, or the level's if it is empty. Fails in a game on another machine.
base::Status save_game(Host& io_host, std::string_view name, std::string_view title = {});
// Joins a game on another machine: "HOST" or "HOST:PORT". If the address cannot be resolved, the running game
// continues. Returns before the server has replied; read_network() reports a failure.
base::Status connect_to_server(Host& io_host, std::string_view address);
// Ends the game or the demo, and finishes a recording.
void disconnect(Host& io_host);
// Disconnects and saves the configuration, before the program ends.
void leave_game(Host& io_host);

// Whether the game can be saved now: single player, alive, and not in an intermission.
bool can_save(const Host& host);
// Returns a warning for the player that progress would be lost if the game ended now. Empty if there is
// nothing to lose: the game was just saved or started, cannot be saved, or saves itself when it is left.
std::string find_unsaved_progress(const Host& host);
// Writes the view as the picture of the saved game that SaveStatus::picture_request names.
void write_save_picture(Host& io_host, const render::FrameBuffer& frame);

// Writes the last frame, as it was shown, as a PNG. An empty name stands for the next free "temblorNNNN.png".
// A relative path is below the write folder.
base::Status write_screenshot(Host& io_host, std::string_view file);
// Writes the console's text to a file in the write folder.
base::Status dump_console(Host& io_host, std::string_view file);

// Starts to search the local network for servers (session/server_search.h).
void search_servers(Host& io_host);
// Does the same, and prints the servers as they reply.
void list_servers(Host& io_host);
// Reads the replies of a search, for the menu and the console.
void update_server_search(Host& io_host);

}  // namespace temblor::host
