// Opening and closing the menus of a running game.
#pragma once

#include "client/menu/menu.h"

namespace temblor::host {

struct Host;

// Opens a page. Closes the console and the pages that are open, and releases all held keys.
void open_menu(Host& io_host, client::MenuPage page);
// Closes the menu, or opens its main page.
void toggle_menu(Host& io_host);
// Queues the release commands ("-forward") of all held keys. Call it whenever keys stop controlling the game,
// because the game will not see their release and the player would keep running.
void release_held_keys(Host& io_host);

}  // namespace temblor::host
