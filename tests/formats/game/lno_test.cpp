#include "formats/game/lno.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mutations.h"
#include "support/programs/progs_builder.h"

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Progs program_with_lines() {
  test::ProgsBuilder builder;
  builder.named("time", ProgsType::kFloat);
  builder.function("main");
  builder.emit(vm::Opcode::kDone);
  return builder.progs();
}

base::ByteVector list_lines(const Progs& progs) {
  std::vector<std::size_t> numbers = {
      1, progs.globals.size(), progs.global_words.size(), progs.fields.size(), progs.statements.size(), 0,
      12};
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("LNOF"));
  for (const std::size_t number : numbers) writer.u32(static_cast<std::uint32_t>(number));
  return std::move(writer).take();
}

TEST(Lno, ReadsLineOfEachStatement) {
  const Progs progs = program_with_lines();
  const auto lines = read_lno(list_lines(progs), progs);
  ASSERT_TRUE(lines.ok()) << lines.error().message();
  EXPECT_THAT(*lines, ElementsAre(0, 12));
}

TEST(Lno, RejectsEveryTruncation) {
  const Progs progs = program_with_lines();
  test::for_each_truncation(list_lines(progs), [&](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_lno(bytes, progs).ok()) << bytes.size();
  });
}

TEST(Lno, RejectsOtherProgram) {
  const Progs progs = program_with_lines();
  const base::ByteVector valid = list_lines(progs);
  for (const std::size_t at : {8u, 12u, 16u, 20u})
    for (const std::uint32_t count : {77u, 0xffffffffu})
      EXPECT_THAT(read_lno(test::with_number(valid, at, count), progs).error().what,
                  HasSubstr("belong to another program"));
  EXPECT_THAT(read_lno(test::with_number(valid, 4, 2), progs).error().what, HasSubstr("version 2"));
  EXPECT_THAT(read_lno(test::with_number(valid, 0, 0), progs).error().what, HasSubstr("LNOF"));
}

}  // namespace
}  // namespace temblor::formats
