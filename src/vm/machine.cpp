// Calls: frames, locals, built-in functions, budgets, and cleaning up after a failure.
#include "vm/machine.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text.h"

namespace temblor::vm {
namespace {

constexpr std::uint32_t kNoBuiltin = std::numeric_limits<std::uint32_t>::max();

// The number of words that can be copied in about the time of one instruction.
constexpr std::uint32_t kWordsPerInstruction = 32;

std::int64_t as_budget(std::uint64_t instructions) {
  constexpr std::uint64_t kMaxBudget = std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(std::min(instructions, kMaxBudget));
}

}  // namespace

Machine::Machine(std::shared_ptr<const Program> program, Limits limits)
    : program_(std::move(program)),
      limits_(limits),
      globals_(program_->progs().global_words),
      entity_words_(program_->progs().entity_words),
      strings_(program_->progs().strings, limits.string_bytes),
      builtin_by_function_(program_->progs().functions.size(), kNoBuiltin),
      counters_(program_->progs().functions.size()) {
  CHECK(limits.entity_bytes / sizeof(std::uint32_t) <= kFirstGlobalPointer);
  globals_.resize(globals_.size() + kSpareWords);
  // In programs of version 6, fteqcc lets arrays use operations that the original lacks while this variable
  // is set, because an engine that has them sets it.
  if (const formats::ProgsDefinition* fast_arrays = program_->find_global("__ext__fasttrackarrays");
      fast_arrays != nullptr && fast_arrays->type == formats::ProgsType::kFloat)
    set_global_float(base::to_index<GlobalIndex>(fast_arrays->offset), 1);
  for (std::size_t i = 0; i < counters_.size(); ++i) counters_[i].function = base::to_index<FunctionIndex>(i);
}

void Machine::bind(std::size_t slot, FunctionIndex function) {
  builtin_by_function_[base::to_size(function)] = static_cast<std::uint32_t>(slot);
}

void Machine::add_builtin(int number, std::string name, Builtin builtin) {
  CHECK(nested_calls_ == 0 && number > 0, "{}", number);
  builtins_.push_back({std::move(name), std::move(builtin)});
  const auto& functions = program_->progs().functions;
  for (std::size_t i = 1; i < functions.size(); ++i)
    if (functions[i].first_statement == -number) bind(builtins_.size() - 1, base::to_index<FunctionIndex>(i));
}

void Machine::add_named_builtin(std::string name, Builtin builtin) {
  CHECK(nested_calls_ == 0);
  const auto& functions = program_->progs().functions;
  for (std::size_t i = 1; i < functions.size(); ++i)
    if (functions[i].first_statement == 0 &&
        program_->function_name(base::to_index<FunctionIndex>(i)) == name)
      bind(builtins_.size(), base::to_index<FunctionIndex>(i));
  builtins_.push_back({std::move(name), std::move(builtin)});
}

void Machine::set_state_fields(const StateFields& fields) {
  const std::size_t globals = global_words().size(), words = program_->progs().entity_words;
  CHECK(base::to_size(fields.self) < globals && base::to_size(fields.time) < globals);
  for (const FieldIndex field : {fields.next_think, fields.frame, fields.think})
    CHECK(base::to_size(field) < words, "{} of {}", base::to_size(field), words);
  state_fields_ = fields;
}

std::vector<TraceEntry> Machine::current_trace() const {
  std::vector<TraceEntry> trace;
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame)
    trace.push_back({frame->function, static_cast<std::size_t>(frame->at - program_->instructions().data())});
  return trace;
}

std::string Machine::describe(std::span<const TraceEntry> trace) const {
  std::string lines;
  for (const TraceEntry& entry : trace)
    lines += "  " + program_->describe_place(entry.function, entry.statement) + "\n";
  return lines;
}

base::Error Machine::add_location(base::Error error) {
  failure_trace_ = current_trace();
  if (!failure_trace_.empty())
    error.what +=
        "; in " + program_->describe_place(failure_trace_.front().function, failure_trace_.front().statement);
  failure_ = error;
  return error;
}

// Every nested call uses the C++ stack as well, so their depth has a limit of its own.
base::Status Machine::call(FunctionIndex function) {
  if (nested_calls_ >= limits_.nested_calls)
    return add_location(base::error(base::ErrorCode::kTooLarge,
                                    "built-in functions and functions call each other, {} levels deep",
                                    nested_calls_));
  if (nested_calls_ == 0) budget_ = as_budget(limits_.instructions);
  const int parameter_count = parameter_count_;
  ++nested_calls_;
  base::Status status = run(function);
  --nested_calls_;
  parameter_count_ = parameter_count;
  return status;
}

base::Status Machine::run(FunctionIndex function) {
  const auto& functions = program_->progs().functions;
  if (function == kNoFunction || base::to_size(function) >= functions.size())
    return add_location(base::malformed("there is no function {}", base::to_size(function)));
  if (functions[base::to_size(function)].first_statement <= 0) {
    parameter_count_ = 0;
    return run_builtin(function);
  }
  return run_frames(function);
}

