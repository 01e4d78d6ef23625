#include "scripted_player/navigation/level_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace temblor::player {
namespace {

using server::Edict;
using server::Solid;
namespace field = server::field;

// Spawnflags of func_door and of triggers, as in stock Quake.
constexpr int kDoorToggles = 32;
constexpr int kGoldKeyDoor = 8, kSilverKeyDoor = 16;
constexpr int kTriggerNoTouch = 1;
// A train's states are bits of MoverCondition::states; 31 leaves room to compute (1 << states) - 1.
constexpr std::size_t kMaxCorners = 31;

// Reads each edict once, by its classname, and joins linked doors at the end.
class Reader {
 public:
  explicit Reader(server::Game& io_game)
      : game_(io_game), world_(io_game.world()), fields_(io_game.machine().program()) {}

  LevelFacts read() {
    for (std::uint32_t i = 1 + world_.edicts.client_count(); i < world_.edicts.count(); ++i)
      if (!world_.edicts.is_free(vm::EntityIndex{i})) read(world_.edicts[vm::EntityIndex{i}]);
    join_doors();
    std::sort(facts_.stops.begin(), facts_.stops.end(),
              [](const Stop& a, const Stop& b) { return a.number < b.number; });
    return std::move(facts_);
  }

 private:
  std::string text(const Edict& edict, server::Field<vm::StringIndex> f) const {
    return std::string(game_.machine().text(edict[f]));
  }
  std::string text(const Edict& edict, std::string_view name) const {
    return std::string(game_.machine().text(fields_.string(edict, name)));
  }

  void read(const Edict& edict) {
    const std::string name = text(edict, field::kClassName);
    if (name == "func_door" || name == "door")
      read_door(edict);
    else if (name == "func_door_secret")
      read_secret_door(edict);
    else if (name == "func_plat")
      read_lift(edict);
    else if (name == "func_train")
      read_train(edict);
    else if (name == "func_breakable")
      read_breakable(edict);
    else if (name == "func_button")
      read_button(edict);
    else if (name.starts_with("trigger_"))
      read_trigger(edict, name);
    else if (name.starts_with("item_") || name.starts_with("weapon_"))
      add_activator(edict, ActivatorKind::kTake);
    else if (name == "info_notnull")
      read_stop(edict);
    else if (edict.has_flag(server::flag::kMonster))
      add_activator(edict, ActivatorKind::kKill);
    else
      read_obstacle(edict);
  }

  // Returns the entity's brush model as a part without places; nothing if it has no brush model.
  std::optional<MoverPart> find_part(const Edict& edict) const {
    const server::ServerModel* model = world_.find_model(edict);
    if (model == nullptr || !model->brush_model) return std::nullopt;
    return MoverPart{edict.index(),
                     *model->brush_model,
                     world_.level->models[base::to_size(*model->brush_model)].bounds,
                     {}};
  }

  // Adds a mover with one part. `places` are the origins of its states; without any, it is no mover.
  void add_mover(const Edict& edict, Mover mover, std::vector<math::Vec3> places) {
    std::optional<MoverPart> part = find_part(edict);
    if (!part || places.empty()) return;
    mover.states = static_cast<int>(places.size());
    part->places = std::move(places);
    mover.parts.push_back(std::move(*part));
    mover.target_name = text(edict, field::kTargetName);
    mover.description = describe(game_, edict.index());
    facts_.movers.push_back(std::move(mover));
  }

  // A door opens automatically if it has no targetname, is not shot, and needs no key.
  void read_door(const Edict& edict) {
    const int flags = edict.whole(field::kSpawnFlags);
    Mover door{.kind = MoverKind::kDoor};
    door.is_shot = edict[field::kHealth] > 0;
    door.stays_open = fields_.number(edict, "wait") < 0;
    door.toggles = (flags & kDoorToggles) != 0;
    if ((flags & kSilverKeyDoor) != 0) door.key = kSilverKey;
    if ((flags & kGoldKeyDoor) != 0) door.key = kGoldKey;
    door.opens_automatically = text(edict, field::kTargetName).empty() && !door.is_shot && door.key == 0;
    add_mover(edict, door, {fields_.vector(edict, "place_closed"), fields_.vector(edict, "place_open")});
    add_activator(edict, ActivatorKind::kOpen);
  }

