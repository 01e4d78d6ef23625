#include "formats/game/progs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mutations.h"
#include "support/programs/progs_builder.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kProgsHeaderBytes = 60, kStatementsAt = 8, kGlobalsAt = 16, kFieldsAt = 24,
                      kFunctionsAt = 32, kStringsAt = 40, kWordsAt = 48, kEntityWordsAt = 56;

std::string error_of_progs(base::Bytes bytes) {
  const auto progs = read_progs(bytes);
  return progs.ok() ? "no error" : progs.error().what;
}

Progs small_program() {
  test::ProgsBuilder builder;
  builder.named("time", ProgsType::kFloat);
  builder.named("v_forward", ProgsType::kVector);
  builder.field("health", ProgsType::kFloat);
  builder.field("origin", ProgsType::kVector);
  builder.builtin("dprint", 25);
  builder.function("main", {1, 3}, 2);
  builder.emit(vm::Opcode::kReturn, builder.locals());
  return builder.progs();
}

// The offsets of the first function with statements and of the first global.
std::size_t section(base::Bytes bytes, std::size_t header_at) {
  base::ByteReader reader(bytes);
  reader.seek(header_at);
  return reader.u32();
}

// A file, byte by byte: one statement, one global, no field, two functions.
base::ByteVector smallest_program() {
  base::ByteWriter writer;
  for (const std::uint32_t number : {6u, 5927u, 60u, 2u, 76u, 1u, 84u, 0u, 84u, 2u, 156u, 7u, 163u, 29u, 0u})
    writer.u32(number);
  for (const int number : {0, 0, 0, 0, 43, 28, 0, -1}) writer.i16(static_cast<std::int16_t>(number));
  writer.u16(0x8002);
  writer.u16(28);
  writer.u32(1);
  for (int i = 0; i < 9; ++i) writer.i32(0);
  for (const int number : {1, 28, 1, 99, 3, 5, 1}) writer.i32(number);
  for (int i = 0; i < 8; ++i) writer.u8(i == 0 ? 1 : 0);
  writer.bytes(base::as_bytes(std::string_view("\0t\0m\0q\0", 7)));
  for (std::uint32_t i = 0; i < 29; ++i) writer.u32(100 + i);
  return std::move(writer).take();
}

TEST(Progs, ReadsHandMadeFile) {
  const auto progs = read_progs(smallest_program());
  ASSERT_TRUE(progs.ok()) << progs.error().message();
  EXPECT_EQ(progs->crc, kQuakeProgsCrc);
  ASSERT_EQ(progs->statements.size(), 2u);
  EXPECT_EQ(progs->statements[1], (ProgsStatement{43, {28, 0, 0xffff}}));
  ASSERT_EQ(progs->globals.size(), 1u);
  EXPECT_EQ(progs->globals[0], (ProgsDefinition{ProgsType::kFloat, true, 28, 1}));
  EXPECT_EQ(progs->string_at(1), "t");
  ASSERT_EQ(progs->functions.size(), 2u);
  EXPECT_EQ(progs->functions[1], (ProgsFunction{1, 28, 1, 3, 5, 1, {1}}));
  EXPECT_EQ(progs->global_words[28], 128u);
}

TEST(Progs, RoundTrips) {
  const Progs progs = small_program();
  const auto back = read_progs(write_progs(progs));
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(*back, progs);
}

TEST(Progs, RejectsEveryTruncation) {
  for (const base::ByteVector& file : {smallest_program(), write_progs(small_program())}) {
    test::for_each_truncation(file, [](const base::ByteVector& bytes) {
      EXPECT_THAT(error_of_progs(bytes),
                  HasSubstr(bytes.size() < kProgsHeaderBytes ? "header of 60 bytes" : "past the end"));
    });
  }
}

TEST(Progs, FlippedBitsFailOrRoundTrip) {
  const base::ByteVector file = write_progs(small_program());
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    test::Random random(seed);
    const auto progs = read_progs(test::with_flipped_bits(file, random));
    if (!progs.ok()) continue;
    const auto back = read_progs(write_progs(*progs));
    ASSERT_TRUE(back.ok()) << seed;
    EXPECT_EQ(*back, *progs) << seed;
  }
}

TEST(Progs, RejectsOtherVersions) {
  for (const std::int32_t version : {0, 3, 5, 8, -1})
    EXPECT_THAT(error_of_progs(test::with_number(smallest_program(), 0, version)),
                HasSubstr("only versions 6 and 7"));
}

