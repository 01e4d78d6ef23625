#include "server/session/snapshot.h"

#include <cmath>

#include "base/check.h"
#include "net/protocol/message_writer.h"
#include "server/physics/crouch.h"

namespace temblor::server {
namespace {

constexpr float kMovedBy_units = 0.1f;  // smaller moves are not sent
constexpr float kStockThink_s = 0.1f;   // the time between two animation frames that clients assume

template <typename T>
// Empty: the client already knows the value from the baseline.
std::optional<T> if_changed(T now, T before) {
  return now == before ? std::nullopt : std::optional<T>(now);
}

// A `step` entity is interpolated by clients from one think to the next. The time of the next think is sent
// only if it is not the usual one.
net::EntityUpdate make_update(const net::Baseline& now, const Edict& edict, const EdictState& state,
                              double time_s) {
  const net::Baseline& before = state.baseline;
  net::EntityUpdate update;
  update.number = static_cast<std::uint16_t>(base::to_size(edict.index()));
  update.model = if_changed(now.model, before.model);
  update.frame = if_changed(now.frame, before.frame);
  update.colormap = if_changed(now.colormap, before.colormap);
  update.skin = if_changed(now.skin, before.skin);
  update.effects = if_changed(sent_u8(edict[field::kEffects]), std::uint8_t{0});
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (std::abs(now.origin[axis] - before.origin[axis]) > kMovedBy_units)
      update.origin[i] = now.origin[axis];
    update.angles_deg[i] = if_changed(now.angles_deg[axis], before.angles_deg[axis]);
  }
  update.alpha = if_changed(now.alpha, before.alpha);
  update.scale = if_changed(now.scale, before.scale);
  update.step = edict.move_type() == MoveType::kStep;
  const float until_think_s = edict[field::kNextThink] - static_cast<float>(time_s);
  if (update.step && until_think_s > 0 && until_think_s < 1 &&
      std::abs(until_think_s - kStockThink_s) > 0.002f)
    update.next_think_s = until_think_s;
  return update;
}

// Leaves out an update that cannot be written.
void add_update(const net::EntityUpdate& update, const net::Dialect& dialect, Snapshot::Entity entity,
                Snapshot& io_snapshot) {
  entity.begin = io_snapshot.bytes.size();
  if (!net::write_message(update, dialect, io_snapshot.bytes).ok()) return;
  const bool has_words = net::parse_entity_update(base::Bytes(io_snapshot.bytes.view()).subspan(entity.begin),
                                                  dialect, io_snapshot.words.emplace_back());
  CHECK(has_words, "a written entity can be read back");
  entity.end = io_snapshot.bytes.size();
  io_snapshot.entities.push_back(entity);
}

}  // namespace

// Players without a model are included, because their own client needs them (for the origin of its view).
void take_snapshot(GameWorld& io_world, const vm::Machine& machine, const LookFields& fields,
                   const net::Dialect& dialect, Snapshot& io_snapshot) {
  io_snapshot.entities.clear();
  io_snapshot.words.clear();
  io_snapshot.bytes.truncate(0);
  io_snapshot.unnumbered = 0;
  const bool is_stock = dialect.protocol == net::Protocol::kNetQuake;
  for (std::uint32_t number = 1; number < io_world.edicts.count(); ++number) {
    const vm::EntityIndex index{number};
    const EdictState& state = io_world.edicts.state(index);
    if (state.is_free) continue;
    const Edict edict = io_world.edicts[index];
    const bool is_player = number <= io_world.edicts.client_count();
    const bool is_visible = edict[field::kModelIndex] > 0 && !machine.text(edict[field::kModel]).empty();
    if (!is_visible && !is_player) continue;
    if (is_stock && number >= kMaxEntitiesOfProtocol15) {
      ++io_snapshot.unnumbered;
      continue;
    }
    const float drop = is_player && is_visible ? find_crouched_drop(io_world, edict) : 0;
    net::Baseline now = make_baseline(edict, fields);
    Snapshot::Entity entity{.index = index,
                            .owner = edict[field::kOwner],
                            .is_visible = is_visible,
                            .viewers = drop > 0 ? Snapshot::Viewers::kItself : Snapshot::Viewers::kAll,
                            .origin = edict[field::kOrigin]};
    add_update(make_update(now, edict, state, io_world.time_s), dialect, entity, io_snapshot);
    if (drop == 0) continue;
    now.origin.z -= drop;
    entity.viewers = Snapshot::Viewers::kOthers;
    add_update(make_update(now, edict, state, io_world.time_s), dialect, entity, io_snapshot);
  }
}

}  // namespace temblor::server
