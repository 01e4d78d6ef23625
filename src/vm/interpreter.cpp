// The interpreter loop.
//
// Each operation ends with its own jump to the code of the next operation, through a table of labels ("labels
// as values", an extension of g++ and clang). The branch predictor then learns which operations follow each
// other; a shared switch would hide that.
//
// Nothing is counted for each instruction: the number of executed instructions is the distance from the
// target of the last jump, added up at taken jumps, calls, and returns. The loop exists twice: the traced
// version prints every statement, and uses no fused operations.
//
// Operand indices were checked when the program was loaded. Only values (entities, fields, pointers, strings,
// functions) are checked here. Float operations follow IEEE 754, as in the original: division by zero gives
// an infinity or NaN.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/text.h"
#include "vm/disassembly.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

constexpr std::uint32_t kVectorWords = 3;
// The number of characters that can be compared in about the time of one instruction.
constexpr std::size_t kCharactersPerInstruction = 32;

inline float as_float(std::uint32_t word) {
  return std::bit_cast<float>(word);
}
inline std::uint32_t as_word(float value) {
  return std::bit_cast<std::uint32_t>(value);
}
inline std::uint32_t truth(bool value) {
  return value ? as_word(1.0f) : 0;
}

// Truncates. NaN and values too large for 32 bits become the smallest integer, as on the original's
// processors.
inline std::int32_t as_int(std::uint32_t word) {
  const float value = as_float(word);
  return value >= -0x1p31f && value < 0x1p31f ? static_cast<std::int32_t>(value) : INT32_MIN;
}

inline bool same_vector(const std::uint32_t* a, const std::uint32_t* b) {
  return as_float(a[0]) == as_float(b[0]) && as_float(a[1]) == as_float(b[1]) &&
         as_float(a[2]) == as_float(b[2]);
}

inline void scale_vector(std::uint32_t* out, const std::uint32_t* vector, float scale) {
  const float x = as_float(vector[0]) * scale, y = as_float(vector[1]) * scale,
              z = as_float(vector[2]) * scale;
  out[0] = as_word(x);
  out[1] = as_word(y);
  out[2] = as_word(z);
}

// `sign`: 1 adds, -1 subtracts (adding the negated value gives the same bits).
inline void add_vectors(std::uint32_t* out, const std::uint32_t* a, const std::uint32_t* b, float sign) {
  const float x = as_float(a[0]) + sign * as_float(b[0]), y = as_float(a[1]) + sign * as_float(b[1]),
              z = as_float(a[2]) + sign * as_float(b[2]);
  out[0] = as_word(x);
  out[1] = as_word(y);
  out[2] = as_word(z);
}

inline void copy_vector(std::uint32_t* out, const std::uint32_t* in) {
  const std::uint32_t x = in[0], y = in[1], z = in[2];
  out[0] = x;
  out[1] = y;
  out[2] = z;
}

}  // namespace

Machine::Stop Machine::fail(const Instruction* at, base::Error error) {
  frames_.back().at = at;
  add_location(std::move(error));
  return Stop::kFailed;
}

Machine::Stop Machine::fail_string(const Instruction* at, std::uint32_t left, std::uint32_t right) {
  return fail(at,
              base::malformed("{:#x} is not a string", strings_.contains(StringIndex{left}) ? right : left));
}

Machine::Stop Machine::fail_field(const Instruction* at, std::uint32_t entity, std::uint32_t field) {
  if (entity >= entity_count_)
    return fail(at, base::malformed("{:#x} is not an entity (there are {})", entity, entity_count_));
  if (field >= program_->progs().entity_words)
    return fail(at, base::malformed("{:#x} is not a field (entities have {} words)", field,
                                    program_->progs().entity_words));
  if (entity == 0 && world_is_protected_ && at->alone == Operation::kAddress)
    return fail(at, base::malformed("it writes to the world entity"));
  return fail(at, base::malformed("it accesses a vector at word {} of an entity with {} words", field,
                                  program_->progs().entity_words));
}

Machine::Stop Machine::fail_pointer(const Instruction* at, std::uint32_t pointer) {
  return fail(at, base::malformed("it writes through the pointer {:#x}, which is not in an entity", pointer));
}

