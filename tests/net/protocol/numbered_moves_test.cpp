#include "net/protocol/numbered_moves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.h"

namespace temblor::net {
namespace {

MoveAcknowledgment some_acknowledgment(test::Random& io_random) {
  const auto coin = [&] { return io_random.chance(0.5); };
  MoveAcknowledgment a{.number = static_cast<std::uint32_t>(io_random.bits()),
                       .origin = io_random.in_cube(4000),
                       .velocity = io_random.in_cube(2000),
                       .angles_deg = io_random.in_cube(180),
                       .move_type = static_cast<std::uint8_t>(io_random.below(13)),
                       .water_level = static_cast<std::uint8_t>(io_random.below(4)),
                       .is_in_slime = coin(),
                       .is_in_lava = coin(),
                       .is_alive = coin(),
                       .on_ground = coin(),
                       .is_jump_released = coin(),
                       .is_jumping_out_of_water = coin(),
                       .is_turned_by_game = coin(),
                       .is_crouching = coin(),
                       .ground = static_cast<std::uint16_t>(io_random.below(65536))};
  if (coin()) a.punch_deg = io_random.in_cube(10);
  if (a.is_jumping_out_of_water) a.water_jump_velocity = math::Vec2(io_random.in_cube(50));
  if (coin()) a.teleport_time_s = static_cast<float>(io_random.uniform(0, 2));
  if (coin()) a.own_gravity = 0.25f;
  if (coin()) a.ride = {io_random.in_cube(4000), io_random.in_cube(400), 1.5f};
  return a;
}

TEST(NumberedMoves, AcknowledgmentsRoundTripExactly) {
  test::Random random(3);
  std::string line;
  for (int i = 0; i < 1000; ++i) {
    const MoveAcknowledgment sent = some_acknowledgment(random);
    write_acknowledgment(sent, line);
    EXPECT_EQ(read_acknowledgment(line), sent) << line;
  }
}

TEST(NumberedMoves, ParametersRoundTripExactly) {
  const MoveParameters parameters{.entity = 16,
                                  .tick_s = 1.0 / 72,
                                  .world_tick_s = 0.05,
                                  .physics = {.gravity = 100.1f, .no_step = true}};
  EXPECT_EQ(read_move_parameters(format_move_parameters(parameters)), parameters);
}

// Stock consoles ignore these lines.
TEST(NumberedMoves, LinesAreConsoleComments) {
  test::Random random(4);
  std::string line;
  for (int i = 0; i < 200; ++i) {
    write_acknowledgment(some_acknowledgment(random), line);
    EXPECT_LT(line.size(), 160u) << "in each datagram";
    EXPECT_TRUE(line.starts_with("//")) << line;
    EXPECT_EQ(line.find_first_of("\n;\""), line.size() - 1) << line;
  }
  EXPECT_TRUE(format_move_parameters({}).starts_with("//"));
  EXPECT_EQ(format_move_parameters({}).find_first_of("\n;\""), format_move_parameters({}).size() - 1);
}

TEST(NumberedMoves, RejectsInvalidLines) {
  test::Random random(5);
  std::string line;
  write_acknowledgment(some_acknowledgment(random), line);
  for (std::size_t size = 0; size < line.size() - 5; ++size)
    EXPECT_FALSE(read_acknowledgment(line.substr(0, size))) << size;
  EXPECT_FALSE(read_acknowledgment("//a ????????????????????????????????????????????????????\n"));
  MoveAcknowledgment endless;
  endless.velocity.y = std::numeric_limits<float>::infinity();
  write_acknowledgment(endless, line);
  EXPECT_FALSE(read_acknowledgment(line));
  EXPECT_FALSE(read_move_parameters("//temblor moves\n"));
  EXPECT_FALSE(read_move_parameters("//temblor moves 1 0 0.01 800 2000 4 2 100 10 320 0\n"))
      << "tick of zero length";
  EXPECT_FALSE(read_move_parameters("//temblor moves 1 0.01 nan 800 2000 4 2 100 10 320 0\n"));
  EXPECT_FALSE(read_move_parameters("//temblor moves 1 0.01 0.01 800 2000 4 2 100 10 320 0 7\n"));
  EXPECT_FALSE(read_move_parameters("// a comment\n"));
}

TEST(NumberedMoves, PacketHeadsRoundTrip) {
  for (const std::uint32_t number : {0u, 7u, 4294967295u}) {
    EXPECT_EQ(format_numbered_packet({.last_move = number}), "tm " + std::to_string(number));
    EXPECT_EQ(read_numbered_packet(format_numbered_packet({.last_move = number})),
              NumberedPacket{.last_move = number});
    const NumberedPacket none{.last_move = number, .accepts_deltas = true};
    EXPECT_EQ(read_numbered_packet(format_numbered_packet(none)), none);
    for (const int update : {0, 1, 255, 256, 65535}) {
      const auto known = static_cast<std::uint16_t>(update);
      const NumberedPacket packet{.last_move = number, .accepts_deltas = true, .received_snapshot = known};
      EXPECT_EQ(read_numbered_packet(format_numbered_packet(packet)), packet) << known;
      EXPECT_EQ(format_numbered_packet(packet).size(),
                format_numbered_packet({.last_move = number}).size() + 4);
    }
  }
  for (const char* text : {"tm", "tm ", "tm 4294967296", "tm -1", "tm 1 2", "tmx 1", "say tm 1", "tm 1 ",
                           "tm 1 --", "tm 1 AAAA", "tm 1 A?A", "tm 1 AAA 1"})
    EXPECT_FALSE(read_numbered_packet(text)) << text;
}

TEST(NumberedMoves, AcknowledgmentWordsRoundTrip) {
  test::Random random(7);
  std::array<std::uint32_t, kMaxAcknowledgmentWords> words{};
  std::string line, again;
  for (int i = 0; i < 1000; ++i) {
    write_acknowledgment(some_acknowledgment(random), line);
    const std::size_t count = read_acknowledgment_words(line, words);
    ASSERT_GE(count, 12u) << line;
    write_acknowledgment_words(std::span(words).first(count), again);
    ASSERT_EQ(again, line);
  }
  for (const char* text : {"", "//a ", "//a AAAA", "//a A\n", "//a AAAA\n", "//b AAA\n", "//a ???\n"})
    EXPECT_EQ(read_acknowledgment_words(text, words), 0u) << text;
  EXPECT_EQ(read_acknowledgment_words("//a " + std::string(200, 'A') + "\n", words), 0u) << "too many words";
  for (std::uint32_t& word : words) word = 0xffffffff;
  write_acknowledgment_words(words, line);
  EXPECT_EQ(read_acknowledgment_words(line, words), words.size()) << "maximum number of words";
}

}  // namespace
}  // namespace temblor::net
