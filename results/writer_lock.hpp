// One writer per store: a lock that ends with the process, however it ends.
//
// The lock lies on a file of its own, FILE-lock, and not on the store: closing any descriptor of the store
// would silently drop the locks that SQLite holds on it (https://sqlite.org/howtocorrupt.html, 2.2).
#pragma once

#include <filesystem>

namespace pathrace::results {

class WriterLock {
 public:
  /// Throws InputError when another writer holds it, EnvironmentError when the lock file cannot be made.
  explicit WriterLock(const std::filesystem::path& store);
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  ~WriterLock();

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace pathrace::results
