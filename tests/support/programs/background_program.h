// Another program that runs during a test, and ends with it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace temblor::test {

// Returns whether a program with this name is installed.
bool is_installed(const std::string& program);

class BackgroundProgram {
 public:
  // `arguments`: the program, found in the PATH or in Debian's folder of games, and its arguments. `home` is
  // its home folder; its output goes to home/output.txt, and its input is empty.
  BackgroundProgram(const std::vector<std::string>& arguments, const std::filesystem::path& home);
  // Asks the program and everything that it started to end, and waits.
  ~BackgroundProgram();
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  std::string output() const;

 private:
  std::filesystem::path output_file_;
  pid_t process_;
};

}  // namespace temblor::test
