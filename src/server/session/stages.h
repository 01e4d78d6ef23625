// The stages of a server's step and tick, in the order in which they run, and the functions that they share.
// All of them act on one `Server`; each group is one source file of this folder.
//    step_server():  receive_packets, console, send_changed_rules, ticks, replace_dead_connections,
//                    drop_failed_clients, send_packets, autosave_if_due
//    server_tick():  play_moves, send_move_parameters, Game::tick, update_bot_clients, send_snapshots,
//                    handle_game_requests
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/transport/server_endpoint.h"

namespace temblor::server {

struct GameRequest;
struct LoadedGame;
struct Server;

// --- connections.cpp: clients that come and go.

// Handles all events of the endpoint: new clients, packets, disconnects, and remote commands.
void receive_packets(Server& io_server);
// Passes each connection its next reliable message, and sends all packets.
void send_packets(Server& io_server);
// Drops every client with a `drop_reason`.
void drop_failed_clients(Server& io_server);
// The answer to a server browser.
net::ServerDescription describe_server(const Server& server);
// Clears a free slot's name, frags and colors on all score boards.
void send_empty_slot(Server& io_server, std::size_t slot);

// --- client_messages.cpp: messages from clients.

// Handles one packet of a client. A packet that cannot be read gives the client a `drop_reason`.
void handle_packet(Server& io_server, std::size_t slot, base::Bytes bytes, bool is_reliable);

// --- joining.cpp: how a client gets into the level. Its stage (client.h) says how far it is.

// Sends which level is running and which files it needs.
base::Status send_level_info(Server& io_server, std::size_t slot);
// Does the same for a client that is in another level, or still loads it.
void send_next_level(Server& io_server, std::size_t slot);
// Answers "prespawn": sends static entities, baselines and what game code wrote for all joining clients.
base::Status send_signon(Server& io_server, std::size_t slot);
// Answers "spawn": puts the player into the game. Fails if QuakeC does.
base::Status spawn_client(Server& io_server, std::size_t slot);
// Answers "begin": from now on the client sends moves and gets snapshots.
void begin_play(Server& io_server, std::size_t slot);
// Takes the player out of the game; its client stays connected.
void disconnect_player(Server& io_server, std::size_t slot);

// --- player_names.cpp

// Names a client as it wants. If another player has the name, a number follows: "player (2)".
void set_player_name(Server& io_server, std::size_t slot, const std::string& wanted);
// Drops connections whose players have come back with another one, and gives these the names that they want.
void replace_dead_connections(Server& io_server);

// --- player_moves.cpp: from packets to the game. The path of a move:
//   net::Move -> PlayerInput -> Client::moves (a MoveQueue) -> play_moves() -> Game::play_move() or tick()

// Plays the moves of all players that are due, except each player's last one, which becomes its input of this
// tick (Server::tick_inputs). Fails if QuakeC does.
base::Status play_moves(Server& io_server);
// Sends each player the settings with which its moves are played, if they have changed.
void send_move_parameters(Server& io_server);

// --- send_snapshots.cpp

// Sends every player the state of the game after this tick, and queues its reliable messages.
void send_snapshots(Server& io_server);
// Gives bots that QuakeC has added or removed a slot, and sends their names and colors.
void update_bot_clients(Server& io_server);
// Prints the rules of the game that the host has changed to all players, as stock servers do.
void send_changed_rules(Server& io_server);

// --- levels.cpp

// Sets a level up without touching the running one.
base::Result<LoadedGame> load_level(Server& io_server, const GameRequest& request);
// A request for this level with the host's settings.
GameRequest make_request(const Server& server, std::string_view map);
// Makes the loaded game the running one, and sends it to all clients.
void set_game(Server& io_server, LoadedGame loaded);
// Does what QuakeC requested while it ran: commands, dropped players, a change of level.
void handle_game_requests(Server& io_server);
// QuakeC has failed: prints why and restarts the level. If it fails again soon, the player on whose behalf it
// ran is dropped, or the level ends.
void handle_game_failure(Server& io_server, const base::Error& error);

// --- save/saved_games.cpp

// Saves the game if an autosave is due.
void autosave_if_due(Server& io_server);
// Saves the game if the player would lose progress otherwise.
void autosave_on_leave(Server& io_server);
// The path of a file that the server may write: letters, digits, '_', '-' and '.', below the write folder.
base::Result<std::filesystem::path> make_write_path(const Server& server, std::string_view name,
                                                    std::string_view suffix);

}  // namespace temblor::server
