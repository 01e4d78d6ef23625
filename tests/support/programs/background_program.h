// Another program that runs beside a test, and no longer than it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace temblor::test {

// Whether a program of this name is installed.
bool is_installed(const std::string& program);

class BackgroundProgram {
 public:
  // `arguments`: the program, found in the PATH and where Debian keeps games, and what it is given. Its home
  // is `home`; what it prints goes to home/output.txt. Nothing comes in.
  BackgroundProgram(const std::vector<std::string>& arguments, const std::filesystem::path& home);
  // Asks it and all that it started to end, and waits.
  ~BackgroundProgram();
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  std::string output() const;

 private:
  std::filesystem::path output_file_;
  pid_t process_;
};

}  // namespace temblor::test
