#include "support/programs/bad_network.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace temblor::test {

class BadSocket final : public platform::DatagramSocket {
 public:
  BadSocket(BadNetwork& network, const platform::Address& address) : network_(network), address_(address) {}
  BadSocket(const BadSocket&) = delete;
  BadSocket& operator=(const BadSocket&) = delete;
  ~BadSocket() override { network_.inboxes_.erase(address_); }

  void send(const platform::Address& to, base::Bytes bytes) override { network_.send(address_, to, bytes); }
  std::optional<platform::Datagram> receive() override {
    auto& inbox = network_.inboxes_.at(address_);
    if (inbox.empty() || inbox.begin()->arrives_s > network_.now_s_) return std::nullopt;
    auto first = inbox.extract(inbox.begin());
    received_ = std::move(first.value().bytes);
    return platform::Datagram{.from = first.value().from, .bytes = received_};
  }
  platform::Address local_address() const override { return address_; }

 private:
  BadNetwork& network_;
  platform::Address address_;
  base::ByteVector received_;
};

BadNetwork::BadNetwork(const NetworkConditions& conditions, std::uint64_t seed)
    : conditions_(conditions), random_(seed) {}

std::unique_ptr<platform::DatagramSocket> BadNetwork::open(const platform::Address& address) {
  CHECK(inboxes_.try_emplace(address).second, "{} is taken", to_text(address));
  return std::make_unique<BadSocket>(*this, address);
}

void BadNetwork::advance_to(double now_s) {
  now_s_ = std::max(now_s_, now_s);
}

std::uint64_t BadNetwork::bytes_sent_to(const platform::Address& address) const {
  const auto found = sent_.find(address);
  return found == sent_.end() ? 0 : found->second.bytes;
}

std::uint64_t BadNetwork::datagrams_sent_to(const platform::Address& address) const {
  const auto found = sent_.find(address);
  return found == sent_.end() ? 0 : found->second.datagrams;
}

void BadNetwork::send(const platform::Address& from, const platform::Address& to, base::Bytes bytes) {
  Sent& sent = sent_[to];
  ++sent.datagrams;
  sent.bytes += bytes.size();
  if (random_.chance(conditions_.loss)) return;
  travel(from, to, bytes);
  if (random_.chance(conditions_.duplication)) travel(from, to, bytes);
}

void BadNetwork::travel(const platform::Address& from, const platform::Address& to, base::Bytes bytes) {
  const auto inbox = inboxes_.find(to);
  if (inbox == inboxes_.end()) return;
  const double jitter_s = random_.uniform(-conditions_.jitter_s, conditions_.jitter_s);
  const double delay_s = std::max(0.0, conditions_.delay_s + jitter_s);
  inbox->second.insert({now_s_ + delay_s, number_++, from, {bytes.begin(), bytes.end()}});
}

}  // namespace temblor::test
