// The program as a person runs it: arguments in; exit code, standard output and standard error out.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pathrace::testing {

struct Finished {
  int exit_code = -1;  ///< 128 + signal when it was killed
  std::string out;
  std::string err;
};

/// Runs a program to its end, without a shell, with no standard input.
Finished run_program(const std::string& program, const std::vector<std::string>& arguments);

/// Starts a program and leaves it running, its output thrown away; the caller waits for it.
pid_t start_program(const std::string& program, const std::vector<std::string>& arguments);

/// A folder that is removed with everything in it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file into it and returns its path.
  std::string file(const std::string& name, const std::string& text) const;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace pathrace::testing
