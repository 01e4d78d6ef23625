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
#include <array>
#include <cstdint>

#include "base/text.h"
#include "vm/code/opcodes.h"
#include "vm/code/words.h"
#include "vm/disassembly.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

constexpr std::uint32_t kVectorWords = 3, kParameterWord = 4;
// The number of characters that can be compared in about the time of one instruction.
constexpr std::size_t kCharactersPerInstruction = 32;

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
  const bool reads = at->alone == Operation::kLoadPWord || at->alone == Operation::kLoadPVector;
  return fail(
      at, base::malformed("it {} through the pointer {:#x}, which is not in an entity or a global variable",
                          reads ? "reads" : "writes", pointer));
}

Machine::Stop Machine::fail_index(const Instruction* at, std::uint32_t index) {
  return fail(at, base::malformed("{} is not an index of the array", static_cast<std::int32_t>(index)));
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
  const Instruction* const code = program_->instructions().data();
  std::uint32_t callee = 0;
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
#define IA integer_as_float(A)
#define IB integer_as_float(B)
#define DISPATCH()                                          \
  do {                                                      \
    if constexpr (kIsTraced)                                \
      goto trace;                                           \
    else                                                    \
      goto* kCode[static_cast<std::size_t>(at->operation)]; \
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
// Stores through `pointer`, which is not in an entity that the program may write to: `store` writes to
// `place`.
#define STORE_P(words, store)                                     \
  do {                                                            \
    std::uint32_t* const place = find_writable(pointer, (words)); \
    if (place == nullptr) FAIL(fail_pointer(at, pointer));        \
    store;                                                        \
    NEXT();                                                       \
  } while (false)
// Define operations that compute a word from their operands, that change their second operand, or that change
// the word or vector to which it points.
#define COMPUTED(name, value) \
  on_##name : C = (value);    \
  NEXT();
#define CHANGED(name, change) \
  on_##name : change;         \
  NEXT();
#define CHANGED_P(name, words, change) \
  on_##name : {                        \
    const std::uint32_t pointer = B;   \
    STORE_P(words, change);            \
  }
// Defines an operation that loads a word or vector from `found`, a pointer or null; `fail` is the error.
#define FOUND(name, words, found, failed)       \
  on_##name : {                                 \
    const std::uint32_t* const place = (found); \
    if (place == nullptr) [[unlikely]]          \
      FAIL(failed);                             \
    if constexpr ((words) == 1)                 \
      C = *place;                               \
    else                                        \
      copy_vector(&C, place);                   \
    NEXT();                                     \
  }
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

  // In one place: a copy for each operation would double the time that compilers take.
  [[maybe_unused]] trace : {
    if constexpr (kIsTraced) {
      if (at->alone != Operation::kPastEnd)
        tracer_(describe_statement(*program_, static_cast<std::size_t>(at - code)));
      goto* kCode[static_cast<std::size_t>(at->alone)];
    }
  }
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
  if (pointer - writable_begin < writable_words) [[likely]] {
    entities[pointer] = A;
    NEXT();
  }
  STORE_P(1, *place = A);
}
on_StorePVector : {
  const std::uint32_t pointer = B;
  if (pointer - writable_begin < writable_words && pointer % entity_words + kVectorWords <= entity_words)
      [[likely]] {
    copy_vector(entities + pointer, &A);
    NEXT();
  }
  STORE_P(kVectorWords, copy_vector(place, &A));
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

on_CallH:
  callee = A;
  parameter_count_ = static_cast<int>(program_->progs().statements[static_cast<std::size_t>(at - code)].op) -
                     static_cast<int>(Opcode::kCall1H) + 1;
  if (parameter_count_ > 1) {
    // Copy the second one first: the first one may overwrite it if it is parm0.
    const std::array<std::uint32_t, 3> second = {(&C)[0], (&C)[1], (&C)[2]};
    copy_vector(globals + kParameterWord, &B);
    copy_vector(globals + kParameterWord + kVectorWords, second.data());
  } else {
    copy_vector(globals + kParameterWord, &B);
  }
  goto call;
on_Call:
  callee = A;
  parameter_count_ = at->b;
call : {
  const std::uint32_t index = callee;
  count_instructions(at);
  update_profile();
  if (budget < 0) goto out_of_time;
  if (index == 0) return fail(at, base::malformed("it calls a function variable that is not set"));
  if (index >= program_->progs().functions.size())
    return fail(at, base::malformed("it calls function {:#x}, but there are only {}", index,
                                    program_->progs().functions.size()));
  frames_.back().at = at;
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
  // --- The additions of fteqcc
  CHANGED(MulStoreF, B = as_word(FB * FA))
  CHANGED(MulStoreV, scale_vector(&B, &B, FA))
  CHANGED(DivStoreF, B = as_word(FB / FA))
  CHANGED(AddStoreF, B = as_word(FB + FA))
  CHANGED(AddStoreV, add_vectors(&B, &B, &A, 1))
  CHANGED(SubStoreF, B = as_word(FB - FA))
  CHANGED(SubStoreV, add_vectors(&B, &B, &A, -1))
  CHANGED(BitSetF, B = as_word(static_cast<float>(as_int(B) | as_int(A))))
  CHANGED(BitClearF, B = as_word(static_cast<float>(as_int(B) & ~as_int(A))))
  CHANGED(FToIStore, B = static_cast<std::uint32_t>(as_int(A)))
  CHANGED(IToFStore, B = as_word(IA))
  CHANGED_P(MulStorePF, 1, *place = as_word(as_float(*place) * FA))
  CHANGED_P(DivStorePF, 1, *place = as_word(as_float(*place) / FA))
  CHANGED_P(AddStorePF, 1, *place = as_word(as_float(*place) + FA))
  CHANGED_P(AddStorePV, kVectorWords, add_vectors(place, place, &A, 1))
  CHANGED_P(SubStorePF, 1, *place = as_word(as_float(*place) - FA))
  CHANGED_P(SubStorePV, kVectorWords, add_vectors(place, place, &A, -1))
  CHANGED_P(BitSetPF, 1, *place = as_word(static_cast<float>(as_int(*place) | as_int(A))))
  CHANGED_P(BitClearPF, 1, *place = as_word(static_cast<float>(as_int(*place) & ~as_int(A))))
  CHANGED_P(StorePIToF, 1, *place = as_word(IA))
  CHANGED_P(StorePFToI, 1, *place = static_cast<std::uint32_t>(as_int(A)))
  COMPUTED(IToF, as_word(IA))
  COMPUTED(FToI, static_cast<std::uint32_t>(as_int(A)))
  COMPUTED(AddI, A + B)
  COMPUTED(AddFI, as_word(FA + IB))
  COMPUTED(AddIF, as_word(IA + FB))
  COMPUTED(SubI, A - B)
  COMPUTED(SubFI, as_word(FA - IB))
  COMPUTED(SubIF, as_word(IA - FB))
  COMPUTED(MulI, A * B)
  COMPUTED(BitAndI, A & B)
  COMPUTED(BitOrI, A | B)
  COMPUTED(XorI, A ^ B)
  COMPUTED(ShiftLeftI, A << (B & 31))
  COMPUTED(ShiftRightI, shift_right(A, B))
  COMPUTED(BitAndIF, A & static_cast<std::uint32_t>(as_int(B)))
  COMPUTED(BitOrIF, A | static_cast<std::uint32_t>(as_int(B)))
  COMPUTED(BitAndFI, as_word(static_cast<float>(as_int(A) & static_cast<std::int32_t>(B))))
  COMPUTED(BitOrFI, as_word(static_cast<float>(as_int(A) | static_cast<std::int32_t>(B))))
  COMPUTED(EqI, A == B)
  COMPUTED(NeI, A != B)
  COMPUTED(LeI, static_cast<std::int32_t>(A) <= static_cast<std::int32_t>(B))
  COMPUTED(GeI, static_cast<std::int32_t>(A) >= static_cast<std::int32_t>(B))
  COMPUTED(LtI, static_cast<std::int32_t>(A) < static_cast<std::int32_t>(B))
  COMPUTED(GtI, static_cast<std::int32_t>(A) > static_cast<std::int32_t>(B))
  COMPUTED(LeIF, IA <= FB)
  COMPUTED(GeIF, IA >= FB)
  COMPUTED(LtIF, IA < FB)
  COMPUTED(GtIF, IA > FB)
  COMPUTED(LeFI, FA <= IB)
  COMPUTED(GeFI, FA >= IB)
  COMPUTED(LtFI, FA < IB)
  COMPUTED(GtFI, FA > IB)
  COMPUTED(EqIF, IA == FB)
  COMPUTED(NeIF, IA != FB)
  COMPUTED(AndI, A != 0 && B != 0)
  COMPUTED(OrI, A != 0 || B != 0)
  COMPUTED(AndIF, A != 0 && FB != 0)
  COMPUTED(OrIF, A != 0 || FB != 0)
  COMPUTED(AndFI, FA != 0 && B != 0)
  COMPUTED(OrFI, FA != 0 || B != 0)
on_DivI:
  if (B == 0) FAIL(fail(at, base::malformed("it divides the integer {} by 0", static_cast<std::int32_t>(A))));
  C = divide_integers(A, B);
  NEXT();
on_GetPointer : {
  const std::uint32_t word = static_cast<std::uint32_t>(at->a) + B;
  if (word > global_words().size()) FAIL(fail_index(at, B));
  C = kFirstGlobalPointer + word;
  NEXT();
}
  FOUND(LoadArrayWord, 1, find_element(at, 1), fail_index(at, B))
  FOUND(LoadArrayVector, kVectorWords, find_element(at, kVectorWords), fail_index(at, B))
  FOUND(FetchGlobalWord, 1, find_counted_element(at, 1),
        fail_index(at, static_cast<std::uint32_t>(as_int(B))))
  FOUND(FetchGlobalV, kVectorWords, find_counted_element(at, kVectorWords),
        fail_index(at, static_cast<std::uint32_t>(as_int(B))))
  FOUND(LoadPWord, 1, find_readable(A + B, 1), fail_pointer(at, A + B))
  FOUND(LoadPVector, kVectorWords, find_readable(A + B, kVectorWords), fail_pointer(at, A + B))
on_BoundCheck:
  if (A - static_cast<std::uint32_t>(at->c) >=
      static_cast<std::uint32_t>(at->b) - static_cast<std::uint32_t>(at->c))
    FAIL(fail_index(at, A));
  NEXT();
on_SwitchF:
on_SwitchV:
on_SwitchString:
on_SwitchWord:
  switch_kind_ = at->alone;
  copy_vector(switch_value_.data(), &A);
  JUMP(at->b);
on_Case : {
  const std::uint32_t* value = &A;
  if (switch_kind_ == Operation::kSwitchString &&
      !(strings_.contains(StringIndex{*value}) && strings_.contains(StringIndex{switch_value_[0]})))
    FAIL(fail_string(at, *value, switch_value_[0]));
  if (is_switch_value(value)) JUMP(at->b);
  NEXT();
}
on_CaseRange:
  if (as_float(switch_value_[0]) >= FA && as_float(switch_value_[0]) <= FB) JUMP(at->c);
  NEXT();
on_IfF:
  if (FA != 0) JUMP(at->b);
  NEXT();
on_IfNotF:
  if (FA == 0) JUMP(at->b);
  NEXT();
on_Unknown:
  FAIL(fail(at,
            base::error(base::ErrorCode::kUnsupported,
                        "operation {} is not supported; compile the program with fteqcc, without a target or "
                        "with -Tfte",
                        at->a)));
on_PastEnd:
  --at;  // kPastEnd is not a statement of the program
  FAIL(fail(at, base::malformed("it runs past the last statement of the program")));

out_of_time:
  update_profile();
  return fail(at, base::error(base::ErrorCode::kTooLarge, "endless loop? Stopped after {} instructions",
                              limits_.instructions));
#undef FOUND
#undef CHANGED_P
#undef CHANGED
#undef COMPUTED
#undef STORE_P
#undef ADDRESSED_PLACE
#undef LOADED_WORD
#undef TESTED
#undef FAIL
#undef JUMP
#undef NEXT
#undef DISPATCH
#undef IB
#undef IA
#undef FB
#undef FA
#undef C
#undef B
#undef A
}

template Machine::Stop Machine::interpret<false>(std::size_t base_frames);
template Machine::Stop Machine::interpret<true>(std::size_t base_frames);

}  // namespace temblor::vm