// One function, because the labels of all operations must be in it.
template <bool kIsTraced>
Machine::Stop Machine::interpret(std::size_t base_frames) {
#define TEMBLOR_VM_LABEL(name) &&on_##name,
  static const void* const kCode[] = {TEMBLOR_VM_OPERATIONS(TEMBLOR_VM_LABEL)};
#undef TEMBLOR_VM_LABEL
  const Instruction* at = frames_.back().at;
  const Instruction* run_begin = at;  // instructions since then are not yet subtracted from the budget
  std::int64_t budget = budget_;
  std::int64_t budget_at_entry = budget;  // when the current function started
  std::uint32_t* const globals = globals_.data();
  std::uint32_t* entities = entity_words_.data();
  std::uint32_t entity_count = entity_count_;
  const std::uint32_t entity_words = program_->progs().entity_words;
  // The program may write to a pointer if pointer - writable_begin < writable_words. The subtraction wraps
  // around for smaller pointers, so one comparison checks both ends.
  std::uint32_t writable_begin = 0, writable_words = 0;
  // A built-in function may have moved, added, or protected entities.
  const auto refresh_entities = [&] {
    entities = entity_words_.data();
    entity_count = entity_count_;
    writable_begin = world_is_protected_ ? entity_words : 0;
    writable_words = static_cast<std::uint32_t>(entity_words_.size()) - writable_begin;
  };
  refresh_entities();
  // Subtracts the instructions since run_begin, up to and including `last`, from the budget.
  const auto count_instructions = [&](const Instruction* last) {
    budget -= last + 1 - run_begin;
    run_begin = last + 1;
  };
  // Adds the instructions since the current function started or continued to its profile.
  const auto update_profile = [&] {
    counters_[base::to_size(frames_.back().function)].instructions +=
        static_cast<std::uint64_t>(budget_at_entry - budget);
    budget_at_entry = budget_ = budget;
  };

#define A globals[at->a]
#define B globals[at->b]
#define C globals[at->c]
#define FA as_float(A)
#define FB as_float(B)
#define DISPATCH()                                                                                        \
  do {                                                                                                    \
    if constexpr (kIsTraced) {                                                                            \
      tracer_(                                                                                            \
          describe_statement(*program_, static_cast<std::size_t>(at - program_->instructions().data()))); \
      goto* kCode[static_cast<std::size_t>(at->alone)];                                                   \
    } else {                                                                                              \
      goto* kCode[static_cast<std::size_t>(at->operation)];                                               \
    }                                                                                                     \
  } while (false)
#define NEXT()  \
  do {          \
    ++at;       \
    DISPATCH(); \
  } while (false)
#define JUMP(distance)                \
  do {                                \
    count_instructions(at);           \
    at += (distance);                 \
    run_begin = at;                   \
    if (budget < 0) goto out_of_time; \
    DISPATCH();                       \
  } while (false)
#define FAIL(call)          \
  do {                      \
    count_instructions(at); \
    update_profile();       \
    return call;            \
  } while (false)
// Defines an operation that computes a truth value: alone, and fused with either branch that tests it.
#define TESTED(name, value)          \
  on_##name : C = (value);           \
  NEXT();                            \
  on_##name##IfNot : {               \
    const std::uint32_t v = (value); \
    C = v;                           \
    ++at;                            \
    if (v == 0) JUMP(at->b);         \
    NEXT();                          \
  }                                  \
  on_##name##If : {                  \
    const std::uint32_t v = (value); \
    C = v;                           \
    ++at;                            \
    if (v != 0) JUMP(at->b);         \
    NEXT();                          \
  }

  DISPATCH();

on_MulF:
  C = as_word(FA * FB);
  NEXT();
on_MulV : {
  const std::uint32_t *a = &A, *b = &B;
  C = as_word(as_float(a[0]) * as_float(b[0]) + as_float(a[1]) * as_float(b[1]) +
              as_float(a[2]) * as_float(b[2]));
  NEXT();
}
on_MulFV:
  scale_vector(&C, &B, FA);
  NEXT();
on_MulVF:
  scale_vector(&C, &A, FB);
  NEXT();
on_DivF:
  C = as_word(FA / FB);
  NEXT();
on_AddF:
  C = as_word(FA + FB);
  NEXT();
on_AddV:
  add_vectors(&C, &A, &B, 1);
  NEXT();
