#include "net/protocol/numbered_moves.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>

#include "net/transport/base64url.h"

namespace temblor::net {
namespace {

// Limit for every received number, so that sums and products stay finite.
constexpr float kMaxMagnitude = 1e6f;

constexpr std::string_view kParametersPrefix = "//temblor moves ", kAcknowledgmentPrefix = "//a ";
constexpr std::string_view kPacketPrefix = "tm ", kNoSnapshot = "-";
constexpr std::string_view kDeltaOffer = "//temblor differences\n";
constexpr std::size_t kSnapshotDigits = 3;  // base64url characters of 16 bits
constexpr double kMinTick_s = 0.001, kMaxTick_s = 0.1;

// An acknowledgment before base64url, little-endian:
//
//   flags u16 | number u32 | move type u8, water level u8, ground u16 | origin, velocity, angles 9 x f32 |
//   [punch 3 x f32] | [water jump velocity 2 x f32] | [teleport time f32] | [own gravity f32] |
//   [ride: origin, velocity, time left 7 x f32]
//
// Everything after the flags is a multiple of 4 bytes long, so delta compression can treat it as 32-bit words
// without knowing the fields (read_acknowledgment_words()).
//
// First field of an acknowledgment. kPunched to kRide mark optional fields.
enum Flag : std::uint16_t {
  kAlive = 1,
  kOnGround = 2,
  kJumpReleased = 4,
  kJumpingOutOfWater = 8,
  kTurnedByGame = 16,
  kSlime = 32,
  kLava = 64,
  kPunched = 128,
  kTeleported = 256,
  kOwnGravity = 512,
  kRide = 1024,
  kCrouching = 2048,
};

std::uint16_t compute_flags(const MoveAcknowledgment& a) {
  std::uint16_t flags = 0;
  const auto add = [&](bool is_set, Flag flag) {
    if (is_set) flags = static_cast<std::uint16_t>(flags | flag);
  };
  add(a.is_alive, kAlive);
  add(a.on_ground, kOnGround);
  add(a.is_jump_released, kJumpReleased);
  add(a.is_jumping_out_of_water, kJumpingOutOfWater);
  add(a.is_turned_by_game, kTurnedByGame);
  add(a.is_in_slime, kSlime);
  add(a.is_in_lava, kLava);
  add(a.is_crouching, kCrouching);
  add(a.punch_deg != math::Vec3(0.0f), kPunched);
  add(a.teleport_time_s != 0, kTeleported);
  add(a.own_gravity != 1, kOwnGravity);
  add(a.ride.has_value(), kRide);
  return flags;
}

// Visits the fields after the flags in wire order; used for reading and writing.
template <typename Wire, typename Acknowledgment>
void visit_fields(Wire& io_wire, Acknowledgment& a, std::uint16_t flags) {
  io_wire(a.number);
  io_wire(a.move_type);
  io_wire(a.water_level);
  io_wire(a.ground);
  io_wire(a.origin);
  io_wire(a.velocity);
  io_wire(a.angles_deg);
  if (flags & kPunched) io_wire(a.punch_deg);
  if (flags & kJumpingOutOfWater) {
    io_wire(a.water_jump_velocity.x);
    io_wire(a.water_jump_velocity.y);
  }
  if (flags & kTeleported) io_wire(a.teleport_time_s);
  if (flags & kOwnGravity) io_wire(a.own_gravity);
  if (flags & kRide) {
    io_wire(a.ride->origin);
    io_wire(a.ride->velocity);
    io_wire(a.ride->left_s);
  }
}

// The flags and the words after them: larger than all fields together.
using WireBytes = std::array<std::byte, 2 + 4 * (kMaxAcknowledgmentWords - 1)>;

struct WireWriter {
  WireBytes bytes;
  std::size_t size = 0;
  template <typename T>
  void operator()(const T& value) {
    std::memcpy(&bytes[size], &value, sizeof(T));
    size += sizeof(T);
  }
  void operator()(const math::Vec3& value) {
    for (int axis = 0; axis < 3; ++axis) (*this)(value[axis]);
  }
};

struct WireReader {
  base::ByteReader bytes;
  bool is_sane = true;  // all floats are within kMaxMagnitude
  template <typename T>
  void operator()(T& out_value) {
    out_value = bytes.read<T>();
  }
  void operator()(float& out_value) {
    out_value = bytes.f32();
    is_sane = is_sane && std::abs(out_value) <= kMaxMagnitude;
  }
  void operator()(math::Vec3& out_value) {
    for (int axis = 0; axis < 3; ++axis) (*this)(out_value[axis]);
  }
};

std::string_view remove_line_end(std::string_view line) {
  while (line.ends_with('\n')) line.remove_suffix(1);
  return line;
}

// Parses exactly kCount numbers separated by spaces.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> parse_numbers(std::string_view text) {
  std::array<double, kCount> numbers{};
  for (double& number : numbers) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || !(std::abs(number) <= kMaxMagnitude)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return text.empty() ? std::optional(numbers) : std::nullopt;
}

// Also rejects NaN, because every comparison with it is false.
bool is_tick(double tick_s) {
  return tick_s >= kMinTick_s && tick_s <= kMaxTick_s;
}

}  // namespace

std::string format_move_parameters(const MoveParameters& m) {
  const math::PhysicsSettings& p = m.physics;
  return fmt::format("{}{} {} {} {} {} {} {} {} {} {} {}\n", kParametersPrefix, m.entity, m.tick_s,
                     m.world_tick_s, p.gravity, p.max_velocity, p.friction, p.edge_friction, p.stop_speed,
                     p.accelerate, p.max_speed, p.no_step ? 1 : 0);
}