TEST(Progs, RejectsCountsBeyondFile) {
  const base::ByteVector file = write_progs(small_program());
  for (const std::size_t at : {kStatementsAt, kGlobalsAt, kFieldsAt, kFunctionsAt, kStringsAt, kWordsAt}) {
    for (const std::uint32_t count : {1u << 31, 0xffffffffu, 1u << 20})
      EXPECT_THAT(error_of_progs(test::with_number(file, at + 4, count)),
                  HasSubstr("past the end of the file"));
    EXPECT_THAT(error_of_progs(test::with_number(file, at, 0xffffffffu)),
                HasSubstr("past the end of the file"));
  }
  EXPECT_EQ(error_of_progs(test::with_number(file, kStatementsAt + 4, 0)), "no statements");
  EXPECT_EQ(error_of_progs(test::with_number(file, kFunctionsAt + 4, 0)), "no functions");
  EXPECT_THAT(error_of_progs(test::with_number(file, kEntityWordsAt, 1u << 31)),
              HasSubstr("2147483648 words per entity"));
}

TEST(Progs, AddsMissingZerosAroundStrings) {
  const base::ByteVector file = smallest_program();
  const std::size_t at = section(file, kStringsAt);
  const auto first = read_progs(test::with_number<std::uint8_t>(file, at, 'x')),
             last = read_progs(test::with_number<std::uint8_t>(file, at + 6, 'x')),
             none = read_progs(test::with_number(file, kStringsAt + 4, 0));
  ASSERT_TRUE(first.ok() && last.ok() && none.ok());
  EXPECT_EQ(first->strings, read_progs(file)->strings);
  EXPECT_EQ(last->string_at(5), "qx");
  EXPECT_EQ(none->strings, std::string(1, '\0'));
  EXPECT_EQ(none->string_at(none->functions[1].name), "");
}

TEST(Progs, AddsMissingReservedWords) {
  const base::ByteVector file = test::with_number(smallest_program(), kWordsAt + 4, 27);
  EXPECT_THAT(error_of_progs(file), HasSubstr("its 1 locals are at global word 28 of 28"));
  const std::size_t main = section(file, kFunctionsAt) + 36;
  const auto progs = read_progs(test::with_number(file, main + 4, 27));
  ASSERT_TRUE(progs.ok()) << progs.error().message();
  EXPECT_EQ(progs->global_words.size(), 28u);
  EXPECT_EQ(progs->global_words[27], 0u);
}

// fteqcc writes them for structs, arrays, and integers.
TEST(Progs, KeepsDefinitionsOfUnknownTypes) {
  Progs progs = small_program();
  for (const std::uint16_t type : std::initializer_list<std::uint16_t>{8, 14, 20, 0x7fff}) {
    progs.globals[0].type = ProgsType{type};
    progs.fields[0].type = ProgsType{type};
    const auto read = read_progs(write_progs(progs));
    ASSERT_TRUE(read.ok()) << read.error().what;
    EXPECT_EQ(*read, progs) << type;
    EXPECT_EQ(value_words(read->globals[0].type), 0u) << type;
  }
}

// They are only debug information; all keep their places, because LNO files count them.
TEST(Progs, ClearsDefinitionsOutOfRange) {
  const base::ByteVector file = write_progs(small_program());
  const std::size_t global = section(file, kGlobalsAt), field = section(file, kFieldsAt);
  const auto past_globals = read_progs(test::with_number<std::uint16_t>(file, global + 2, 0xffff)),
             past_entity = read_progs(test::with_number<std::uint16_t>(file, field + 2, 4)),
             vector_past_entity = read_progs(test::with_number<std::uint16_t>(file, field + 10, 2)),
             unnamed = read_progs(test::with_number(file, global + 4, 0x7fffffff));
  ASSERT_TRUE(past_globals.ok() && past_entity.ok() && vector_past_entity.ok() && unnamed.ok());
  EXPECT_EQ(past_globals->globals[0], ProgsDefinition{});
  EXPECT_EQ(past_entity->fields[0], ProgsDefinition{});
  EXPECT_EQ(vector_past_entity->fields[1], ProgsDefinition{});
  EXPECT_EQ(vector_past_entity->fields.size(), 2u);
  EXPECT_EQ(unnamed->globals[0], (ProgsDefinition{ProgsType::kFloat, true, 28, 0}));
}

