#include "lockstep/play_replay.h"

#include "net/protocol/demo_writer.h"

namespace temblor::lockstep {
namespace {

// The view follows the player's moves.
void record(Simulation& io_simulation, std::size_t player, const ClientInput& input,
            math::Vec3& io_view_angles_deg, net::DemoWriter& io_demo) {
  if (!input.moves.empty()) io_view_angles_deg = input.moves.back().angles_deg;
  for (const MessageForClient& message : io_simulation.take_messages(player))
    io_demo.add(io_view_angles_deg, message.bytes);
}

}  // namespace

base::Result<PlayedReplay> play_replay(const Replay& replay, const SimulationSetup& setup,
                                       std::string_view program_version, std::size_t player) {
  if (player >= replay.start.players)
    return base::error(base::ErrorCode::kUsage, "the replay has no player {}", player + 1);
  TRY_STATUS(check_files(setup.library, setup.program_file, program_version, replay.start));
  TRY(const std::unique_ptr<Simulation> simulation, Simulation::begin(setup, replay.start));
  net::DemoWriter demo;
  math::Vec3 view_angles_deg(0.0f);
  PlayedReplay played;
  played.last_hash = simulation->game().state_hash();
  for (const std::vector<ClientInput>& inputs : replay.ticks) {
    TRY_STATUS(simulation->play_tick(inputs));
    record(*simulation, player, inputs[player], view_angles_deg, demo);
    for (std::size_t other = 0; other < inputs.size(); ++other) simulation->take_messages(other);
    played.last_hash = simulation->game().state_hash();
    if (static_cast<std::uint8_t>(played.last_hash) != replay.hash_bytes[played.ticks])
      return base::malformed(
          "tick {} of the replay ({:.1f} s): the game is another one than the recorded one", played.ticks,
          played.ticks * simulation->tick_s());
    ++played.ticks;
  }
  played.game_s = played.ticks * simulation->tick_s();
  if (played.last_hash != replay.last_hash && played.ticks > 0)
    return base::malformed("the replay ends in another state than the recorded game");
  played.demo = std::move(demo).finish();
  return played;
}

}  // namespace temblor::lockstep