  void read_secret_door(const Edict& edict) {
    Mover door{.kind = MoverKind::kSecretDoor};
    door.is_shot = edict[field::kTakeDamage] != 0;
    door.stays_open = (edict.whole(field::kSpawnFlags) & 1) != 0;
    add_mover(edict, door,
              {fields_.vector(edict, "place_closed"), fields_.vector(edict, "place_side"),
               fields_.vector(edict, "place_open")});
    add_activator(edict, ActivatorKind::kOpen);
  }

  void read_lift(const Edict& edict) {
    Mover lift{.kind = MoverKind::kLift};
    lift.opens_automatically = text(edict, field::kTargetName).empty();
    add_mover(edict, lift, {fields_.vector(edict, "place_closed"), fields_.vector(edict, "place_open")});
  }

  // Returns the first entity with that targetname.
  std::optional<vm::EntityIndex> find_named(std::string_view target_name) const {
    if (target_name.empty()) return std::nullopt;
    for (std::uint32_t i = 1; i < world_.edicts.count(); ++i) {
      const vm::EntityIndex index{i};
      if (!world_.edicts.is_free(index) && text(world_.edicts[index], field::kTargetName) == target_name)
        return index;
    }
    return std::nullopt;
  }

  void read_train(const Edict& edict) {
    Mover train{.kind = MoverKind::kTrain};
    train.opens_automatically = text(edict, field::kTargetName).empty();
    std::vector<math::Vec3> places;
    // Follow the targets from corner to corner until one repeats. A train's origin is at a corner minus its
    // mins.
    std::vector<vm::EntityIndex> corners;
    for (std::optional<vm::EntityIndex> corner = first_corner(edict);
         corner && corners.size() < kMaxCorners &&
         std::find(corners.begin(), corners.end(), *corner) == corners.end();) {
      corners.push_back(*corner);
      places.push_back(world_.edicts[*corner][field::kOrigin] - edict[field::kMins]);
      corner = find_named(text(world_.edicts[*corner], field::kTarget));
    }
    add_mover(edict, train, places);
  }

  // The train's target is its next corner. Returns the corner before it if the train stands there, so that
  // the first corner of a path that is no loop is a state, too.
  std::optional<vm::EntityIndex> first_corner(const Edict& edict) const {
    const std::optional<vm::EntityIndex> next = find_named(text(edict, field::kTarget));
    if (!next) return std::nullopt;
    const std::string name = text(world_.edicts[*next], field::kTargetName);
    for (std::uint32_t i = 1; i < world_.edicts.count(); ++i) {
      const vm::EntityIndex index{i};
      if (world_.edicts.is_free(index)) continue;
      const Edict corner = world_.edicts[index];
      if (text(corner, field::kClassName) == "path_corner" && text(corner, field::kTarget) == name &&
          glm::distance(corner[field::kOrigin] - edict[field::kMins], edict[field::kOrigin]) < 1)
        return index;
    }
    return next;
  }

  // Both states have the same position; NavSpace ignores a wall in state 1.
  void read_breakable(const Edict& edict) {
    Mover wall{.kind = MoverKind::kWall};
    wall.is_shot = edict[field::kTakeDamage] != 0;
    add_mover(edict, wall, {edict[field::kOrigin], edict[field::kOrigin]});
  }

  // A button is an obstacle. Its motion is so small that it counts as static.
  void read_button(const Edict& edict) {
    add_activator(edict, edict[field::kHealth] > 0 ? ActivatorKind::kShoot : ActivatorKind::kPress);
    if (const auto part = find_part(edict))
      facts_.static_models.push_back({part->model, edict[field::kOrigin]});
  }

