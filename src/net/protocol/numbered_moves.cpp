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

// Of any number that is told: sums of so large ones are numbers still.
constexpr float kMaxOfAnything = 1e6f;

constexpr std::string_view kTermsBegin = "//temblor moves ", kAcknowledgementBegin = "//a ";
constexpr std::string_view kNumberBegin = "tm ", kNoUpdate = "-";
constexpr std::string_view kDeltaOffer = "//temblor differences\n";
constexpr std::size_t kUpdateLetters = 3;  // of a number of 16 bits
constexpr double kMinTick_s = 0.001, kMaxTick_s = 0.1;

enum Flag : std::uint16_t {
  kAlive = 1,
  kOnGround = 2,
  kJumpReleased = 4,
  kJumpingOutOfWater = 8,
  kTurnedByGame = 16,
  kSlime = 32,
  kLava = 64,
  kPunched = 128,
  kSettling = 256,
  kOwnGravity = 512,
  kRide = 1024,
};

std::uint16_t flags_of(const MoveAcknowledgement& a) {
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
  add(a.punch_deg != math::Vec3(0.0f), kPunched);
  add(a.teleport_time_s != 0, kSettling);
  add(a.own_gravity != 1, kOwnGravity);
  add(a.ride.has_value(), kRide);
  return flags;
}

// The same fields in the same order, both ways.
template <typename Wire, typename Acknowledgement>
void exchange(Wire& io_wire, Acknowledgement& a, std::uint16_t flags) {
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
  if (flags & kSettling) io_wire(a.teleport_time_s);
  if (flags & kOwnGravity) io_wire(a.own_gravity);
  if (flags & kRide) {
    io_wire(a.ride->origin);
    io_wire(a.ride->velocity);
    io_wire(a.ride->left_s);
  }
}

using WireBytes = std::array<std::byte, 2 + 4 * (kMaxAcknowledgementWords - 1)>;  // more than all fields

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
  bool is_sane = true;  // not so large that sums of them are no number any more
  template <typename T>
  void operator()(T& out_value) {
    out_value = bytes.read<T>();
  }
  void operator()(float& out_value) {
    out_value = bytes.f32();
    is_sane = is_sane && std::abs(out_value) <= kMaxOfAnything;
  }
  void operator()(math::Vec3& out_value) {
    for (int axis = 0; axis < 3; ++axis) (*this)(out_value[axis]);
  }
};

std::string_view without_end(std::string_view line) {
  while (line.ends_with('\n')) line.remove_suffix(1);
  return line;
}

// Numbers with a space between; nothing where that is not what it is.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> numbers_of(std::string_view text) {
  std::array<double, kCount> numbers{};
  for (double& number : numbers) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || !(std::abs(number) <= kMaxOfAnything)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return text.empty() ? std::optional(numbers) : std::nullopt;
}

bool is_tick(double tick_s) {
  return tick_s >= kMinTick_s && tick_s <= kMaxTick_s;
}

}  // namespace

std::string line_of(const MoveParameters& t) {
  return fmt::format("{}{} {} {} {} {} {} {} {} {} {} {}\n", kTermsBegin, t.entity, t.tick_s, t.world_tick_s,
                     t.gravity, t.max_velocity, t.friction, t.edge_friction, t.stop_speed, t.accelerate,
                     t.max_speed, t.no_step ? 1 : 0);
}

std::optional<MoveParameters> read_move_parameters(std::string_view line) {
  if (!line.starts_with(kTermsBegin)) return std::nullopt;
  const auto numbers = numbers_of<11>(without_end(line.substr(kTermsBegin.size())));
  if (!numbers) return std::nullopt;
  const auto& n = *numbers;
  if (!(n[0] >= 1 && n[0] <= 65535) || !is_tick(n[1]) || !is_tick(n[2])) return std::nullopt;
  const auto number = [&](std::size_t i) { return static_cast<float>(n[i]); };
  return MoveParameters{.entity = static_cast<std::uint16_t>(n[0]),
                        .tick_s = n[1],
                        .world_tick_s = n[2],
                        .gravity = number(3),
                        .max_velocity = number(4),
                        .friction = number(5),
                        .edge_friction = number(6),
                        .stop_speed = number(7),
                        .accelerate = number(8),
                        .max_speed = number(9),
                        .no_step = n[10] != 0};
}

