// Reads and writes progs.dat; progs.h shows the layout.
#include "formats/game/progs.h"

#include <algorithm>
#include <cstddef>

#include "base/text.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kProgsHeaderBytes = 60;
constexpr std::size_t kExtendedHeaderBytes = 32, kLayoutNumberOffset = kProgsHeaderBytes + 28;
constexpr std::uint32_t kNarrowLayoutNumber = 0x021b1461, kWideLayoutNumber = 0x65167402;
constexpr std::size_t kFunctionBytes = 36, kWordBytes = 4;
constexpr std::size_t kMaxProgsNameChars = 1024;
constexpr std::uint16_t kSavedBit = 0x8000;
constexpr std::size_t kFirstParameterWord = 4, kParameterStride = 3;  // among the reserved global words

// The place of a section in the file, and its number of entries.
struct Section {
  std::uint32_t offset = 0, count = 0;
};

struct Header {
  std::int32_t version = 0;
  ProgsLayout layout = ProgsLayout::kNarrow;
  std::uint32_t crc = 0;
  Section statements, globals, fields, functions, strings, words;
  std::uint32_t entity_words = 0;
};

std::size_t statement_bytes(ProgsLayout layout) {
  return layout == ProgsLayout::kNarrow ? 8 : 16;
}
std::size_t definition_bytes(ProgsLayout layout) {
  return layout == ProgsLayout::kWide ? 12 : 8;
}

ProgsLayout read_layout(base::Bytes bytes, std::int32_t version) {
  if (version == kProgsVersion) return ProgsLayout::kNarrow;
  if (bytes.size() < kProgsHeaderBytes + kExtendedHeaderBytes) return ProgsLayout::kWideStatements;
  const std::uint32_t number = base::ByteReader(bytes.subspan(kLayoutNumberOffset)).u32();
  if (number == kNarrowLayoutNumber) return ProgsLayout::kNarrow;
  return number == kWideLayoutNumber ? ProgsLayout::kWide : ProgsLayout::kWideStatements;
}

base::Result<Header> read_header(base::Bytes bytes) {
  if (bytes.size() < kProgsHeaderBytes)
    return base::malformed("{} bytes are shorter than the header of {} bytes", bytes.size(),
                           kProgsHeaderBytes);
  base::ByteReader reader(bytes);
  Header header;
  header.version = reader.i32();
  if (header.version != kProgsVersion && header.version != kExtendedProgsVersion)
    return base::error(base::ErrorCode::kUnsupported,
                       "version {} of compiled QuakeC is not supported, only versions {} and {} (compile it "
                       "with fteqcc, without a target or with -Tfte)",
                       header.version, kProgsVersion, kExtendedProgsVersion);
  header.layout = read_layout(bytes, header.version);
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
  if (strings.empty() || strings.back() != '\0') strings.push_back('\0');
  strings.front() = '\0';
  return strings;
}

base::Result<std::vector<std::uint32_t>> read_words(base::Bytes bytes, const Section& section) {
  TRY(base::ByteReader reader, open_section(bytes, section, kWordBytes, "global words"));
  std::vector<std::uint32_t> words(section.count);
  for (std::uint32_t& word : words) word = reader.u32();
  words.resize(std::max<std::size_t>(words.size(), kReservedGlobalWords));
  return words;
}

// Returns `offset` if there is a name, otherwise that of the empty string. The length limit keeps hostile
// files from being slow to read.
std::uint32_t valid_name(std::string_view strings, std::uint32_t offset) {
  if (offset >= strings.size()) return 0;
  return strings.substr(offset, kMaxProgsNameChars + 1).find('\0') == std::string_view::npos ? 0 : offset;
}

// Adds the entry to an error that describes only the problem.
base::Error add_entry(std::string_view what, std::size_t number, const base::Error& error) {
  return base::error(error.code, "{} {}: {}", what, number, error.what);
}

base::Result<std::vector<ProgsStatement>> read_statements(base::Bytes bytes, const Section& section,
                                                          ProgsLayout layout) {
  if (section.count == 0) return base::malformed("no statements");
  TRY(base::ByteReader reader, open_section(bytes, section, statement_bytes(layout), "statements"));
  const auto read_number = [&] {
    return layout == ProgsLayout::kNarrow ? std::uint32_t{reader.u16()} : reader.u32();
  };
  std::vector<ProgsStatement> statements(section.count);
  for (ProgsStatement& statement : statements) {
    statement.op = read_number();
    for (std::uint32_t& operand : statement.operands) operand = read_number();
  }
  return statements;
}

// `words`: limit for the offsets of the definitions. All entries are kept, because the file of line numbers
// counts them.
base::Result<std::vector<ProgsDefinition>> read_definitions(base::Bytes bytes, const Section& section,
                                                            std::string_view what, std::size_t words,
                                                            const Progs& progs) {
  TRY(base::ByteReader reader, open_section(bytes, section, definition_bytes(progs.layout), what));
  const bool is_wide = progs.layout == ProgsLayout::kWide;
  std::vector<ProgsDefinition> definitions(section.count);
  for (ProgsDefinition& definition : definitions) {
    const auto type = static_cast<std::uint16_t>(is_wide ? reader.u32() : reader.u16());
    definition.offset = is_wide ? reader.u32() : reader.u16();
    definition.name = valid_name(progs.strings, reader.u32());
    definition.type = static_cast<ProgsType>(type & ~kSavedBit);
    definition.is_saved = (type & kSavedBit) != 0;
    if (std::uint64_t{definition.offset} + value_words(definition.type) > words)
      definition = {ProgsType::kVoid, false, 0, 0};
  }
  return definitions;
}

