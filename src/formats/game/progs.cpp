// Reads and writes progs.dat; progs.h shows the layout.
#include "formats/game/progs.h"

#include <algorithm>
#include <cstddef>

#include "base/text.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kProgsHeaderBytes = 60;
constexpr std::size_t kStatementBytes = 8, kDefinitionBytes = 8, kFunctionBytes = 36, kWordBytes = 4;
constexpr std::size_t kMaxProgsNameChars = 1024;
constexpr std::uint16_t kSavedBit = 0x8000;

// The place of a section in the file, and its number of entries.
struct Section {
  std::uint32_t offset = 0, count = 0;
};

struct Header {
  std::uint32_t crc = 0;
  Section statements, globals, fields, functions, strings, words;
  std::uint32_t entity_words = 0;
};

base::Result<Header> read_header(base::Bytes bytes) {
  if (bytes.size() < kProgsHeaderBytes)
    return base::malformed("{} bytes are shorter than the header of {} bytes", bytes.size(),
                           kProgsHeaderBytes);
  base::ByteReader reader(bytes);
  if (const std::int32_t version = reader.i32(); version != kProgsVersion)
    return base::error(
        base::ErrorCode::kUnsupported,
        "version {} of compiled QuakeC is not supported, only version {} (compile it without -Tfte or "
        "-Th2)",
        version, kProgsVersion);
  Header header;
  header.crc = reader.u32();
  for (Section* section : {&header.statements, &header.globals, &header.fields, &header.functions,
                           &header.strings, &header.words}) {
    section->offset = reader.u32();
    section->count = reader.u32();
  }
  header.entity_words = reader.u32();
  if (header.entity_words > kMaxEntityWords)
    return base::error(base::ErrorCode::kTooLarge, "header: {} words per entity exceed the limit of {}",
                       header.entity_words, kMaxEntityWords);
  return header;
}

// Returns a reader for a section that is inside of the file. `what` names its entries in errors.
base::Result<base::ByteReader> open_section(base::Bytes bytes, const Section& section,
                                            std::size_t entry_bytes, std::string_view what) {
  const std::uint64_t end = section.offset + std::uint64_t{section.count} * entry_bytes;
  if (end > bytes.size())
    return base::malformed("{}: {} at offset {:#x} end {} bytes past the end of the file", what,
                           section.count, section.offset, end - bytes.size());
  return base::ByteReader(bytes.subspan(section.offset, static_cast<std::size_t>(end - section.offset)));
}

base::Result<std::string> read_strings(base::Bytes bytes, const Section& section) {
  TRY(base::ByteReader reader, open_section(bytes, section, 1, "characters of strings"));
  std::string strings(base::as_text(reader.take(section.count)));
  if (strings.empty() || strings.front() != '\0' || strings.back() != '\0')
    return base::malformed("strings at offset {:#x}: must begin and end with a zero byte", section.offset);
  return strings;
}

base::Result<std::vector<std::uint32_t>> read_words(base::Bytes bytes, const Section& section) {
  if (section.count < kReservedGlobalWords)
    return base::malformed("{} global words, expected at least {}", section.count, kReservedGlobalWords);
  TRY(base::ByteReader reader, open_section(bytes, section, kWordBytes, "global words"));
  std::vector<std::uint32_t> words(section.count);
  for (std::uint32_t& word : words) word = reader.u32();
  return words;
}

// Returns the name at `offset`. The length limit keeps hostile files from being slow to read.
base::Result<std::string_view> name_at(std::string_view strings, std::uint32_t offset) {
  if (offset >= strings.size())
    return base::malformed("the name or file is at character {} of {}", offset, strings.size());
  const std::string_view rest = strings.substr(offset, kMaxProgsNameChars + 1);
  const std::size_t end = rest.find('\0');
  if (end == std::string_view::npos)
    return base::error(base::ErrorCode::kTooLarge, "the name or file has more than {} characters",
                       kMaxProgsNameChars);
  return rest.substr(0, end);
}

// Adds the entry to an error that describes only the problem.
base::Error add_entry(std::string_view what, std::size_t number, const base::Error& error) {
  return base::error(error.code, "{} {}: {}", what, number, error.what);
}

base::Result<std::vector<ProgsStatement>> read_statements(base::Bytes bytes, const Section& section) {
  if (section.count == 0) return base::malformed("no statements");
  TRY(base::ByteReader reader, open_section(bytes, section, kStatementBytes, "statements"));
  std::vector<ProgsStatement> statements(section.count);
  for (ProgsStatement& statement : statements) {
    statement.op = reader.u16();
    for (std::uint16_t& operand : statement.operands) operand = reader.u16();
  }
  return statements;
}

// `words`: limit for the offsets of the definitions.
base::Result<std::vector<ProgsDefinition>> read_definitions(base::Bytes bytes, const Section& section,
                                                            std::string_view what, std::size_t words,
                                                            std::string_view strings) {
  TRY(base::ByteReader reader, open_section(bytes, section, kDefinitionBytes, what));
  std::vector<ProgsDefinition> definitions(section.count);
  for (std::size_t i = 0; i < definitions.size(); ++i) {
    ProgsDefinition& definition = definitions[i];
    const std::uint16_t type = reader.u16();
    definition.offset = reader.u16();
    definition.name = reader.u32();
    const auto name = name_at(strings, definition.name);
    if (!name.ok()) return add_entry(what, i, name.error());
    definition.type = static_cast<ProgsType>(type & ~kSavedBit);
    definition.is_saved = (type & kSavedBit) != 0;
    if (definition.offset + value_words(definition.type) > words)
      return base::malformed("{} {} (\"{}\"): the offset is word {} of {}", what, i, base::quotable(*name),
                             definition.offset, words);
  }
  return definitions;
}

