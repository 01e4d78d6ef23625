#include "support/programs/background_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "base/check.h"

namespace temblor::test {
namespace {

constexpr const char* kPath = "/usr/local/bin:/usr/bin:/bin:/usr/games";

// Runs in the child process: becomes the program, or exits.
[[noreturn]] void become(const std::vector<std::string>& arguments, const std::filesystem::path& home,
                         const std::filesystem::path& output_file) {
  setpgid(0, 0);
  const int output = open(output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  setenv("HOME", home.c_str(), 1);
  setenv("PATH", kPath, 1);
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

}  // namespace

bool is_installed(const std::string& program) {
  return std::system(
             ("PATH=" + std::string(kPath) + " command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

BackgroundProgram::BackgroundProgram(const std::vector<std::string>& arguments,
                                     const std::filesystem::path& home)
    : output_file_(home / "output.txt"), process_(fork()) {
  CHECK(process_ >= 0, "no further process");
  if (process_ == 0) become(arguments, home, output_file_);
  setpgid(process_, process_);  // in both processes, because either may come first
}

BackgroundProgram::~BackgroundProgram() {
  kill(-process_, SIGTERM);
  for (int tries = 0; tries < 500; ++tries) {
    if (waitpid(process_, nullptr, WNOHANG) != 0) {
      kill(-process_, SIGKILL);  // processes that it started and did not end
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(-process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

std::string BackgroundProgram::output() const {
  std::ifstream file(output_file_, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace temblor::test
