// One writer per store: a lock that ends with the process, however it ends.
//
// The lock lies on a file of its own, FILE-lock, and not on the store: closing any descriptor of the store
// would silently drop the locks that SQLite holds on it (https://sqlite.org/howtocorrupt.html, 2.2). A writer
// that ends removes it; one that was killed leaves it behind, and with it the number of rows that the store
// and its write-ahead log must have.
#pragma once

#include <cstdint>
#include <filesystem>

namespace pathrace::results {

class WriterLock {
 public:
  /// Throws InputError when another writer holds it, EnvironmentError when the lock file cannot be made.
  explicit WriterLock(const std::filesystem::path& store);
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  ~WriterLock();

  /// Writes down how many rows the store holds, for whoever finds the file of a killed writer.
  void note(std::uint64_t rows) const;
  /// What the last writer, if it was killed or is still at work, wrote down; else 0.
  static std::uint64_t noted(const std::filesystem::path& store);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace pathrace::results
