// Asks the local network which servers there are, and listens to the answers.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "client/menu/menu_content.h"
#include "host/services.h"

namespace temblor::host {

class ServerSearch {
 public:
  // `services` must outlive it.
  explicit ServerSearch(Services& services) : services_(services) {}

  // Forgets what was found and asks anew. Fails where there is no network.
  base::Status begin(double now_s);
  // Reads what has come. Whether the list has changed.
  bool update(double now_s);
  const std::vector<client::MenuServer>& found() const { return found_; }

 private:
  // Servers are asked for once; who answers without end is not listened to for ever.
  static constexpr std::size_t kMaxServers = 256;

  Services& services_;
  std::unique_ptr<platform::DatagramSocket> socket_;  // null: not searching
  double asked_s_ = 0;
  std::vector<client::MenuServer> found_;
};

}  // namespace temblor::host
