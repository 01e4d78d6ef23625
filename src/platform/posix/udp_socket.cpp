#include "platform/posix/udp_socket.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <string>
#include <utility>

namespace temblor::platform::posix {
namespace {

// Holds all datagrams that arrive between two ticks, even if 64 clients send bursts.
constexpr int kReceiveBufferBytes = 1 << 20;
// UDP has a 16-bit length.
constexpr std::size_t kMaxDatagramBytes = 65536;

// An address as the socket functions take it. Only `size` bytes of the storage are valid.
struct SystemAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;

  sockaddr* get() { return reinterpret_cast<sockaddr*>(&storage); }
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

// `family` is the socket's: an IPv6 socket also sends to IPv4 hosts, in their IPv6 form. Structs are copied
// by memcpy, because a cast would break the aliasing rules.
SystemAddress to_system(const Address& address, int family) {
  SystemAddress system;
  if (family == AF_INET) {
    sockaddr_in ip4{};
    ip4.sin_family = AF_INET;
    ip4.sin_port = htons(address.port);
    std::memcpy(&ip4.sin_addr, address.host.data() + 12, 4);
    std::memcpy(&system.storage, &ip4, sizeof(ip4));
    system.size = sizeof(ip4);
  } else {
    sockaddr_in6 ip6{};
    ip6.sin6_family = AF_INET6;
    ip6.sin6_port = htons(address.port);
    ip6.sin6_scope_id = address.scope;
    std::memcpy(&ip6.sin6_addr, address.host.data(), 16);
    std::memcpy(&system.storage, &ip6, sizeof(ip6));
    system.size = sizeof(ip6);
  }
  return system;
}

Address from_system(const sockaddr_storage& storage) {
  if (storage.ss_family == AF_INET) {
    sockaddr_in ip4{};
    std::memcpy(&ip4, &storage, sizeof(ip4));
    std::array<std::uint8_t, 4> host{};
    std::memcpy(host.data(), &ip4.sin_addr, host.size());
    return ip4_address(host, ntohs(ip4.sin_port));
  }
  sockaddr_in6 ip6{};
  std::memcpy(&ip6, &storage, sizeof(ip6));
  Address address;
  std::memcpy(address.host.data(), &ip6.sin6_addr, address.host.size());
  address.port = ntohs(ip6.sin6_port);
  address.scope = ip6.sin6_scope_id;
  return address;
}

double to_seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// How long ago the system says the message has arrived; 0 if it does not say, or if its clock was changed.
double find_waiting_time(msghdr& message) {
  constexpr double kMaxWaiting_s = 10;
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec arrived{}, now{};
    std::memcpy(&arrived, CMSG_DATA(header), sizeof(arrived));
    clock_gettime(CLOCK_REALTIME, &now);
    const double waited_s = to_seconds(now) - to_seconds(arrived);
    return waited_s >= 0 && waited_s < kMaxWaiting_s ? waited_s : 0;
  }
  return 0;
}

// Owns a non-blocking socket and the buffer of the last received datagram.
class UdpSocket final : public DatagramSocket {
 public:
  UdpSocket(int descriptor, int family) : descriptor_(descriptor), family_(family) {
    buffer_.resize(kMaxDatagramBytes);
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  ~UdpSocket() override { close(descriptor_); }

  void send(const Address& to, base::Bytes bytes) override {
    // An IPv4 socket has no way to an IPv6 host, so the datagram is lost.
    if (family_ == AF_INET && !to.is_ip4()) return;
    const SystemAddress system = to_system(to, family_);
    while (sendto(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL, system.get(), system.size) < 0 &&
           errno == EINTR) {
    }
  }

  std::optional<Datagram> receive() override {
    while (true) {
      SystemAddress from;
      iovec part{buffer_.data(), buffer_.size()};
      alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(timespec))> control{};
      msghdr message{};
      message.msg_name = &from.storage;
      message.msg_namelen = sizeof(from.storage);
      message.msg_iov = &part;
      message.msg_iovlen = 1;
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      const ssize_t size = recvmsg(descriptor_, &message, 0);
      if (size >= 0)
        return Datagram{from_system(from.storage), base::Bytes(buffer_).first(static_cast<std::size_t>(size)),
                        find_waiting_time(message)};
      // Some systems report here that nobody received an earlier datagram. That does not affect this one.
      if (errno != EINTR && errno != ECONNREFUSED) return std::nullopt;
    }
  }