// Checks the first statement, the locals, and the parameters of a function with statements.
base::Status check_body(const ProgsFunction& function, const Progs& progs) {
  const auto first = static_cast<std::size_t>(function.first_statement);
  if (first >= progs.statements.size())
    return base::malformed("starts at statement {} of {}", first, progs.statements.size());
  std::uint64_t parameter_words = 0;
  for (std::size_t i = 0; static_cast<std::int32_t>(i) < function.parameter_count; ++i) {
    const std::size_t words = function.parameter_words[i];
    if (kFirstParameterWord + kParameterStride * i + words > progs.global_words.size())
      return base::malformed("parameter {} has {} words, but there are only {} global words", i, words,
                             progs.global_words.size());
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
  if (function.first_statement <= 0) return base::Ok{};
  base::Status status = check_body(function, progs);
  if (!status.ok())
    return base::error(status.error().code, "\"{}\": {}", base::quotable(progs.string_at(function.name)),
                       status.error().what);
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
    function.name = valid_name(progs.strings, reader.u32());
    function.file = valid_name(progs.strings, reader.u32());
    function.parameter_count = std::min(reader.i32(), kMaxParameters);
    for (std::uint8_t& words : function.parameter_words) words = reader.u8();
    if (const auto status = check_function(function, progs); !status.ok())
      return add_entry("function", i, status.error());
  }
  return functions;
}

void write_number(base::ByteWriter& io_writer, std::uint32_t number, bool is_wide) {
  if (is_wide)
    io_writer.u32(number);
  else
    io_writer.u16(static_cast<std::uint16_t>(number));
}

void write_definitions(base::ByteWriter& io_writer, const std::vector<ProgsDefinition>& definitions,
                       ProgsLayout layout) {
  const bool is_wide = layout == ProgsLayout::kWide;
  for (const ProgsDefinition& definition : definitions) {
    const auto type = static_cast<std::uint32_t>(definition.type);
    write_number(io_writer, definition.is_saved ? type | kSavedBit : type, is_wide);
    write_number(io_writer, definition.offset, is_wide);
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
  io_writer.i32(progs.version);
  io_writer.u32(progs.crc);
  const bool is_extended = progs.version == kExtendedProgsVersion;
  std::size_t offset = kProgsHeaderBytes + (is_extended ? kExtendedHeaderBytes : 0);
  const auto section = [&](std::size_t count, std::size_t entry_bytes) {
    io_writer.u32(static_cast<std::uint32_t>(offset));
    io_writer.u32(static_cast<std::uint32_t>(count));
    offset += count * entry_bytes;
  };
  // In this order, the sections follow the header without gaps.
  section(progs.statements.size(), statement_bytes(progs.layout));
  section(progs.globals.size(), definition_bytes(progs.layout));
  section(progs.fields.size(), definition_bytes(progs.layout));
  section(progs.functions.size(), kFunctionBytes);
  section(progs.strings.size(), 1);
  section(progs.global_words.size(), kWordBytes);
  io_writer.u32(progs.entity_words);
  if (!is_extended) return;
  for (std::size_t at = kProgsHeaderBytes; at < kLayoutNumberOffset; at += kWordBytes) io_writer.u32(0);
  io_writer.u32(progs.layout == ProgsLayout::kNarrow ? kNarrowLayoutNumber
                : progs.layout == ProgsLayout::kWide ? kWideLayoutNumber
                                                     : 0);
}

}  // namespace

base::Result<Progs> read_progs(base::Bytes bytes) {
  TRY(const Header header, read_header(bytes));
  Progs progs;
  progs.version = header.version;
  progs.layout = header.layout;
  progs.crc = header.crc;
  progs.entity_words = header.entity_words;
  TRY(progs.strings, read_strings(bytes, header.strings));
  TRY(progs.global_words, read_words(bytes, header.words));
  TRY(progs.statements, read_statements(bytes, header.statements, header.layout));
  TRY(progs.globals, read_definitions(bytes, header.globals, "global", progs.global_words.size(), progs));
  TRY(progs.fields, read_definitions(bytes, header.fields, "field", progs.entity_words, progs));
  TRY(progs.functions, read_functions(bytes, header.functions, progs));
  return progs;
}

base::ByteVector write_progs(const Progs& progs) {
  base::ByteWriter writer;
  write_header(writer, progs);
  const bool is_wide = progs.layout != ProgsLayout::kNarrow;
  for (const ProgsStatement& statement : progs.statements) {
    write_number(writer, statement.op, is_wide);
    for (const std::uint32_t operand : statement.operands) write_number(writer, operand, is_wide);
  }
  write_definitions(writer, progs.globals, progs.layout);
  write_definitions(writer, progs.fields, progs.layout);
  write_functions(writer, progs.functions);
  writer.bytes(base::as_bytes(progs.strings));
  for (const std::uint32_t word : progs.global_words) writer.u32(word);
  return std::move(writer).take();
}

}  // namespace temblor::formats
