// A level with everything that game code puts into it: monsters, items, torches. A server plays the level
// for a second, with one player at its start, and the scene is made as for that player, but of the whole
// level.
//
//   Server -- LoopbackNetwork --> Connection --> ClientState --> Presentation --> Scene
//      \------- entities that the player does not see -----^
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/level/level_loading.h"
#include "base/result.h"
#include "client/prediction/prediction.h"
#include "client/session/connection.h"
#include "client/view/presentation.h"
#include "net/transport/loopback.h"
#include "server/server.h"

namespace temblor::app {

class RunningLevel {
 public:
  // `program`: the game's code; empty: progs.dat of the game directories. Skill and kind of game are those of
  // `rules`. The level and the rules must outlive the result. Fails without game code, or if that fails.
  static base::Result<std::unique_ptr<RunningLevel>> start(const LoadedMap& loaded,
                                                           const std::filesystem::path& program,
                                                           const server::ServerVariables& rules,
                                                           const client::PresentationSettings& presentation);

  // The scene as the player sees it, without weapon and status bar. Valid while this object lives.
  const render::Scene& scene() const { return presentation_.scene(); }
  const world::LightStylePatterns& light_styles() const { return connection_.state().game().light_styles; }
  // Returns the problems since the last call, such as missing models, one line each.
  std::vector<std::string> take_notes() { return presentation_.take_notes(); }

 private:
  RunningLevel(const LoadedMap& loaded, const std::filesystem::path& program,
               const server::ServerVariables& rules, const client::PresentationSettings& presentation);
  base::Status begin();
  base::Status step();
  base::Status check_game() const;
  base::Error make_error(std::string what) const;
  base::Status add_unseen_entities();

  const LoadedMap& loaded_;
  client::PresentationSettings settings_;
  std::string console_;  // everything that the server printed
  net::LoopbackNetwork network_;
  std::unique_ptr<server::Server> server_;
  client::Connection connection_;
  // Tells the place of the player more precisely than the server's messages do.
  client::Prediction prediction_;
  client::Presentation presentation_;
  double now_s_ = 0;
};

}  // namespace temblor::app
