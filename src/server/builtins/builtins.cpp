// The list of all built-in functions and extensions.
#include "server/builtins/builtins.h"

#include <algorithm>

#include "base/text.h"
#include "server/builtins/families.h"
#include "server/system_globals.h"

namespace temblor::server {
namespace {

constexpr std::span<const BuiltinEntry> (*kFamilies[])() = {
    vector_builtins,           entity_builtins,        finding_builtins,     tracing_builtins,
    aiming_builtins,           movement_builtins,      precache_builtins,    effect_builtins,
    printing_builtins,         writing_builtins,       command_builtins,     level_builtins,
    debugging_builtins,        rerelease_builtins,     bot_builtins,         stat_builtins,
    temporary_effect_builtins, debug_drawing_builtins, entity_data_builtins,
};

// Extensions that every server has. has_extension() knows those that depend on its settings.
constexpr std::string_view kExtensions[] = {
    "DP_QC_TRACEBOX",       "DP_QC_FINDFLOAT",     "DP_QC_COPYENTITY",     "DP_QC_FINDCHAIN",
    "DP_QC_FINDCHAINFLOAT", "DP_QC_FINDFLAGS",     "DP_QC_FINDCHAINFLAGS", "DP_TE_STANDARDEFFECTBUILTINS",
    "DP_QC_VECTORVECTORS",  "DP_QC_NUM_FOR_EDICT", "DP_QC_ENTITYDATA",     "DP_SV_POINTSOUND",
    "FTE_QC_CHECKPVS",
};

}  // namespace

void add_builtins(vm::Machine& io_machine, BuiltinContext& io_context) {
  const base::Status fits = check_system_definitions(io_machine.program());
  CHECK(fits.ok(), "{}", fits.error().message());
  builtins::add_builtins(io_machine, io_context.shared);
  for (const auto family : kFamilies)
    for (const BuiltinEntry& entry : family()) {
      const auto run = [&io_context, &entry](vm::Machine&) {
        Call call(io_context, entry.name);
        return entry.function(call);
      };
      // Error messages contain this name.
      if (entry.number > 0) io_machine.add_builtin(entry.number, fmt::format("builtin {}", entry.name), run);
      // Newer programs declare functions by name alone.
      io_machine.add_named_builtin(entry.name, run);
    }
}

bool has_extension(const BuiltinContext& context, std::string_view name) {
  if (builtins::has_extension(context.shared, name)) return true;
  if (base::equal_ignoring_case(name, "KRIMZON_SV_PARSECLIENTCOMMAND"))
    return static_cast<bool>(context.client_command);
  if (base::equal_ignoring_case(name, "DP_SV_BOTCLIENT") ||
      base::equal_ignoring_case(name, "DP_SV_DROPCLIENT"))
    return static_cast<bool>(context.bot_services.spawn_bot);
  return std::any_of(std::begin(kExtensions), std::end(kExtensions),
                     [&](std::string_view known) { return base::equal_ignoring_case(name, known); });
}

}  // namespace temblor::server
