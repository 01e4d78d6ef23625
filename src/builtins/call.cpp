#include "builtins/call.h"

#include <algorithm>

#include "base/text.h"
#include "builtins/families/families.h"
#include "builtins/families/text_to_number.h"

namespace temblor::builtins {
namespace {

constexpr std::span<const Entry> (*kFamilies[])() = {
    number_builtins, vector_builtins, text_builtins, comparison_builtins, conversion_builtins,
    token_builtins,  buffer_builtins, file_builtins, variable_builtins,   function_builtins};

constexpr std::string_view kExtensions[] = {
    "DP_QC_SINCOSSQRTPOW",
    "DP_QC_MINMAXBOUND",
    "DP_QC_RANDOMVEC",
    "DP_QC_ETOS",
    "DP_QC_SPRINTF",
    "DP_REGISTERCVAR",
    "DP_QC_CVAR_STRING",
    "DP_QC_CVAR_DEFSTRING",
    "DP_QC_CVAR_TYPE",
    "DP_QC_CVAR_DESCRIPTION",
    "DP_QC_ASINACOSATANATAN2TAN",
    "DP_QC_STRINGBUFFERS",
    "DP_QC_STRINGCOLORFUNCTIONS",
    "DP_QC_STRING_CASE_FUNCTIONS",
    "DP_QC_STRREPLACE",
    "DP_QC_TOKENIZEBYSEPARATOR",
    "DP_QC_TOKENIZE_CONSOLE",
    "DP_QC_UNLIMITEDTEMPSTRINGS",
    "DP_QC_URI_ESCAPE",
    "DP_QC_GETTIME",
    "DP_QC_CRC16",
    "FTE_STRINGS",
    "FTE_QC_STOI",
    "EXT_BITSHIFT",
};

}  // namespace

base::Result<vm::EntityIndex> Call::entity(int i) const {
  const base::Result<vm::EntityIndex> value = machine.parameter_entity(i);
  if (!value.ok()) return error("parameter {} is not an entity", i + 1);
  return *value;
}

base::Result<vm::FieldIndex> Call::field(int i) const {
  const base::Result<vm::FieldIndex> value = machine.parameter_field(i);
  if (!value.ok()) return error("parameter {} is not a field", i + 1);
  return *value;
}

std::string Call::joined_text(int first) const {
  std::string joined;
  for (int i = first; i < machine.parameter_count(); ++i) joined += text(i);
  return joined;
}

// Text variables count, too, because registercvar() makes all of a program's variables text.
float Call::variable(std::string_view variable_name) const {
  const command::Variable* found = context.variables.find(variable_name);
  if (found == nullptr) return 0;
  const bool is_text = found->type == command::VariableType::kText;
  return is_text ? number_from(found->text) : static_cast<float>(found->number);
}

// The built-in function itself is on the trace with statement 0.
std::string Call::call_site() const {
  const std::vector<vm::TraceEntry> trace = machine.current_trace();
  const auto caller = std::find_if(trace.begin(), trace.end(),
                                   [](const vm::TraceEntry& entry) { return entry.statement != 0; });
  if (caller == trace.end()) return "";
  return fmt::format(", in {}", machine.program().describe_place(caller->function, caller->statement));
}

void Call::warn_once(const std::string& text) const {
  // Bounds the memory for programs whose warnings differ each time.
  constexpr std::size_t kMaxWarnings = 256;
  if (context.warned.size() < kMaxWarnings && context.warned.insert(text).second)
    print(fmt::format("builtin {}: {}\n", name_, text));
}

base::Status Call::return_text(std::string_view text) const {
  TRY(const vm::StringIndex string, machine.make_string(text));
  machine.return_string(string);
  return base::Ok{};
}

void add_builtins(vm::Machine& io_machine, Context& io_context) {
  for (const auto family : kFamilies)
    for (const Entry& entry : family()) {
      const auto run = [&io_context, &entry](vm::Machine& io_running) {
        Call call(io_context, io_running, entry.name);
        return entry.function(call);
      };
      // Error messages contain this name.
      if (entry.number > 0) io_machine.add_builtin(entry.number, fmt::format("builtin {}", entry.name), run);
      // Newer programs declare functions by name alone.
      io_machine.add_named_builtin(entry.name, run);
    }
}

bool has_extension(const Context& context, std::string_view name) {
  if (base::equal_ignoring_case(name, "FRIK_FILE")) return context.files.can_write();
  if (base::equal_ignoring_case(name, "DP_QC_WHICHPACK")) return static_cast<bool>(context.find_pack);
  return std::any_of(std::begin(kExtensions), std::end(kExtensions),
                     [&](std::string_view known) { return base::equal_ignoring_case(name, known); });
}

}  // namespace temblor::builtins
