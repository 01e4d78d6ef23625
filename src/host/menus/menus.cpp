#include "host/menus/menus.h"

#include "host/frame/host_parts.h"

namespace temblor::host {

void open_menu(Host& io_host, client::MenuPage page) {
  io_host.console.ui.close();
  release_held_keys(io_host);
  io_host.game.menu->open(page);
}

void toggle_menu(Host& io_host) {
  if (io_host.game.menu->is_open())
    io_host.game.menu->close();
  else
    open_menu(io_host, client::MenuPage::kMain);
}

void release_held_keys(Host& io_host) {
  io_host.console.commands.append(io_host.input.held.release_all());
}

}  // namespace temblor::host
