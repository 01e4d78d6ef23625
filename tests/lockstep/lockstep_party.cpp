#include "lockstep/lockstep_party.h"

#include <fmt/format.h>

#include <algorithm>

#include "support/game_data.h"

namespace temblor::test {
namespace {

constexpr double kStep_s = 1.0 / 72;

}  // namespace

platform::Address LockstepParty::host_address() {
  return platform::ip4_address({10, 0, 0, 1}, 26000);
}

LockstepParty::LockstepParty(const PartyOptions& options) : network_(options.conditions, options.seed) {
  folder_.folder().write("id1/progs/player.mdl", "a server asks only whether it is there");
  folder_.folder().write("id1/progs.dat", read_file(TEMBLOR_GAME_PROGRAM));
  auto files = vfs::FileSystem::open(folder_.path(), {});
  CHECK(files.ok(), "{}", files.error().message());
  library_ = std::make_unique<assets::Library>(std::move(*files));
  start_ = {.program_version = kVersion,
            .map = "small",
            .seed = options.seed,
            .players = static_cast<std::uint8_t>(options.players),
            .slots = static_cast<std::uint8_t>(std::max(options.players, options.slots)),
            .delay_ticks = options.delay_ticks,
            .variables = options.variables};
  const base::Status hashed = lockstep::hash_files(*library_, {}, start_);
  CHECK(hashed.ok(), "{}", hashed.error().message());
  add_member(lockstep::LockstepGame::host(setup(), start_, network_.open(host_address())));
  for (std::size_t guest = 1; guest < options.players; ++guest) add_member(make_guest(guest));
}

std::unique_ptr<lockstep::LockstepGame> LockstepParty::make_guest(std::uint64_t id,
                                                                  const std::string& version) {
  const auto last_byte = static_cast<std::uint8_t>(id + 1);
  return lockstep::LockstepGame::join(setup(), version,
                                      network_.open(platform::ip4_address({10, 0, 0, last_byte}, 4000)),
                                      host_address(), id);
}

void LockstepParty::add_member(std::unique_ptr<lockstep::LockstepGame> game) {
  Member& member = members_.emplace_back();
  member.game = std::move(game);
  member.client = std::make_unique<client::Connection>(
      member.game->open_client_socket(),
      client::PlayerSettings{fmt::format("player{}", members_.size()), 4, 7});
  member.client->connect(member.game->client_server(), now_s_);
}

void LockstepParty::run(double seconds, const std::vector<net::Move>& moves) {
  const double until_s = now_s_ + seconds;
  while (now_s_ < until_s) {
    now_s_ += kStep_s;
    network_.advance_to(now_s_);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      Member& member = members_[i];
      if (!member.game) continue;
      member.client->update(now_s_);
      if (i < moves.size()) member.client->send_move(moves[i]);
      for (const std::string& text : member.client->state().events().prints) member.prints += text;
      member.client->state().events().clear();
      member.game->step(now_s_);
    }
  }
}

bool LockstepParty::run_until_playing() {
  const auto all_play = [&] {
    return std::ranges::all_of(members_, [](const Member& m) { return !m.game || m.client->is_playing(); });
  };
  for (int i = 0; i < 100 && !all_play(); ++i) run(0.1);
  return all_play();
}

}  // namespace temblor::test
