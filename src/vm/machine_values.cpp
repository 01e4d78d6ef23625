// Typed access to the machine's words: globals, parameters, results, entities.
#include <bit>

#include "vm/machine.h"

namespace temblor::vm {
namespace {

// Places that every program reserves. A parameter has three words, whatever its type.
constexpr std::size_t kReturnedWord = 1, kFirstParameterWord = 4, kParameterStride = 3;

math::Vec3 vector_at(const std::uint32_t* words) {
  return {std::bit_cast<float>(words[0]), std::bit_cast<float>(words[1]), std::bit_cast<float>(words[2])};
}

void set_vector(std::uint32_t* out_words, const math::Vec3& value) {
  for (int axis = 0; axis < 3; ++axis) out_words[axis] = std::bit_cast<std::uint32_t>(value[axis]);
}

// Returns a value of `words` words. CHECKs that the index is valid.
template <typename Words>
auto* checked(Words& globals, std::size_t count, GlobalIndex index, std::size_t words) {
  CHECK(base::to_size(index) + words <= count, "{} of {}", base::to_size(index), count);
  return globals.data() + base::to_size(index);
}

}  // namespace

float Machine::global_float(GlobalIndex index) const {
  return std::bit_cast<float>(*checked(globals_, global_words().size(), index, 1));
}
math::Vec3 Machine::global_vector(GlobalIndex index) const {
  return vector_at(checked(globals_, global_words().size(), index, 3));
}
EntityIndex Machine::global_entity(GlobalIndex index) const {
  const std::uint32_t word = *checked(globals_, global_words().size(), index, 1);
  return word < entity_count_ ? EntityIndex{word} : kWorld;
}
StringIndex Machine::global_string(GlobalIndex index) const {
  return StringIndex{*checked(globals_, global_words().size(), index, 1)};
}
FunctionIndex Machine::global_function(GlobalIndex index) const {
  return FunctionIndex{*checked(globals_, global_words().size(), index, 1)};
}
void Machine::set_global_float(GlobalIndex index, float value) {
  *checked(globals_, global_words().size(), index, 1) = std::bit_cast<std::uint32_t>(value);
}
void Machine::set_global_vector(GlobalIndex index, const math::Vec3& value) {
  set_vector(checked(globals_, global_words().size(), index, 3), value);
}
void Machine::set_global_entity(GlobalIndex index, EntityIndex value) {
  *checked(globals_, global_words().size(), index, 1) = static_cast<std::uint32_t>(value);
}
void Machine::set_global_string(GlobalIndex index, StringIndex value) {
  *checked(globals_, global_words().size(), index, 1) = static_cast<std::uint32_t>(value);
}
void Machine::set_global_function(GlobalIndex index, FunctionIndex value) {
  *checked(globals_, global_words().size(), index, 1) = static_cast<std::uint32_t>(value);
}

const std::uint32_t* Machine::parameter_at(int i) const {
  CHECK(i >= 0 && i < kMaxParameters, "{}", i);
  return globals_.data() + kFirstParameterWord + kParameterStride * static_cast<std::size_t>(i);
}
std::uint32_t* Machine::parameter_at(int i) {
  CHECK(i >= 0 && i < kMaxParameters, "{}", i);
  return globals_.data() + kFirstParameterWord + kParameterStride * static_cast<std::size_t>(i);
}

float Machine::parameter_float(int i) const {
  return std::bit_cast<float>(*parameter_at(i));
}
math::Vec3 Machine::parameter_vector(int i) const {
  return vector_at(parameter_at(i));
}
std::string_view Machine::parameter_text(int i) {
  const StringIndex index = parameter_string(i);
  if (!strings_.contains(index)) bad_text_parameter_ = i;
  return strings_.text(index);
}
StringIndex Machine::parameter_string(int i) const {
  return StringIndex{*parameter_at(i)};
}
FunctionIndex Machine::parameter_function(int i) const {
  return FunctionIndex{*parameter_at(i)};
}
base::Result<EntityIndex> Machine::parameter_entity(int i) const {
  const std::uint32_t word = *parameter_at(i);
  if (word >= entity_count_)
    return base::malformed("parameter {} is {:#x}, which is not an entity (there are {})", i + 1, word,
                           entity_count_);
  return EntityIndex{word};
}
base::Result<FieldIndex> Machine::parameter_field(int i) const {
  const std::uint32_t word = *parameter_at(i);
  if (word >= program_->progs().entity_words)
    return base::malformed("parameter {} is {:#x}, which is not a field (entities have {} words)", i + 1,
                           word, program_->progs().entity_words);
  return FieldIndex{word};
}
void Machine::set_parameter_float(int i, float value) {
  *parameter_at(i) = std::bit_cast<std::uint32_t>(value);
}
void Machine::set_parameter_vector(int i, const math::Vec3& value) {
  set_vector(parameter_at(i), value);
}
void Machine::set_parameter_string(int i, StringIndex value) {
  *parameter_at(i) = static_cast<std::uint32_t>(value);
}
void Machine::set_parameter_entity(int i, EntityIndex value) {
  *parameter_at(i) = static_cast<std::uint32_t>(value);
}

void Machine::return_float(float value) {
  globals_[kReturnedWord] = std::bit_cast<std::uint32_t>(value);
}
void Machine::return_vector(const math::Vec3& value) {
  set_vector(globals_.data() + kReturnedWord, value);
}
void Machine::return_string(StringIndex value) {
  globals_[kReturnedWord] = static_cast<std::uint32_t>(value);
}
void Machine::return_entity(EntityIndex value) {
  globals_[kReturnedWord] = static_cast<std::uint32_t>(value);
}
float Machine::returned_float() const {
  return std::bit_cast<float>(globals_[kReturnedWord]);
}
math::Vec3 Machine::returned_vector() const {
  return vector_at(globals_.data() + kReturnedWord);
}
EntityIndex Machine::returned_entity() const {
  return global_entity(GlobalIndex{kReturnedWord});
}
StringIndex Machine::returned_string() const {
  return StringIndex{globals_[kReturnedWord]};
}

std::span<std::uint32_t> Machine::entity(EntityIndex index) {
  CHECK(base::to_size(index) < entity_count_, "{} of {}", base::to_size(index), entity_count_);
  const std::size_t words = program_->progs().entity_words;
  return std::span(entity_words_).subspan(base::to_size(index) * words, words);
}
std::span<const std::uint32_t> Machine::entity(EntityIndex index) const {
  CHECK(base::to_size(index) < entity_count_, "{} of {}", base::to_size(index), entity_count_);
  const std::size_t words = program_->progs().entity_words;
  return std::span(entity_words_).subspan(base::to_size(index) * words, words);
}

}  // namespace temblor::vm
