// Searches the local network for servers: broadcasts a request, then collects the replies for a few seconds.
//
// The request and the reply are the control packets of the stock game (net/transport/control.h), so stock
// servers are found as well. Only servers at the default port reply. The ping of a server is the time until
// its reply arrived at this machine, however late the frame is that reads it. A server on this machine
// replies twice, from two of its addresses; the list keeps the first reply.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "client/menu/menu_content.h"
#include "host/services.h"
#include "platform/address.h"

namespace temblor::host {

class ServerSearch {
 public:
  // `services` must outlive this object.
  explicit ServerSearch(Services& services) : services_(services) {}

  // Clears the list and starts a new search. Fails if there is no network.
  base::Status begin();
  // Reads replies and ends the search after some seconds. Call it in each frame. Returns whether the list has
  // changed.
  bool update();
  bool is_running() const { return socket_ != nullptr; }
  // The servers that have replied, in the order of their replies.
  const std::vector<client::MenuServer>& found() const { return found_; }

 private:
  bool is_own(const platform::Address& address) const;
  bool is_known(const platform::Address& address) const;

  // Bounds the list, in case a peer sends replies without end.
  static constexpr std::size_t kMaxServers = 256;

  Services& services_;
  std::unique_ptr<platform::DatagramSocket> socket_;  // null: not searching
  double request_s_ = 0;                              // when the request was sent
  std::vector<platform::Address> addresses_;          // of found_
  std::vector<client::MenuServer> found_;
};

}  // namespace temblor::host
