#include "net/transport/loopback.h"

#include <deque>
#include <map>
#include <utility>

#include "base/check.h"

namespace temblor::net {
namespace {

struct QueuedDatagram {
  platform::Address from;
  base::ByteVector bytes;
};
struct Inbox {
  std::deque<QueuedDatagram> queue;
  std::size_t bytes = 0;
};

// Includes the overhead of a queue entry, so that empty datagrams cannot pile up without limit.
std::size_t compute_queue_cost(base::Bytes bytes) {
  return sizeof(QueuedDatagram) + bytes.size();
}

}  // namespace

struct LoopbackNetwork::Sockets {
  std::map<std::uint16_t, Inbox> inboxes;
};

namespace {

class LoopbackSocket final : public platform::DatagramSocket {
 public:
  LoopbackSocket(std::shared_ptr<LoopbackNetwork::Sockets> sockets, std::uint16_t port)
      : sockets_(std::move(sockets)), port_(port) {}
  LoopbackSocket(const LoopbackSocket&) = delete;
  LoopbackSocket& operator=(const LoopbackSocket&) = delete;
  ~LoopbackSocket() override { sockets_->inboxes.erase(port_); }

  void send(const platform::Address& to, base::Bytes bytes) override {
    const auto found = sockets_->inboxes.find(to.port);
    if (!to.is_local() || found == sockets_->inboxes.end()) return;
    Inbox& inbox = found->second;
    if (inbox.bytes + compute_queue_cost(bytes) > kLoopbackBufferBytes) return;
    inbox.bytes += compute_queue_cost(bytes);
    inbox.queue.push_back({local_address(), {bytes.begin(), bytes.end()}});
  }

  std::optional<platform::Datagram> receive() override {
    Inbox& inbox = sockets_->inboxes.at(port_);
    if (inbox.queue.empty()) return std::nullopt;
    received_ = std::move(inbox.queue.front());
    inbox.queue.pop_front();
    inbox.bytes -= compute_queue_cost(received_.bytes);
    return platform::Datagram{.from = received_.from, .bytes = received_.bytes};
  }

  platform::Address local_address() const override { return {{}, port_, 0}; }

 private:
  std::shared_ptr<LoopbackNetwork::Sockets> sockets_;
  std::uint16_t port_;
  QueuedDatagram received_;
};

}  // namespace

LoopbackNetwork::LoopbackNetwork() : sockets_(std::make_shared<Sockets>()) {}

std::unique_ptr<platform::DatagramSocket> LoopbackNetwork::open(std::uint16_t port) {
  const bool any = port == 0;
  if (any) port = 1;
  while (any && sockets_->inboxes.contains(port)) ++port;
  CHECK(sockets_->inboxes.try_emplace(port).second, "port {} is in use", port);
  return std::make_unique<LoopbackSocket>(sockets_, port);
}

}  // namespace temblor::net
