// Files that are whole or not there: written beside their name, then renamed.
#pragma once

#include <ext/stdio_filebuf.h>

#include <filesystem>
#include <ostream>

namespace pathrace::bench {

/// FILE.part, which takes FILE's place at `commit` and goes away without it. Nobody's link is followed: a
/// file or link that is called so already is removed, and the new one is made by this process.
class OutputFile {
 public:
  /// Throws EnvironmentError when it cannot be made.
  explicit OutputFile(std::filesystem::path file);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  std::ostream& stream() { return stream_; }
  /// Throws EnvironmentError when not all could be written.
  void commit();

 private:
  std::filesystem::path file_;
  std::filesystem::path draft_;
  bool committed_ = false;
  __gnu_cxx::stdio_filebuf<char> buffer_;
  std::ostream stream_;
};

}  // namespace pathrace::bench