  void read_trigger(const Edict& edict, const std::string& name) {
    const std::string target = text(edict, field::kTarget);
    if (name == "trigger_relay" || name == "trigger_counter") {
      facts_.relays.push_back({target, text(edict, "killtarget"), text(edict, field::kTargetName)});
      return;
    }
    Trigger trigger{.entity = edict.index(), .box = entity_box(edict), .look = edict[field::kMoveDirection]};
    if (name == "trigger_teleport") {
      trigger.kind = TriggerKind::kTeleport;
      trigger.needs_use = !text(edict, field::kTargetName).empty();
      const std::optional<vm::EntityIndex> goal = find_named(target);
      if (!goal) return;
      trigger.destination = world_.edicts[*goal][field::kOrigin];
    } else if (name == "trigger_changelevel") {
      trigger.kind = TriggerKind::kExit;
      trigger.map = text(edict, "map");
    } else if (name == "trigger_hurt") {
      trigger.kind = TriggerKind::kHurt;
      trigger.damage = fields_.number(edict, "dmg");
    } else if (name == "trigger_push") {
      trigger.kind = TriggerKind::kPush;
      // trigger_push multiplies its speed by 10, as in stock Quake.
      trigger.velocity = edict[field::kMoveDirection] * fields_.number(edict, "speed") * 10.0f;
    } else if (name == "trigger_multiple" || name == "trigger_once" || name == "trigger_secret" ||
               name == "trigger_onlyregistered") {
      read_firing_trigger(edict, name, trigger);
    } else {
      return;
    }
    facts_.triggers.push_back(trigger);
  }

  // A trigger that fires its targets: shot, touched, or fired by another entity, or several of these.
  void read_firing_trigger(const Edict& edict, const std::string& name, Trigger& io_trigger) {
    if (name == "trigger_secret") {
      io_trigger.kind = TriggerKind::kSecret;
      facts_.secrets.push_back(edict.index());
    }
    if (edict[field::kHealth] > 0)
      add_activator(edict, ActivatorKind::kShoot);
    else if ((edict.whole(field::kSpawnFlags) & kTriggerNoTouch) == 0)
      add_activator(edict, ActivatorKind::kTouch);
    if (!text(edict, field::kTargetName).empty())
      facts_.relays.push_back(
          {text(edict, field::kTarget), text(edict, "killtarget"), text(edict, field::kTargetName)});
  }

  void add_activator(const Edict& edict, ActivatorKind kind) {
    Activator activator{.kind = kind,
                        .entity = edict.index(),
                        .target = text(edict, field::kTarget),
                        .kill_target = text(edict, "killtarget"),
                        .target_name = text(edict, field::kTargetName),
                        .box = entity_box(edict),
                        .look = edict[field::kMoveDirection],
                        .description = describe(game_, edict.index())};
    // Only triggers check the player's view direction; for buttons and doors the field is their own direction
    // of motion.
    if (kind != ActivatorKind::kTouch) activator.look = math::Vec3(0.0f);
    if (activator.target.empty() && activator.kill_target.empty()) return;
    facts_.activators.push_back(std::move(activator));
  }

  // Any info_notnull whose targetname is not "stop" and a number is something else.
  void read_stop(const Edict& edict) {
    static constexpr std::string_view kName = "stop";
    const std::string name = text(edict, field::kTargetName);
    Stop stop;
    if (!name.starts_with(kName) ||
        std::from_chars(name.data() + kName.size(), name.data() + name.size(), stop.number).ec != std::errc())
      return;
    stop.at = edict[field::kOrigin];
    stop.look_deg = fields_.vector(edict, "mangle");
    if (stop.look_deg == math::Vec3(0.0f)) stop.look_deg = edict[field::kAngles];
    stop.stay_s = fields_.number(edict, "wait");
    stop.impulse = static_cast<int>(edict[field::kImpulse]);
    stop.presses = text(edict, field::kTarget);
    facts_.stops.push_back(std::move(stop));
  }

  // Everything else that is solid: brush models, which a targetname lets game code remove, and boxes that
  // cannot be shot.
  void read_obstacle(const Edict& edict) {
    if (edict.solid() == Solid::kBsp) {
      const std::optional<MoverPart> part = find_part(edict);
      if (part && !text(edict, field::kTargetName).empty()) {
        add_mover(edict, Mover{.kind = MoverKind::kWall}, {edict[field::kOrigin], edict[field::kOrigin]});
      } else if (part) {
        facts_.static_models.push_back({part->model, edict[field::kOrigin]});
      } else {
        facts_.static_boxes.push_back(entity_box(edict));
      }
    } else if (edict.solid() == Solid::kBox && edict[field::kTakeDamage] == 0) {
      facts_.static_boxes.push_back(entity_box(edict));
    }
  }

