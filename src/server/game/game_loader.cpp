#include "server/game/game_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "assets/localization.h"
#include "base/hash.h"
#include "formats/game/lno.h"
#include "formats/game/progs.h"
#include "formats/levels/entities.h"
#include "server/session/signon.h"
#include "server/session/snapshot.h"

namespace temblor::server {
namespace {

constexpr const char* kProgramName = "progs.dat";

// The flags that other current servers send with protocol 999: positions as whole 32-bit numbers, and angles
// with 16 bits.
constexpr std::uint32_t kRmqFlags = net::kInt32Coord | net::kShortAngle;

net::Dialect make_dialect(net::Protocol protocol) {
  return {protocol, protocol == net::Protocol::kRmq ? kRmqFlags : 0};
}

// `lines`: the line numbers that fteqcc wrote with the program, if any. Those of another program are ignored:
// they only improve error messages.
base::Result<std::shared_ptr<const vm::Program>> make_program(base::Bytes bytes, const std::string& name,
                                                              const base::Result<base::ByteVector>& lines) {
  TRY(formats::Progs progs, formats::read_progs(bytes).with_file(name));
  std::vector<std::uint32_t> line_numbers;
  if (lines.ok()) {
    if (auto read = formats::read_lno(*lines, progs); read.ok()) line_numbers = std::move(read).value();
  }
  return vm::Program::load(std::move(progs), std::move(line_numbers)).with_file(name);
}

// From `file`, or else from the game folders.
base::Result<std::shared_ptr<const vm::Program>> load_program(const vfs::FileSystem& files,
                                                              const std::filesystem::path& file) {
  if (!file.empty()) {
    TRY(const base::ByteVector bytes, vfs::read_disk_file(file));
    std::filesystem::path lines = file;
    return make_program(bytes, file.string(), vfs::read_disk_file(lines.replace_extension(".lno")));
  }
  if (!files.contains(kProgramName))
    return base::error(base::ErrorCode::kNotFound,
                       "there is no {} in the game folders: without the game's code there is no game; "
                       "--progs FILE names one elsewhere",
                       kProgramName);
  TRY(const base::ByteVector bytes, files.read(kProgramName));
  return make_program(bytes, files.describe(kProgramName), files.read("progs.lno"));
}

// Whether protocol 15 would show an entity solid or at normal size that is neither.
bool needs_looks_of_fitzquake(Game& io_game) {
  Edicts& edicts = io_game.world().edicts;
  for (std::uint32_t i = 1; i < edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (edicts.is_free(entity)) continue;
    const LookFields& fields = io_game.look_fields();
    if (sent_alpha(edicts[entity], fields) != 1 || sent_scale(edicts[entity], fields) != 1) return true;
  }
  return false;
}

// Positions of protocols 15 and 666 have 16 bits, the last three of which are eighths of a unit. The bounds
// are a unit wider than the level's faces.
bool needs_wide_positions(const world::Level& level) {
  constexpr float kFarthest = 4096;
  const math::Bounds& bounds = level.world().bounds;
  return glm::any(glm::lessThan(bounds.mins, math::Vec3(-kFarthest))) ||
         glm::any(glm::greaterThan(bounds.maxs, math::Vec3(kFarthest)));
}

// A running game continues in another version of its level if this is equal: light, visibility, and textures
// may differ.
std::uint64_t hash_solids_and_entities(const world::Level& level) {
  std::uint64_t hash = base::hash_with(level.planes.size(), level.models.size());
  const auto add = [&](std::uint64_t value) { hash = base::hash_with(hash, value); };
  const auto add_vec3 = [&](const math::Vec3& v) {
    for (int i = 0; i < 3; ++i) add(base::float_bits(v[i]));
  };
  for (const world::Plane& plane : level.planes) {
    add_vec3(plane.normal);
    add(base::float_bits(plane.distance));
  }
  for (const world::Node& node : level.nodes) {
    add(node.plane);
    for (const world::Child child : node.children) add(static_cast<std::uint64_t>(child.value));
  }
  for (const world::Clipnode& node : level.clipnodes) {
    add(node.plane);
    for (const std::int32_t child : node.children) add(static_cast<std::uint64_t>(child));
  }
  for (const world::Leaf& leaf : level.leaves) add(static_cast<std::uint64_t>(leaf.contents));
  for (const world::Model& model : level.models) {
    add_vec3(model.bounds.mins);
    add_vec3(model.bounds.maxs);
    add_vec3(model.origin);
    add(static_cast<std::uint64_t>(model.head.value));
    for (const std::int32_t head : model.clip_heads) add(static_cast<std::uint64_t>(head));
  }
  return base::hash_with(hash, base::hash_bytes(base::as_bytes(formats::write_entities(level.entities))));
}

// Why this dialect has no room for the game. Empty: it has room.
std::optional<std::string> find_dialect_limit(Game& io_game, std::size_t min_entities) {
  const net::Dialect& dialect = io_game.setup().dialect;
  if (io_game.outbox().dropped() > 0)
    return fmt::format("{} messages of the level's beginning cannot be said", io_game.outbox().dropped());
  if (dialect.protocol != net::Protocol::kRmq && needs_wide_positions(*io_game.setup().level))
    return "the level reaches past 4095 units";
  if (dialect.protocol == net::Protocol::kNetQuake && needs_looks_of_fitzquake(io_game))
    return "entities are translucent or scaled";
  const std::size_t entities = std::max<std::size_t>(io_game.world().edicts.count(), min_entities);
  if (dialect.protocol == net::Protocol::kNetQuake && entities > kMaxEntitiesOfProtocol15)
    return fmt::format("{} entities are more than {}", entities, kMaxEntitiesOfProtocol15);
  const base::Result<base::ByteVector> message = make_level_message(io_game, 0);
  if (!message.ok()) return message.error().what;
  return std::nullopt;
}

}  // namespace

// A game is set up again for each protocol that is tried, because what it has written into its outbox is in
// one protocol's format. Most levels fit the first.
base::Result<LoadedGame> load_game(const GameRequest& request, const ServerVariables& settings,
                                   const GameServices& services) {
  TRY(const std::shared_ptr<const vm::Program> program,
      load_program(services.library.files(), request.program_file));
  TRY(assets::LoadedLevel loaded, assets::load_level(services.library.files(), request.map));
  settings.set_registered(services.library.files().contains(assets::kRegisteredMark));
  LoadedGame result;
  result.notes = std::move(loaded.notes);
  result.entities_file = std::move(loaded.entities_file);
  const auto localization = std::make_shared<const formats::Localization>(
      assets::load_localization(services.library.files(), settings.language(), result.notes));
  constexpr std::array kOldestFirst = {net::Protocol::kNetQuake, net::Protocol::kFitzQuake,
                                       net::Protocol::kRmq};
  for (const net::Protocol protocol : kOldestFirst) {
    const std::optional<net::Protocol> wanted = settings.protocol();
    if (wanted ? *wanted != protocol : protocol < request.oldest_protocol) continue;
    const bool is_last = wanted || protocol == kOldestFirst.back();
    base::Result<std::unique_ptr<Game>> game =
        Game::start({.program = program,
                     .level = loaded.level,
                     .level_hash = hash_solids_and_entities(*loaded.level),
                     .map_name = request.map,
                     .dialect = make_dialect(protocol),
                     .max_clients = request.max_clients,
                     .kind = request.kind,
                     .skill = request.skill,
                     .server_flags = request.server_flags,
                     .seed = request.seed,
                     .tick_s = settings.tick_s(),
                     .settings = settings.physics(),
                     .localization = localization},
                    services);
    // It may have failed because the protocol has too few numbers for models or sounds.
    if (!game.ok() && !is_last) continue;
    if (!game.ok()) return game.error();
    result.game = std::move(game).value();
    const std::optional<std::string> reason = find_dialect_limit(*result.game, request.min_entities);
    if (!reason) break;
    if (is_last)
      result.notes.push_back(
          fmt::format("protocol {} cannot say all of it: {}", static_cast<int>(protocol), *reason));
  }
  for (const std::string& note : result.game->spawn_report().notes) result.notes.push_back(note);
  return result;
}

}  // namespace temblor::server