  Address local_address() const override {
    SystemAddress system;
    system.size = sizeof(system.storage);
    if (getsockname(descriptor_, system.get(), &system.size) != 0) return {};
    return from_system(system.storage);
  }

 private:
  int descriptor_;
  int family_;
  base::ByteVector buffer_;
};

base::Error system_error(const Address& address, const char* doing) {
  return base::error(base::ErrorCode::kIo, "UDP port {}: {}: {}", address.port, doing, std::strerror(errno));
}

// Opens and binds a socket. Options that the system refuses are not fatal; only bind() can fail later.
base::Result<std::unique_ptr<DatagramSocket>> open_with_family(const Address& address, int family) {
  const int descriptor = socket(family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, IPPROTO_UDP);
  if (descriptor < 0) return system_error(address, "cannot be opened");
  auto opened = std::make_unique<UdpSocket>(descriptor, family);
  const int off = 0;
  if (family == AF_INET6) setsockopt(descriptor, IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof(off));
  // The search for servers on the local network sends broadcasts.
  const int on = 1;
  setsockopt(descriptor, SOL_SOCKET, SO_BROADCAST, &on, sizeof(on));
  // Datagrams come with the time of their arrival.
  setsockopt(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof(on));
  // The system may grant a smaller buffer.
  setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &kReceiveBufferBytes, sizeof(kReceiveBufferBytes));
  const SystemAddress system = to_system(address, family);
  if (bind(descriptor, system.get(), system.size) != 0) {
    if (errno == EADDRINUSE)
      return base::error(base::ErrorCode::kIo, "UDP port {} is in use by another program", address.port);
    if (errno == EADDRNOTAVAIL)
      return base::error(base::ErrorCode::kUsage, "{} is not an address of this machine", host_text(address));
    return system_error(address, "cannot be used");
  }
  return std::unique_ptr<DatagramSocket>(std::move(opened));
}

struct FreeAddrInfo {
  void operator()(addrinfo* list) const { freeaddrinfo(list); }
};

}  // namespace

base::Result<std::unique_ptr<DatagramSocket>> open_udp_socket(const UdpOptions& options) {
  if (!options.host.empty()) {
    const std::optional<Address> address = parse_host(options.host, options.port);
    if (!address)
      return base::error(base::ErrorCode::kUsage, "'{}' is not a numeric address such as 192.168.1.20",
                         std::string(options.host));
    return open_with_family(*address, address->is_ip4() ? AF_INET : AF_INET6);
  }
  const Address all_interfaces{{}, options.port, 0};
  auto dual_stack = open_with_family(all_interfaces, AF_INET6);
  // The second attempt is for machines without IPv6. If the port is in use, it fails too, with the same
  // error.
  return dual_stack.ok() ? std::move(dual_stack) : open_with_family(all_interfaces, AF_INET);
}

// The system lets a socket receive only at the machine's own addresses.
bool is_own_host(const Address& address) {
  const Address any_port{address.host, 0, address.scope};
  return open_with_family(any_port, address.is_ip4() ? AF_INET : AF_INET6).ok();
}

base::Result<Address> look_up(std::string_view host_and_port, std::uint16_t default_port) {
  TRY(const HostAndPort parts, split_host_and_port(host_and_port));
  const std::uint16_t port = parts.port.value_or(default_port);
  if (const auto address = parse_host(parts.host, port)) return *address;
  // Takes the first IPv4 address, or else the first IPv6 address: most servers listen on IPv4 only.
  addrinfo hints{};
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* first = nullptr;
  const int failure = getaddrinfo(parts.host.c_str(), nullptr, &hints, &first);
  const std::unique_ptr<addrinfo, FreeAddrInfo> list(first);
  std::optional<Address> found;
  for (const addrinfo* entry = failure == 0 ? first : nullptr; entry != nullptr; entry = entry->ai_next) {
    if (entry->ai_family != AF_INET && entry->ai_family != AF_INET6) continue;
    sockaddr_storage storage{};
    std::memcpy(&storage, entry->ai_addr, std::min<std::size_t>(entry->ai_addrlen, sizeof(storage)));
    if (!found || entry->ai_family == AF_INET) found = from_system(storage);
    if (entry->ai_family == AF_INET) break;
  }
  if (!found)
    return base::error(base::ErrorCode::kNotFound, "host '{}' not found: {}", parts.host,
                       failure == 0 ? "it has no address" : gai_strerror(failure));
  found->port = port;
  return *found;
}

}  // namespace temblor::platform::posix