on_SubF:
  C = as_word(FA - FB);
  NEXT();
on_SubV:
  add_vectors(&C, &A, &B, -1);
  NEXT();

  // Operations that compute a truth value. And and Or are not short-circuit: both operands were computed
  // before.
  TESTED(EqF, truth(FA == FB))
  TESTED(NeF, truth(FA != FB))
  TESTED(EqWord, truth(A == B))
  TESTED(NeWord, truth(A != B))
  TESTED(Le, truth(FA <= FB))
  TESTED(Ge, truth(FA >= FB))
  TESTED(Lt, truth(FA < FB))
  TESTED(Gt, truth(FA > FB))
  TESTED(And, truth(FA != 0 && FB != 0))
  TESTED(Or, truth(FA != 0 || FB != 0))
  TESTED(BitAnd, as_word(static_cast<float>(as_int(A) & as_int(B))))
  TESTED(NotF, truth(FA == 0))
  TESTED(NotWord, truth(A == 0))
on_BitOr:
  C = as_word(static_cast<float>(as_int(A) | as_int(B)));
  NEXT();
on_EqV:
  C = truth(same_vector(&A, &B));
  NEXT();
on_NeV:
  C = truth(!same_vector(&A, &B));
  NEXT();
on_NotV : {
  const std::uint32_t* a = &A;
  C = truth(as_float(a[0]) == 0 && as_float(a[1]) == 0 && as_float(a[2]) == 0);
  NEXT();
}
on_EqS:
on_NeS : {
  const StringIndex left{A}, right{B};
  if (!strings_.contains(left) || !strings_.contains(right)) FAIL(fail_string(at, A, B));
  const std::string_view left_text = strings_.text(left), right_text = strings_.text(right);
  const int order = left_text.compare(right_text);
  budget -= static_cast<std::int64_t>((left_text.size() + right_text.size()) / kCharactersPerInstruction);
  // NE_S returns the sign of the comparison, not 1, as in the original.
  if (at->alone == Operation::kEqS)
    C = truth(order == 0);
  else
    C = as_word(static_cast<float>((order > 0) - (order < 0)));
  NEXT();
}
on_NotS : {
  if (!strings_.contains(StringIndex{A})) FAIL(fail_string(at, A, A));
  C = truth(strings_.is_empty(StringIndex{A}));
  NEXT();
}

// Loads a word of an entity's field; for the load alone, and fused with either branch.
#define LOADED_WORD()                                                              \
  const std::uint32_t entity = A, field = B;                                       \
  if (entity >= entity_count || field >= entity_words) [[unlikely]]                \
    FAIL(fail_field(at, entity, field));                                           \
  const std::uint32_t word = entities[std::size_t{entity} * entity_words + field]; \
  C = word;
on_LoadWord : {
  LOADED_WORD()
  NEXT();
}
on_LoadWordIfNot : {
  LOADED_WORD()
  ++at;
  if (word == 0) JUMP(at->b);
  NEXT();
}
on_LoadWordIf : {
  LOADED_WORD()
  ++at;
  if (word != 0) JUMP(at->b);
  NEXT();
}
on_LoadVector : {
  const std::uint32_t entity = A, field = B;
  if (entity >= entity_count || std::size_t{field} + kVectorWords > entity_words) [[unlikely]]
    FAIL(fail_field(at, entity, field));
  copy_vector(&C, entities + std::size_t{entity} * entity_words + field);
  NEXT();
}

// Computes a pointer to a field; alone, and fused with the store through it. A pointer to a protected world
// is an error already here, as in the original.
#define ADDRESSED_PLACE()                                                                       \
  const std::uint32_t entity = A, field = B;                                                    \
  const std::uint32_t pointer = entity * entity_words + field;                                  \
  if (entity >= entity_count || field >= entity_words || pointer < writable_begin) [[unlikely]] \
    FAIL(fail_field(at, entity, field));                                                        \
  C = pointer;
on_Address : {
  ADDRESSED_PLACE()
  NEXT();
}
on_AddressStorePWord : {
  ADDRESSED_PLACE()
  ++at;
  entities[pointer] = A;
  NEXT();
}
on_AddressStorePVector : {
  ADDRESSED_PLACE()
  ++at;
  if (field + kVectorWords > entity_words) [[unlikely]]
    FAIL(fail_pointer(at, pointer));
  copy_vector(entities + pointer, &A);
  NEXT();
}
on_StoreWord:
  B = A;
  NEXT();