// Checks the first statement, the locals, and the parameters of a function with statements.
base::Status check_body(const ProgsFunction& function, const Progs& progs) {
  const auto first = static_cast<std::size_t>(function.first_statement);
  if (first >= progs.statements.size())
    return base::malformed("starts at statement {} of {}", first, progs.statements.size());
  if (function.parameter_count > kMaxParameters)
    return base::malformed("{} parameters exceed the limit of {}", function.parameter_count, kMaxParameters);
  std::uint64_t parameter_words = 0;
  for (std::int32_t i = 0; i < function.parameter_count; ++i) {
    const std::uint8_t words = function.parameter_words[static_cast<std::size_t>(i)];
    if (words > 3) return base::malformed("parameter {} has {} words, expected at most 3", i, words);
    parameter_words += words;
  }
  const std::uint64_t words = std::max<std::uint64_t>(function.local_count, parameter_words);
  if (function.first_local + words > progs.global_words.size())
    return base::malformed("its {} locals are at global word {} of {}", words, function.first_local,
                           progs.global_words.size());
  return base::Ok{};
}

// Built-in functions have no body: compilers leave any values in their other fields.
base::Status check_function(const ProgsFunction& function, const Progs& progs) {
  TRY(const std::string_view name, name_at(progs.strings, function.name));
  TRY_STATUS(name_at(progs.strings, function.file));
  if (function.first_statement <= 0) return base::Ok{};
  base::Status status = check_body(function, progs);
  if (!status.ok())
    return base::error(status.error().code, "\"{}\": {}", base::quotable(name), status.error().what);
  return status;
}

base::Result<std::vector<ProgsFunction>> read_functions(base::Bytes bytes, const Section& section,
                                                        const Progs& progs) {
  if (section.count == 0) return base::malformed("no functions");
  TRY(base::ByteReader reader, open_section(bytes, section, kFunctionBytes, "functions"));
  std::vector<ProgsFunction> functions(section.count);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    ProgsFunction& function = functions[i];
    function.first_statement = reader.i32();
    function.first_local = reader.u32();
    function.local_count = reader.u32();
    reader.u32();  // profile counter of the original engine, used only in memory
    function.name = reader.u32();
    function.file = reader.u32();
    function.parameter_count = reader.i32();
    for (std::uint8_t& words : function.parameter_words) words = reader.u8();
    if (const auto status = check_function(function, progs); !status.ok())
      return add_entry("function", i, status.error());
  }
  return functions;
}

void write_definitions(base::ByteWriter& io_writer, const std::vector<ProgsDefinition>& definitions) {
  for (const ProgsDefinition& definition : definitions) {
    const auto type = static_cast<std::uint16_t>(definition.type);
    io_writer.u16(definition.is_saved ? static_cast<std::uint16_t>(type | kSavedBit) : type);
    io_writer.u16(definition.offset);
    io_writer.u32(definition.name);
  }
}

void write_functions(base::ByteWriter& io_writer, const std::vector<ProgsFunction>& functions) {
  for (const ProgsFunction& function : functions) {
    io_writer.i32(function.first_statement);
    io_writer.u32(function.first_local);
    io_writer.u32(function.local_count);
    io_writer.u32(0);
    io_writer.u32(function.name);
    io_writer.u32(function.file);
    io_writer.i32(function.parameter_count);
    for (const std::uint8_t words : function.parameter_words) io_writer.u8(words);
  }
}

void write_header(base::ByteWriter& io_writer, const Progs& progs) {
  io_writer.i32(kProgsVersion);
  io_writer.u32(progs.crc);
  std::size_t offset = kProgsHeaderBytes;
  const auto section = [&](std::size_t count, std::size_t entry_bytes) {
    io_writer.u32(static_cast<std::uint32_t>(offset));
    io_writer.u32(static_cast<std::uint32_t>(count));
    offset += count * entry_bytes;
  };
  // In this order, the sections follow the header without gaps.
  section(progs.statements.size(), kStatementBytes);
  section(progs.globals.size(), kDefinitionBytes);
  section(progs.fields.size(), kDefinitionBytes);
  section(progs.functions.size(), kFunctionBytes);
  section(progs.strings.size(), 1);
  section(progs.global_words.size(), kWordBytes);
  io_writer.u32(progs.entity_words);
}

}  // namespace

base::Result<Progs> read_progs(base::Bytes bytes) {
  TRY(const Header header, read_header(bytes));
  Progs progs;
  progs.crc = header.crc;
  progs.entity_words = header.entity_words;
  TRY(progs.strings, read_strings(bytes, header.strings));
  TRY(progs.global_words, read_words(bytes, header.words));
  TRY(progs.statements, read_statements(bytes, header.statements));
  TRY(progs.globals,
      read_definitions(bytes, header.globals, "global", progs.global_words.size(), progs.strings));
  TRY(progs.fields, read_definitions(bytes, header.fields, "field", progs.entity_words, progs.strings));
  TRY(progs.functions, read_functions(bytes, header.functions, progs));
  return progs;
}

base::ByteVector write_progs(const Progs& progs) {
  base::ByteWriter writer;
  write_header(writer, progs);
  for (const ProgsStatement& statement : progs.statements) {
    writer.u16(statement.op);
    for (const std::uint16_t operand : statement.operands) writer.u16(operand);
  }
  write_definitions(writer, progs.globals);
  write_definitions(writer, progs.fields);
  write_functions(writer, progs.functions);
  writer.bytes(base::as_bytes(progs.strings));
  for (const std::uint32_t word : progs.global_words) writer.u32(word);
  return std::move(writer).take();
}

}  // namespace temblor::formats