TEST(Progs, RejectsFunctionsOutOfRange) {
  const base::ByteVector file = write_progs(small_program());
  const std::size_t main = section(file, kFunctionsAt) + 2 * 36;
  EXPECT_THAT(error_of_progs(test::with_number(file, main, 2)), HasSubstr("starts at statement 2 of 2"));
  EXPECT_THAT(error_of_progs(test::with_number(file, main, 0x7fffffff)), HasSubstr("starts at statement"));
  for (const std::uint32_t first_local : {1000u, 0xffffffffu})
    EXPECT_THAT(error_of_progs(test::with_number(file, main + 4, first_local)),
                HasSubstr("its 6 locals are at"));
  EXPECT_THAT(error_of_progs(test::with_number(file, main + 8, 0xffffffffu)),
              HasSubstr("4294967295 locals are at"));
  EXPECT_THAT(error_of_progs(test::with_number<std::uint8_t>(file, main + 29, 255)),
              HasSubstr("\"main\": parameter 1 has 255 words, but there are only"));
  // The parameters alone do not fit.
  base::ByteVector tight = test::with_number(
      file, main + 4, static_cast<std::uint32_t>(read_progs(file)->global_words.size() - 3));
  tight = test::with_number(tight, main + 8, 0);
  EXPECT_THAT(error_of_progs(tight), HasSubstr("its 4 locals are at"));
}

TEST(Progs, KeepsOddFunctions) {
  const base::ByteVector file = write_progs(small_program());
  const std::size_t main = section(file, kFunctionsAt) + 2 * 36;
  for (const std::size_t field : {std::size_t{16}, std::size_t{20}}) {
    const auto progs = read_progs(test::with_number(file, main + field, 0xffffffffu));
    ASSERT_TRUE(progs.ok()) << progs.error().message();
    EXPECT_EQ(field == 16 ? progs->functions[2].name : progs->functions[2].file, 0u);
  }
  const auto many = read_progs(test::with_number(file, main + 24, 9));
  ASSERT_TRUE(many.ok()) << many.error().message();
  EXPECT_EQ(many->functions[2].parameter_count, 8);
  // A struct.
  const auto wide = read_progs(test::with_number<std::uint8_t>(file, main + 28, 4));
  ASSERT_TRUE(wide.ok()) << wide.error().message();
  EXPECT_EQ(wide->functions[2].parameter_words[0], 4);
}

TEST(Progs, EndlessNamesAreEmpty) {
  for (const std::size_t chars : {1024u, 1025u, 100'000u}) {
    Progs progs = small_program();
    const auto name = static_cast<std::uint32_t>(progs.strings.size());
    progs.globals[0].name = progs.functions[1].file = name;
    progs.strings += std::string(chars, 'x') + '\0';
    const auto read = read_progs(write_progs(progs));
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(read->globals[0].name, chars > 1024 ? 0 : name);
    EXPECT_EQ(read->functions[1].file, chars > 1024 ? 0 : name);
  }
}

TEST(Progs, LayoutsOfVersion7RoundTrip) {
  for (const ProgsLayout layout : {ProgsLayout::kNarrow, ProgsLayout::kWide, ProgsLayout::kWideStatements}) {
    Progs progs = small_program();
    progs.version = kExtendedProgsVersion;
    progs.layout = layout;
    if (layout != ProgsLayout::kNarrow) progs.statements[1] = {43, {70000, 0xffffffff, 3}};
    if (layout == ProgsLayout::kWide) {
      progs.global_words.resize(70001);
      progs.globals[0].offset = 70000;
    }
    const base::ByteVector file = write_progs(progs);
    const auto back = read_progs(file);
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(*back, progs);
    base::ByteReader reader(file);
    reader.seek(8);
    EXPECT_EQ(reader.u32(), 92u);  // statements follow the longer header
    reader.seek(88);
    EXPECT_EQ(reader.u32(), layout == ProgsLayout::kNarrow ? 0x021b1461u
                            : layout == ProgsLayout::kWide ? 0x65167402u
                                                           : 0u);
  }
}

TEST(Progs, BuiltinsMayBeVariadic) {
  const base::ByteVector file = write_progs(small_program());
  const std::size_t dprint = section(file, kFunctionsAt) + 36;
  const auto progs = read_progs(test::with_number(file, dprint + 24, -2));
  ASSERT_TRUE(progs.ok()) << progs.error().message();
  EXPECT_EQ(progs->functions[1].parameter_count, -2);
}

}  // namespace
}  // namespace temblor::formats
