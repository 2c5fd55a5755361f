#include "results/writer_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/error.hpp"

namespace pathrace::results {
namespace {

int open_lock_file(const std::filesystem::path& file, const std::filesystem::path& store) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    throw EnvironmentError(
        fmt::format("{}: cannot be written ({})", store.string(), std::generic_category().message(errno)));
  }
  return descriptor;
}

// A writer that ends removes the file; whoever opened it just before holds a lock on a file without a name.
bool still_named(int descriptor, const std::filesystem::path& file) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& store) : file_(store) {
  file_ += "-lock";
  while (true) {
    descriptor_ = open_lock_file(file_, store);
    const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (!locked && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw InputError(fmt::format("{}: another run is writing to this store", store.string()));
    }
    if (!locked) return;  // a file system without locks: go on without
    if (still_named(descriptor_, file_)) return;
    ::close(descriptor_);
  }
}

void WriterLock::note(std::uint64_t rows) const {
  const std::string text = fmt::format("{:020}\n", rows);
  static_cast<void>(::pwrite(descriptor_, text.data(), text.size(), 0) == 0);  // a witness, no more
}

std::uint64_t WriterLock::noted(const std::filesystem::path& store) {
  std::filesystem::path file = store;
  file += "-lock";
  std::ifstream in(file);
  std::uint64_t rows = 0;
  return in >> rows ? rows : 0;
}

WriterLock::~WriterLock() {
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace pathrace::results