std::optional<MoveParameters> read_move_parameters(std::string_view line) {
  if (!line.starts_with(kParametersPrefix)) return std::nullopt;
  const auto numbers = parse_numbers<11>(remove_line_end(line.substr(kParametersPrefix.size())));
  if (!numbers) return std::nullopt;
  const auto& n = *numbers;
  if (!(n[0] >= 1 && n[0] <= 65535) || !is_tick(n[1]) || !is_tick(n[2])) return std::nullopt;
  const auto number = [&](std::size_t i) { return static_cast<float>(n[i]); };
  return MoveParameters{.entity = static_cast<std::uint16_t>(n[0]),
                        .tick_s = n[1],
                        .world_tick_s = n[2],
                        .physics = {.gravity = number(3),
                                    .max_velocity = number(4),
                                    .friction = number(5),
                                    .edge_friction = number(6),
                                    .stop_speed = number(7),
                                    .accelerate = number(8),
                                    .max_speed = number(9),
                                    .no_step = n[10] != 0}};
}

void write_acknowledgment(const MoveAcknowledgment& acknowledgment, std::string& out_line) {
  const std::uint16_t flags = compute_flags(acknowledgment);
  WireWriter writer;
  writer(flags);
  visit_fields(writer, acknowledgment, flags);
  out_line = kAcknowledgmentPrefix;
  append_base64url(base::Bytes(writer.bytes).first(writer.size), out_line);
  out_line += '\n';
}

std::optional<MoveAcknowledgment> read_acknowledgment(std::string_view line) {
  if (!line.starts_with(kAcknowledgmentPrefix)) return std::nullopt;
  WireBytes bytes;
  const auto size = read_base64url(remove_line_end(line.substr(kAcknowledgmentPrefix.size())), bytes);
  if (!size) return std::nullopt;
  WireReader reader{base::ByteReader(base::Bytes(bytes).first(*size))};
  const std::uint16_t flags = reader.bytes.u16();
  MoveAcknowledgment a;
  a.is_alive = (flags & kAlive) != 0;
  a.on_ground = (flags & kOnGround) != 0;
  a.is_jump_released = (flags & kJumpReleased) != 0;
  a.is_jumping_out_of_water = (flags & kJumpingOutOfWater) != 0;
  a.is_turned_by_game = (flags & kTurnedByGame) != 0;
  a.is_crouching = (flags & kCrouching) != 0;
  a.is_in_slime = (flags & kSlime) != 0;
  a.is_in_lava = (flags & kLava) != 0;
  if (flags & kRide) a.ride = MoveAcknowledgment::Ride{};
  visit_fields(reader, a, flags);
  return reader.bytes.ok() && reader.is_sane ? std::optional(a) : std::nullopt;
}

// Restorable exactly: the flags are 2 bytes, and the rest must be whole words.
std::size_t read_acknowledgment_words(std::string_view line, std::span<std::uint32_t> out_words) {
  if (!line.starts_with(kAcknowledgmentPrefix) || !line.ends_with('\n')) return 0;
  line.remove_prefix(kAcknowledgmentPrefix.size());
  line.remove_suffix(1);
  WireBytes bytes;
  const auto size = read_base64url(line, bytes);
  if (!size || *size % 4 != 2) return 0;
  const std::size_t count = 1 + *size / 4;
  if (count > out_words.size()) return 0;
  base::ByteReader reader(base::Bytes(bytes).first(*size));
  out_words[0] = reader.u16();
  for (std::uint32_t& word : out_words.subspan(1, count - 1)) word = reader.u32();
  return count;
}

void write_acknowledgment_words(std::span<const std::uint32_t> words, std::string& out_line) {
  WireWriter writer;
  writer(static_cast<std::uint16_t>(words[0]));
  for (const std::uint32_t word : words.subspan(1)) writer(word);
  out_line = kAcknowledgmentPrefix;
  append_base64url(base::Bytes(writer.bytes).first(writer.size), out_line);
  out_line += '\n';
}

std::string format_delta_offer() {
  return std::string(kDeltaOffer);
}

bool is_delta_offer(std::string_view line) {
  return line == kDeltaOffer;
}

std::string format_numbered_packet(const NumberedPacket& packet) {
  std::string command = fmt::format("{}{}", kPacketPrefix, packet.last_move);
  if (!packet.accepts_deltas) return command;
  command += ' ';
  if (!packet.received_snapshot) return command += kNoSnapshot;
  append_base64url(std::as_bytes(std::span(&*packet.received_snapshot, 1)), command);
  return command;
}

std::optional<NumberedPacket> read_numbered_packet(std::string_view command) {
  if (!command.starts_with(kPacketPrefix)) return std::nullopt;
  command.remove_prefix(kPacketPrefix.size());
  NumberedPacket packet;
  const auto [end, failure] =
      std::from_chars(command.data(), command.data() + command.size(), packet.last_move);
  if (failure != std::errc()) return std::nullopt;
  command.remove_prefix(static_cast<std::size_t>(end - command.data()));
  if (command.empty()) return packet;
  if (!command.starts_with(' ')) return std::nullopt;
  command.remove_prefix(1);
  packet.accepts_deltas = true;
  if (command == kNoSnapshot) return packet;
  std::array<std::byte, 2> bytes;
  if (command.size() != kSnapshotDigits || !read_base64url(command, bytes)) return std::nullopt;
  packet.received_snapshot = base::ByteReader(bytes).u16();
  return packet;
}

}  // namespace temblor::net
