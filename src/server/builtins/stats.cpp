// Built-in functions with which game code sends values to the HUD programs of players, as stats of its own.
#include <bit>
#include <cmath>

#include "base/text.h"
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// The number of a stat; nothing, and a warning, for one that belongs to the engine or does not exist.
std::optional<std::uint8_t> stat_number(Call& io_call) {
  const int number = io_call.whole(0);
  if (number >= net::GameStat::kFirst && number <= net::GameStat::kLast)
    return static_cast<std::uint8_t>(number);
  io_call.warn_once(
      fmt::format("stat {} is not {} to {}", number, net::GameStat::kFirst, net::GameStat::kLast));
  return std::nullopt;
}

// Several types count as one word that is sent as it is: entities, fields, functions, and integers.
SentStat::Type stat_type(Call& io_call) {
  constexpr int kText = 1, kFloat = 2, kVector = 3;
  switch (io_call.whole(1)) {
    case kText:
      return SentStat::Type::kText;
    case kFloat:
      return SentStat::Type::kFloat;
    case kVector:
      return SentStat::Type::kVector;
    default:
      return SentStat::Type::kWord;
  }
}

void add_stat(Call& io_call, std::uint8_t number, SentStat stat) {
  const bool is_vector = stat.type == SentStat::Type::kVector;
  if (is_vector) stat.type = SentStat::Type::kFloat;
  for (std::uint32_t i = 0; i < (is_vector ? 3u : 1u) && number + i <= net::GameStat::kLast; ++i, ++stat.word)
    io_call.game.sent_stats[static_cast<std::uint8_t>(number + i)] = stat;
}

// clientstat(number, type, field): from now on each player gets this field of its own entity. A vector takes
// three numbers.
base::Status clientstat(Call& io_call) {
  const std::optional<std::uint8_t> number = stat_number(io_call);
  const SentStat::Type type = stat_type(io_call);
  TRY(const vm::FieldIndex field, io_call.field(2));
  const std::uint32_t words = io_call.machine.program().progs().entity_words;
  const auto word = static_cast<std::uint32_t>(field);
  if (type == SentStat::Type::kVector && words - word < 3)
    return io_call.error("parameter 3 is not a vector");
  if (number) add_stat(io_call, *number, {.type = type, .word = word, .is_global = false});
  return base::Ok{};
}

// globalstat(number, type, name): the same with a global, found by its name.
base::Status globalstat(Call& io_call) {
  const std::optional<std::uint8_t> number = stat_number(io_call);
  const formats::ProgsDefinition* const global = io_call.machine.program().find_global(io_call.text(2));
  if (global == nullptr) {
    io_call.warn_once(fmt::format("there is no global \"{}\"", base::quotable(io_call.text(2))));
    return base::Ok{};
  }
  const std::uint32_t word = global->offset;
  const SentStat::Type type = stat_type(io_call);
  if (type == SentStat::Type::kVector && io_call.machine.global_words().size() - word < 3)
    return io_call.error("parameter 3 is not a vector");
  if (number) add_stat(io_call, *number, {.type = type, .word = word, .is_global = true});
  return base::Ok{};
}

}  // namespace

net::StatValue read_sent_stat(const SentStat& stat, const vm::Machine& machine, vm::EntityIndex player) {
  const std::uint32_t word =
      stat.is_global ? machine.global_words()[stat.word] : machine.entity(player)[stat.word];
  switch (stat.type) {
    case SentStat::Type::kText:
      return std::string(machine.text(vm::StringIndex{word}).substr(0, net::GameStat::kMaxTextChars));
    case SentStat::Type::kFloat:
    case SentStat::Type::kVector: {
      const auto value = std::bit_cast<float>(word);
      return std::isfinite(value) ? value : 0.0f;
    }
    case SentStat::Type::kWord:
      break;
  }
  return static_cast<std::int32_t>(word);
}

std::span<const BuiltinEntry> stat_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {232, "clientstat", clientstat},
      {0, "addstat", clientstat},
      {0, "SV_AddStat", clientstat},
      {233, "globalstat", globalstat},
  };
  return kEntries;
}

}  // namespace temblor::server
