#include "server/builtins/builtin_stage.h"

#include <algorithm>

#include "artgen/small_level.h"
#include "server/builtins/builtin_numbers.h"

namespace temblor::test {
namespace {

using formats::Progs;
using formats::ProgsType;

constexpr std::uint16_t kDone = 0, kCall0 = 51;
constexpr std::uint16_t kReturnGlobal = 1, kCalledGlobal = 100;  // the global that holds the function to call
constexpr std::uint32_t kPlayers = 2;

std::uint32_t add_name(Progs& io_progs, std::string_view name) {
  const auto offset = static_cast<std::uint32_t>(io_progs.strings.size());
  io_progs.strings += name;
  io_progs.strings += '\0';
  return offset;
}

std::string_view name_of_number(int number) {
  for (const BuiltinNumber& known : kStockBuiltins)
    if (known.number == number) return known.name;
  for (const BuiltinNumber& known : kExtensionBuiltins)
    if (known.number == number) return known.name;
  return {};
}

// Functions: the null function; the built-in functions 0 to kMaxBuiltin in order; those with a
// name only; nine that call the function in kCalledGlobal, with 0 to 8 parameters.
constexpr std::size_t kFirstNamed = 2 + kMaxBuiltin;
constexpr std::size_t kFirstCaller = kFirstNamed + std::size(kNamedBuiltins);

void add_functions(Progs& io_progs) {
  io_progs.functions.emplace_back();
  for (int number = 0; number <= kMaxBuiltin; ++number) {
    const std::string_view known = name_of_number(number);
    io_progs.functions.push_back(
        {.first_statement = -number,
         .name =
             add_name(io_progs, known.empty() ? "number_" + std::to_string(number) : std::string(known))});
  }
  for (const std::string_view name : kNamedBuiltins)
    io_progs.functions.push_back({.first_statement = 0, .name = add_name(io_progs, name)});
  io_progs.statements.push_back({.op = kDone});
  for (std::uint16_t count = 0; count <= vm::Machine::kMaxParameters; ++count) {
    io_progs.functions.push_back({.first_statement = static_cast<std::int32_t>(io_progs.statements.size()),
                                  .first_local = kCalledGlobal + 1,
                                  .name = add_name(io_progs, "call_with_" + std::to_string(count)),
                                  .file = add_name(io_progs, "stage.qc")});
    io_progs.statements.push_back(
        {.op = static_cast<std::uint16_t>(kCall0 + count), .operands = {kCalledGlobal, 0, 0}});
    io_progs.statements.push_back({.op = kDone, .operands = {kReturnGlobal, 0, 0}});
  }
}

Progs stage_program() {
  Progs progs;
  progs.crc = formats::kQuakeProgsCrc;
  progs.strings = std::string(1, '\0');
  add_functions(progs);
  const auto field = [&](std::string_view name, ProgsType type, std::uint32_t word) {
    progs.fields.push_back(
        {.type = type, .offset = static_cast<std::uint16_t>(word), .name = add_name(progs, name)});
  };
  field("origin", ProgsType::kVector, server::field::kOrigin.word);
  field("origin_x", ProgsType::kFloat, server::field::kOrigin.word);
  field("classname", ProgsType::kString, server::field::kClassName.word);
  field("health", ProgsType::kFloat, server::field::kHealth.word);
  field("enemy", ProgsType::kEntity, server::field::kEnemy.word);
  field("touch", ProgsType::kFunction, server::field::kTouch.word);
  field("alpha", ProgsType::kFloat, kAlphaField.word);
  field("tag", ProgsType::kString, kTagField.word);
  field("score", ProgsType::kFloat, kScoreField.word);
  field("place", ProgsType::kVector, 108);
  progs.global_words.assign(kCalledGlobal + 1, 0);
  progs.entity_words = kStageEntityWords;
  return progs;
}

std::shared_ptr<const vm::Program> own_program() {
  static const std::shared_ptr<const vm::Program> loaded = vm::Program::load(stage_program()).value();
  return loaded;
}

std::shared_ptr<const world::Level> level() {
  static const std::shared_ptr<const world::Level> made =
      world::make_level(artgen::make_small_level(), "small").value();
  return made;
}

}  // namespace

Stage::Stage(const net::Dialect& dialect, std::shared_ptr<const vm::Program> program)
    : machine(program ? std::move(program) : own_program()),
      world{.level = level(),
            .models = {{},
                       {.name = "maps/small.bsp",
                        .box = level()->world().bounds,
                        .brush_model = world::ModelIndex{0}},
                       {.name = "*1", .box = level()->models[1].bounds, .brush_model = world::ModelIndex{1}}},
            .edicts = server::Edicts(machine, kPlayers),
            .areas = server::Areas(level()->world().bounds),
            .calls = calls},
      outbox(dialect, kPlayers),
      context{.world = world,
              .machine = machine,
              .outbox = outbox,
              .precache = precache,
              .requests = requests,
              .random = random,
              .shared = {.variables = variables, .random = [this] { return random.next_fraction(); }}} {
  context.shared.print = [this](std::string_view text) { printed += text; };
  server::add_builtins(machine, context);
  world.edicts.world().set(server::field::kModelIndex, 1);
  world.edicts.world().set(server::field::kSolid, static_cast<float>(server::Solid::kBsp));
  world.edicts.world().set(server::field::kMoveType, static_cast<float>(server::MoveType::kPush));
}

vm::FunctionIndex Stage::function_of_number(int number) const {
  return base::to_index<vm::FunctionIndex>(static_cast<std::size_t>(1 + number));
}

vm::FunctionIndex Stage::look_up_function(std::string_view name) const {
  for (std::size_t i = 1; i < kFirstCaller; ++i)
    if (const auto index = base::to_index<vm::FunctionIndex>(i);
        machine.program().function_name(index) == name)
      return index;
  CHECK(false, "{}", name);
}

base::Status Stage::call_function(vm::FunctionIndex function, std::size_t parameter_count) {
  machine.set_global_function(vm::GlobalIndex{kCalledGlobal}, function);
  return machine.call(base::to_index<vm::FunctionIndex>(kFirstCaller + parameter_count));
}

vm::EntityIndex Stage::spawn_box(const math::Vec3& origin, server::Solid solid, float half_size) {
  const vm::EntityIndex index = spawn();
  const server::Edict made = edict(index);
  made.set(server::field::kSolid, static_cast<float>(solid));
  made.set(server::field::kOrigin, origin);
  made.set(server::field::kMins, math::Vec3(-half_size));
  made.set(server::field::kMaxs, math::Vec3(half_size));
  made.set(server::field::kSize, math::Vec3(2 * half_size));
  CHECK(server::link(world, index, server::TouchTriggers::kNo).ok());
  return index;
}

void Stage::set_text(vm::EntityIndex index, server::Field<vm::StringIndex> field, std::string_view text) {
  edict(index).set(field, machine.make_string(text).value());
}

}  // namespace temblor::test
