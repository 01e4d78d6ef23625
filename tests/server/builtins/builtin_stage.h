// A level, a machine with a program that calls any built-in function, and all that these act upon; two
// players' places.
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

// Fields of the stage's program behind the system's.
constexpr server::Field<float> kAlphaField{105}, kScoreField{107};
constexpr server::Field<vm::StringIndex> kTagField{106};
constexpr std::uint32_t kStageEntityWords = 111;

// Calls of game functions that built-in functions cause: noted, and answered with `status`.
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

// A value that is passed to a built-in function as a word that is no float: of a field.
struct RawWord {
  std::uint32_t word;
};

class Stage {
 public:
  // Without a program: one whose functions are the built-in functions themselves, for call().
  explicit Stage(const net::Dialect& dialect = {}, std::shared_ptr<const vm::Program> program = nullptr);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  // Calls it by its number with these parameters: float, Vec3, text, EntityIndex, FieldIndex.
  template <typename... Parameters>
  base::Status call(std::string_view name, const Parameters&... parameters) {
    int i = 0;
    (set_parameter(i++, parameters), ...);
    return call_function(function_of(name), sizeof...(parameters));
  }
  // The same; it must succeed.
  template <typename... Parameters>
  void run(std::string_view name, const Parameters&... parameters) {
    const base::Status status = call(name, parameters...);
    EXPECT_TRUE(status.ok()) << name << ": " << status.error().message();
  }
  // What it returned as that.
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
  // The error's message; empty where there was none.
  template <typename... Parameters>
  std::string error(std::string_view name, const Parameters&... parameters) {
    const base::Status status = call(name, parameters...);
    return status.ok() ? "" : status.error().message();
  }

  // Of stock and extension functions by name, of named ones too.
  vm::FunctionIndex function_of(std::string_view name) const;
  vm::FunctionIndex function_of_number(int number) const;
  base::Status call_function(vm::FunctionIndex function, std::size_t parameter_count);

  server::Edict edict(vm::EntityIndex index) { return world.edicts[index]; }
  vm::EntityIndex spawn() { return world.edicts.spawn(world.time_s).value(); }
  // One with a box, linked.
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

// The messages that the bytes hold, all of that kind; they refer to the bytes. CHECKs that they are.
template <typename Message>
std::vector<Message> messages_in(base::Bytes bytes, const net::Dialect& dialect = {}) {
  net::MessageReader reader = reader_of(dialect);
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
