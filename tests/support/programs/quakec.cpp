#include "support/programs/quakec.h"

#include <cstdlib>
#include <string>

#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

bool has_quakec_compiler() {
  static const bool is_here = std::system("command -v fteqcc >/dev/null 2>&1") == 0;
  return is_here;
}

base::ByteVector compile_quakec(std::string_view source, std::string_view options) {
  const TemporaryFolder folder;
  folder.write("progs.src", "progs.dat\ntest.qc\n");
  folder.write("test.qc", source);
  folder.write("qcc.cfg", R"("MAX_REGS" "200000"
"MAX_GLOBALS" "200000")");
  const std::string path = folder.path().string();
  const int status = std::system(
      ("cd '" + path + "' && fteqcc -src . " + std::string(options) + " >compiler.log 2>&1 </dev/null")
          .c_str());
  CHECK(status == 0, "{}", base::as_text(read_file(folder.path() / "compiler.log")));
  return read_file(folder.path() / "progs.dat");
}

std::shared_ptr<const vm::Program> load_quakec(std::string_view source, std::string_view options) {
  auto progs = formats::read_progs(compile_quakec(source, options));
  CHECK(progs.ok(), "{}", progs.error().message());
  auto program = vm::Program::load(std::move(*progs));
  CHECK(program.ok(), "{}", program.error().message());
  return *program;
}

}  // namespace temblor::test