// Runs a function with statements. After a failure, frames of this call are still open; leaving them restores
// all locals, so that the machine can be called again.
base::Status Machine::run_frames(FunctionIndex function) {
  const std::size_t base_frames = frames_.size();
  if (!enter(function)) return add_location(make_limit_error(function));
  Stop stop = Stop::kSwitched;
  while (stop == Stop::kSwitched)
    stop = tracer_ ? interpret<true>(base_frames) : interpret<false>(base_frames);
  while (frames_.size() > base_frames) leave();
  if (stop == Stop::kFailed) return failure_;
  return base::Ok{};
}

base::Error Machine::make_limit_error(FunctionIndex index) const {
  if (frames_.size() >= static_cast<std::size_t>(limits_.call_depth))
    return base::error(base::ErrorCode::kTooLarge, "the calls are {} levels deep (endless recursion?)",
                       frames_.size());
  return base::error(base::ErrorCode::kTooLarge,
                     "the locals of all active functions need {} words; the limit is {}",
                     saved_count_ + program_->function(index).local_count, limits_.saved_words);
}

// Saves the old values of the callee's locals, then copies the parameters into the first locals:
//
//   saved_:   | locals of frame 0 | locals of frame 1 | free |
//                                 ^ saved_begin of 1  ^ saved_count_
bool Machine::enter(FunctionIndex index) {
  const formats::ProgsFunction& function = program_->function(index);
  const std::size_t saved_end = saved_count_ + function.local_count;
  if (frames_.size() >= static_cast<std::size_t>(limits_.call_depth) || saved_end > limits_.saved_words)
    return false;
  if (saved_end > saved_.size()) saved_.resize(std::min(2 * saved_end, limits_.saved_words));
  const auto locals = globals_.begin() + function.first_local;
  std::copy_n(locals, function.local_count, saved_.begin() + static_cast<std::ptrdiff_t>(saved_count_));
  frames_.push_back({index, program_->instructions().data() + function.first_statement, saved_count_});
  saved_count_ = saved_end;
  ++counters_[base::to_size(index)].calls;
  charge(function.local_count / kWordsPerInstruction);
  auto to = locals;
  for (std::int32_t i = 0; i < function.parameter_count; ++i)
    to = std::copy_n(std::as_const(*this).parameter_at(i),
                     function.parameter_words[static_cast<std::size_t>(i)], to);
  return true;
}

void Machine::leave() {
  const Frame& frame = frames_.back();
  const formats::ProgsFunction& function = program_->function(frame.function);
  std::copy_n(saved_.begin() + static_cast<std::ptrdiff_t>(frame.saved_begin), function.local_count,
              globals_.begin() + function.first_local);
  saved_count_ = frame.saved_begin;
  frames_.pop_back();
}

// A built-in function reads bad text parameters as empty; the error comes afterward, so that its code needs
// no check.
base::Status Machine::run_builtin(FunctionIndex index) {
  const std::uint32_t slot = builtin_by_function_[base::to_size(index)];
  if (slot == kNoBuiltin)
    return add_location(base::error(base::ErrorCode::kUnsupported, "there is no built-in function {} ({})",
                                    -std::int64_t{program_->function(index).first_statement},
                                    base::quotable(program_->function_name(index))));
  ++counters_[base::to_size(index)].calls;
  bad_text_parameter_.reset();
  const base::Status status = builtins_[slot].run(*this);
  // An error of a nested call already has its location.
  if (!status.ok() && status.error().what == failure_.what) return status;
  if (!status.ok())
    return add_location({status.error().code, builtins_[slot].name + ": " + status.error().what, {}});
  if (bad_text_parameter_)
    return add_location(
        base::malformed("{}: parameter {} is not a string", builtins_[slot].name, *bad_text_parameter_ + 1));
  return base::Ok{};
}

void Machine::charge(std::uint64_t instructions) {
  // Stay far from the limits of the integer type, because more may be subtracted.
  budget_ -= std::min(as_budget(instructions), std::max<std::int64_t>(budget_, 0) + 1);
}

base::Status Machine::set_entity_count(std::uint32_t count) {
  CHECK(count > 0);
  const std::size_t words = std::size_t{count} * program_->progs().entity_words;
  if (count > limits_.entities || words * sizeof(std::uint32_t) > limits_.entity_bytes)
    return base::error(base::ErrorCode::kTooLarge, "{} entities of {} words exceed the memory limit", count,
                       program_->progs().entity_words);
  entity_words_.resize(words);
  entity_count_ = count;
  return base::Ok{};
}

void Machine::collect_strings() {
  if (nested_calls_ == 0 && strings_.needs_collection()) strings_.collect({globals_, entity_words_});
}

std::vector<FunctionProfile> Machine::profile() const {
  std::vector<FunctionProfile> profile;
  std::ranges::copy_if(counters_, std::back_inserter(profile),
                       [](const FunctionProfile& entry) { return entry.calls > 0; });
  std::ranges::stable_sort(profile, std::ranges::greater{}, &FunctionProfile::instructions);
  return profile;
}

void Machine::reset_profile() {
  for (FunctionProfile& entry : counters_) entry.calls = entry.instructions = 0;
}

std::uint64_t Machine::instructions_run() const {
  std::uint64_t instructions = 0;
  for (const FunctionProfile& entry : counters_) instructions += entry.instructions;
  return instructions;
}

}  // namespace temblor::vm