  // Merges doors with the same leader into one mover. It opens automatically only if each door does, and
  // takes its targetname and key from the first door that has one.
  void join_doors() {
    std::vector<Mover> joined;
    std::vector<vm::EntityIndex> leaders;
    for (Mover& mover : facts_.movers) {
      const Edict edict = world_.edicts[mover.parts[0].entity];
      const vm::EntityIndex leader =
          mover.kind == MoverKind::kDoor ? fields_.entity(edict, "door_leader") : vm::kWorld;
      const auto at = std::find(leaders.begin(), leaders.end(), leader);
      if (leader == vm::kWorld || at == leaders.end()) {
        leaders.push_back(leader == vm::kWorld ? edict.index() : leader);
        joined.push_back(std::move(mover));
        continue;
      }
      Mover& first = joined[static_cast<std::size_t>(at - leaders.begin())];
      first.parts.push_back(std::move(mover.parts[0]));
      first.opens_automatically = first.opens_automatically && mover.opens_automatically;
      first.is_shot |= mover.is_shot;
      if (first.target_name.empty()) first.target_name = mover.target_name;
      if (first.key == 0) first.key = mover.key;
    }
    facts_.movers = std::move(joined);
  }

  server::Game& game_;
  server::GameWorld& world_;
  GameFields fields_;
  LevelFacts facts_;
};

}  // namespace

std::optional<std::uint32_t> GameFields::word(std::string_view name) const {
  const formats::ProgsDefinition* definition = program_->find_field(name);
  if (definition == nullptr) return std::nullopt;
  return static_cast<std::uint32_t>(definition->offset);
}
bool GameFields::has(std::string_view name) const {
  return word(name).has_value();
}
float GameFields::number(const Edict& edict, std::string_view name) const {
  const auto at = word(name);
  return at ? edict[server::Field<float>{*at}] : 0;
}
math::Vec3 GameFields::vector(const Edict& edict, std::string_view name) const {
  const auto at = word(name);
  return at ? edict[server::Field<math::Vec3>{*at}] : math::Vec3(0.0f);
}
vm::EntityIndex GameFields::entity(const Edict& edict, std::string_view name) const {
  const auto at = word(name);
  return at ? edict[server::Field<vm::EntityIndex>{*at}] : vm::kWorld;
}
vm::StringIndex GameFields::string(const Edict& edict, std::string_view name) const {
  const auto at = word(name);
  return at ? edict[server::Field<vm::StringIndex>{*at}] : vm::kEmptyString;
}
vm::FunctionIndex GameFields::function(const Edict& edict, std::string_view name) const {
  const auto at = word(name);
  return at ? edict[server::Field<vm::FunctionIndex>{*at}] : vm::kNoFunction;
}

int LevelFacts::find_mover(vm::EntityIndex entity) const {
  for (std::size_t i = 0; i < movers.size(); ++i)
    for (const MoverPart& part : movers[i].parts)
      if (part.entity == entity) return static_cast<int>(i);
  return -1;
}

LevelFacts read_level_facts(server::Game& io_game) {
  return Reader(io_game).read();
}

std::string class_name(server::Game& io_game, vm::EntityIndex entity) {
  return std::string(io_game.machine().text(io_game.world().edicts.at(entity)[field::kClassName]));
}

std::string describe(server::Game& io_game, vm::EntityIndex entity) {
  const math::Vec3 at = box_center(entity_box(io_game.world().edicts.at(entity)));
  return fmt::format("{} at {:.0f} {:.0f} {:.0f}", class_name(io_game, entity), at.x, at.y, at.z);
}

math::Vec3 box_center(const math::Bounds& box) {
  return (box.mins + box.maxs) * 0.5f;
}

math::Bounds entity_box(const Edict& edict) {
  return {edict[field::kOrigin] + edict[field::kMins], edict[field::kOrigin] + edict[field::kMaxs]};
}

bool boxes_overlap(const math::Bounds& a, const math::Bounds& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.mins[axis] > b.maxs[axis] || b.mins[axis] > a.maxs[axis]) return false;
  return true;
}

}  // namespace temblor::player
