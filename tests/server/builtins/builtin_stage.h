// A level, a machine with a program that calls any built-in function, and everything that these act on; two
// player slots.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "net/protocol/dialects.h"
#include "server/builtins/builtins.h"
#include "server/system_globals.h"

namespace temblor::test {

inline constexpr math::Vec3 kHall(256, 256, 64);  // in the open
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Fields of the stage's program, after the system's.
constexpr server::Field<float> kAlphaField{105}, kScoreField{107};
constexpr server::Field<vm::StringIndex> kTagField{106};
constexpr std::uint32_t kStageEntityWords = 111;

// Records the calls of game functions that built-in functions cause, and returns `status` for each.
class NotedCalls final : public server::GameCalls {
 public:
  struct Noted {
    vm::FunctionIndex function;
    vm::EntityIndex self, other;
    bool operator==(const Noted&) const = default;
  };
  base::Status call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                    double) override {
    if (function != vm::kNoFunction) noted.push_back({function, self, other});
    return base::Ok{};
  }
  std::vector<Noted> noted;
};

// A value that is passed to a built-in function as a raw word, such as a field.
struct RawWord {
  std::uint32_t word;
};

class Stage {
 public:
  // Without a program, the stage makes one whose functions are the built-in functions, for call().
  explicit Stage(const net::Dialect& dialect = {}, std::shared_ptr<const vm::Program> program = nullptr);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  // Calls a function by its name with these parameters: float, Vec3, text, EntityIndex, FieldIndex.
  template <typename... Parameters>
  base::Status call(std::string_view name, const Parameters&... parameters) {
    int i = 0;
    (set_parameter(i++, parameters), ...);
    return call_function(look_up_function(name), sizeof...(parameters));
  }
  // The same, but the call must succeed.
  template <typename... Parameters>
  void run(std::string_view name, const Parameters&... parameters) {
    const base::Status status = call(name, parameters...);
    EXPECT_TRUE(status.ok()) << name << ": " << status.error().message();
  }
  // Calls a function, and reads its result as this type.
  template <typename... Parameters>
  float number(std::string_view name, const Parameters&... parameters) {
    run(name, parameters...);
    return machine.returned_float();
  }
  template <typename... Parameters>
  math::Vec3 vector(std::string_view name, const Parameters&... parameters) {
    run(name, parameters...);
    return machine.returned_vector();
  }
  template <typename... Parameters>
  std::string text(std::string_view name, const Parameters&... parameters) {
    run(name, parameters...);
    return std::string(machine.text(machine.returned_string()));
  }
  template <typename... Parameters>
  vm::EntityIndex entity(std::string_view name, const Parameters&... parameters) {
    run(name, parameters...);
    return machine.returned_entity();
  }
  // The message of the error; empty if the call succeeded.
  template <typename... Parameters>
  std::string error(std::string_view name, const Parameters&... parameters) {
    const base::Status status = call(name, parameters...);
    return status.ok() ? "" : status.error().message();
  }

  // The program's function for a built-in function's name.
  vm::FunctionIndex look_up_function(std::string_view name) const;
  vm::FunctionIndex function_of_number(int number) const;
  base::Status call_function(vm::FunctionIndex function, std::size_t parameter_count);

  server::Edict edict(vm::EntityIndex index) { return world.edicts[index]; }
  vm::EntityIndex spawn() { return world.edicts.spawn(world.time_s).value(); }
  // A linked entity with a box.
  vm::EntityIndex spawn_box(const math::Vec3& origin, server::Solid solid, float half_size = 16);
  void set_text(vm::EntityIndex index, server::Field<vm::StringIndex> field, std::string_view text);
  void set_self(vm::EntityIndex index) { machine.set_global_entity(server::global::kSelf, index); }

  void set_parameter(int i, float value) { machine.set_parameter_float(i, value); }
  void set_parameter(int i, int value) { machine.set_parameter_float(i, static_cast<float>(value)); }
  void set_parameter(int i, const math::Vec3& value) { machine.set_parameter_vector(i, value); }
  void set_parameter(int i, std::string_view value) {
    machine.set_parameter_string(i, machine.make_string(value).value());
  }
  void set_parameter(int i, const char* value) { set_parameter(i, std::string_view(value)); }
  void set_parameter(int i, vm::EntityIndex value) { machine.set_parameter_entity(i, value); }
  void set_parameter(int i, RawWord value) {
    machine.set_parameter_float(i, std::bit_cast<float>(value.word));
  }
  template <typename T>
  void set_parameter(int i, server::Field<T> value) {
    set_parameter(i, RawWord{value.word});
  }

  static constexpr vm::EntityIndex kPlayer1{1}, kPlayer2{2};

  vm::Machine machine;
  NotedCalls calls;
  server::GameWorld world;
  server::Outbox outbox;
  server::Precache precache;
  server::Requests requests;
  server::GameRandom random;
  command::Variables variables;
  std::string printed;
  server::BuiltinContext context;
};

// The messages in the bytes, to which they refer. CHECKs that all of them are of this type.
template <typename Message>
std::vector<Message> messages_in(base::Bytes bytes, const net::Dialect& dialect = {}) {
  net::MessageReader reader = make_reader(dialect);
  reader.begin(bytes);
  std::vector<Message> messages;
  while (true) {
    const auto next = reader.next();
    CHECK(next.ok(), "{}", next.error().message());
    if (!next->has_value()) return messages;
    messages.push_back(std::get<Message>(**next));
  }
}

}  // namespace temblor::test
