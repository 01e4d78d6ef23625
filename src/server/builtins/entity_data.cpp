// DP_QC_ENTITYDATA: fields of entities as text, by their number in the program. entityfieldname() and
// entityfieldtype() (builtins/families/functions.cpp) describe them.
#include "server/builtins/families.h"
#include "server/game/field_text.h"

namespace temblor::server {
namespace {

// The field that parameter 0 numbers; nullptr: there is none.
const formats::ProgsDefinition* find_numbered_field(const Call& call) {
  const auto& fields = call.machine.program().progs().fields;
  const int i = call.whole(0);
  return i >= 0 && static_cast<std::size_t>(i) < fields.size() ? &fields[static_cast<std::size_t>(i)]
                                                               : nullptr;
}

// getentityfieldstring(number, entity): empty without such a field.
base::Status getentityfieldstring(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(1));
  const formats::ProgsDefinition* const field = find_numbered_field(io_call);
  if (field == nullptr) return io_call.return_text("");
  const auto words = io_call.world.edicts[entity].words().subspan(field->offset);
  if (field->type == formats::ProgsType::kString)
    return io_call.return_text(io_call.machine.text(vm::StringIndex{words[0]}));
  return io_call.return_text(value_text(io_call.machine, *field, words));
}

// putentityfieldstring(number, entity, text): returns whether the text was a value of the field.
base::Status putentityfieldstring(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(1));
  if (io_call.world.edicts.is_free(entity))
    return io_call.error("entity {} was removed", base::to_size(entity));
  const formats::ProgsDefinition* const field = find_numbered_field(io_call);
  if (field == nullptr) return io_call.return_number(0);
  const base::Status set = set_value(io_call.machine, *field, std::string(io_call.text(2)),
                                     io_call.world.edicts[entity].words().subspan(field->offset));
  if (!set.ok() && set.error().code != base::ErrorCode::kUsage) return set;
  return io_call.return_number(set.ok() ? 1 : 0);
}

}  // namespace

std::span<const BuiltinEntry> entity_data_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {499, "getentityfieldstring", getentityfieldstring},
      {500, "putentityfieldstring", putentityfieldstring},
  };
  return kEntries;
}

}  // namespace temblor::server