on_StoreVector:
  copy_vector(&B, &A);
  NEXT();
on_StorePWord : {
  const std::uint32_t pointer = B;
  if (pointer - writable_begin >= writable_words) [[unlikely]]
    FAIL(fail_pointer(at, pointer));
  entities[pointer] = A;
  NEXT();
}
on_StorePVector : {
  const std::uint32_t pointer = B;
  if (pointer - writable_begin >= writable_words || pointer % entity_words + kVectorWords > entity_words)
      [[unlikely]]
    FAIL(fail_pointer(at, pointer));
  copy_vector(entities + pointer, &A);
  NEXT();
}

// Branches test the word, not the float: -0.0 counts as true, as in the original.
on_If:
  if (A != 0) JUMP(at->b);
  NEXT();
on_IfNot:
  if (A == 0) JUMP(at->b);
  NEXT();
on_Goto:
  JUMP(at->a);

on_Call : {
  const std::uint32_t index = A;
  count_instructions(at);
  update_profile();
  if (budget < 0) goto out_of_time;
  if (index == 0) return fail(at, base::malformed("it calls a function variable that is not set"));
  if (index >= program_->progs().functions.size())
    return fail(at, base::malformed("it calls function {:#x}, but there are only {}", index,
                                    program_->progs().functions.size()));
  frames_.back().at = at;
  parameter_count_ = at->b;
  const FunctionIndex function{index};
  if (program_->function(function).first_statement > 0) {
    if (!enter(function)) return fail(at, make_limit_error(function));
    budget = budget_;
    at = run_begin = frames_.back().at;
    DISPATCH();
  }
  if (base::Status status = run_builtin(function); !status.ok()) {
    failure_ = status.error();
    return Stop::kFailed;
  }
  budget = budget_at_entry = budget_;
  refresh_entities();
  if (kIsTraced != static_cast<bool>(tracer_)) {
    frames_.back().at = at + 1;
    return Stop::kSwitched;
  }
  NEXT();
}
on_Return : {
  // Copy one word after the other, as in the original: the operand of DONE is word 0, which word 1 follows,
  // so DONE returns word 0 three times.
  const std::uint32_t* value = &A;
  globals[1] = value[0];
  globals[2] = value[1];
  globals[3] = value[2];
  count_instructions(at);
  update_profile();
  leave();
  if (frames_.size() == base_frames) return Stop::kReturned;
  at = frames_.back().at + 1;
  run_begin = at;
  DISPATCH();
}
on_State : {
  if (!state_fields_)
    FAIL(fail(at, base::malformed("it uses STATE, but the program does not define its fields (self, time, "
                                  "nextthink, frame, think)")));
  const std::uint32_t entity = globals[base::to_size(state_fields_->self)];
  if (entity >= entity_count) FAIL(fail_field(at, entity, 0));
  if (entity == 0 && world_is_protected_) FAIL(fail(at, base::malformed("it writes to the world entity")));
  std::uint32_t* words = entities + std::size_t{entity} * entity_words;
  // The sum is computed in double precision, as in the original.
  const double think_time_s = double{as_float(globals[base::to_size(state_fields_->time)])} + 0.1;
  words[base::to_size(state_fields_->next_think)] = as_word(static_cast<float>(think_time_s));
  words[base::to_size(state_fields_->frame)] = A;
  words[base::to_size(state_fields_->think)] = B;
  NEXT();
}
on_PastEnd:
  --at;  // kPastEnd is not a statement of the program
  FAIL(fail(at, base::malformed("it runs past the last statement of the program")));

out_of_time:
  update_profile();
  return fail(at, base::error(base::ErrorCode::kTooLarge, "endless loop? Stopped after {} instructions",
                              limits_.instructions));
#undef ADDRESSED_PLACE
#undef LOADED_WORD
#undef TESTED
#undef FAIL
#undef JUMP
#undef NEXT
#undef DISPATCH
#undef FB
#undef FA
#undef C
#undef B
#undef A
}

template Machine::Stop Machine::interpret<false>(std::size_t base_frames);
template Machine::Stop Machine::interpret<true>(std::size_t base_frames);

}  // namespace temblor::vm
