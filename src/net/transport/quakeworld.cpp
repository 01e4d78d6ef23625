#include "net/transport/quakeworld.h"

#include <string>

namespace temblor::net {
namespace {

constexpr std::string_view kOutOfBand = "\xff\xff\xff\xff";

bool begins_with(base::Bytes packet, std::string_view word) {
  const std::string_view text = base::as_text(packet);
  return text.starts_with(kOutOfBand) && text.substr(kOutOfBand.size()).starts_with(word);
}

base::ByteVector make_packet(std::string_view word, std::string_view text) {
  std::string packet(kOutOfBand);
  packet += word;
  packet += text;
  const base::Bytes bytes = base::as_bytes(packet);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

bool is_quakeworld_join(base::Bytes packet) {
  return begins_with(packet, "getchallenge") || begins_with(packet, "connect");
}

base::ByteVector make_quakeworld_print(std::string_view text) {
  return make_packet("n", text);
}

base::ByteVector make_quakeworld_status_request() {
  return make_packet("status", "\n");
}

bool is_status_request(base::Bytes packet) {
  return begins_with(packet, "status") || begins_with(packet, "getstatus");
}

bool is_quakeworld_status(base::Bytes packet) {
  return begins_with(packet, "n\\");
}

base::ByteVector make_darkplaces_status_request() {
  return make_packet("getstatus", "\n");
}

bool is_darkplaces_status(base::Bytes packet) {
  return begins_with(packet, "statusResponse\n");
}

}  // namespace temblor::net