void write_line(const MoveAcknowledgement& acknowledgement, std::string& out_line) {
  const std::uint16_t flags = flags_of(acknowledgement);
  WireWriter writer;
  writer(flags);
  exchange(writer, acknowledgement, flags);
  out_line = kAcknowledgementBegin;
  append_base64url(base::Bytes(writer.bytes).first(writer.size), out_line);
  out_line += '\n';
}

std::optional<MoveAcknowledgement> read_acknowledgement(std::string_view line) {
  if (!line.starts_with(kAcknowledgementBegin)) return std::nullopt;
  WireBytes bytes;
  const auto size = read_base64url(without_end(line.substr(kAcknowledgementBegin.size())), bytes);
  if (!size) return std::nullopt;
  WireReader reader{base::ByteReader(base::Bytes(bytes).first(*size))};
  const std::uint16_t flags = reader.bytes.u16();
  MoveAcknowledgement a;
  a.is_alive = (flags & kAlive) != 0;
  a.on_ground = (flags & kOnGround) != 0;
  a.is_jump_released = (flags & kJumpReleased) != 0;
  a.is_jumping_out_of_water = (flags & kJumpingOutOfWater) != 0;
  a.is_turned_by_game = (flags & kTurnedByGame) != 0;
  a.is_in_slime = (flags & kSlime) != 0;
  a.is_in_lava = (flags & kLava) != 0;
  if (flags & kRide) a.ride = MoveAcknowledgement::Ride{};
  exchange(reader, a, flags);
  return reader.bytes.ok() && reader.is_sane ? std::optional(a) : std::nullopt;
}

std::size_t read_words(std::string_view line, std::span<std::uint32_t> out_words) {
  if (!line.starts_with(kAcknowledgementBegin) || !line.ends_with('\n')) return 0;
  line.remove_prefix(kAcknowledgementBegin.size());
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

void write_line(std::span<const std::uint32_t> words, std::string& out_line) {
  WireWriter writer;
  writer(static_cast<std::uint16_t>(words[0]));
  for (const std::uint32_t word : words.subspan(1)) writer(word);
  out_line = kAcknowledgementBegin;
  append_base64url(base::Bytes(writer.bytes).first(writer.size), out_line);
  out_line += '\n';
}

std::string format_delta_offer() {
  return std::string(kDeltaOffer);
}

bool is_delta_offer(std::string_view line) {
  return line == kDeltaOffer;
}

std::string command_of(const NumberedPacket& packet) {
  std::string command = fmt::format("{}{}", kNumberBegin, packet.last_move);
  if (!packet.accepts_deltas) return command;
  command += ' ';
  if (!packet.received_snapshot) return command += kNoUpdate;
  append_base64url(std::as_bytes(std::span(&*packet.received_snapshot, 1)), command);
  return command;
}

std::optional<NumberedPacket> read_numbered_packet(std::string_view command) {
  if (!command.starts_with(kNumberBegin)) return std::nullopt;
  command.remove_prefix(kNumberBegin.size());
  NumberedPacket packet;
  const auto [end, failure] =
      std::from_chars(command.data(), command.data() + command.size(), packet.last_move);
  if (failure != std::errc()) return std::nullopt;
  command.remove_prefix(static_cast<std::size_t>(end - command.data()));
  if (command.empty()) return packet;
  if (!command.starts_with(' ')) return std::nullopt;
  command.remove_prefix(1);
  packet.accepts_deltas = true;
  if (command == kNoUpdate) return packet;
  std::array<std::byte, 2> bytes;
  if (command.size() != kUpdateLetters || !read_base64url(command, bytes)) return std::nullopt;
  packet.received_snapshot = base::ByteReader(bytes).u16();
  return packet;
}

}  // namespace temblor::net
