#include "bench/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace pathrace::bench {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw EnvironmentError(fmt::format("{}: cannot be written: {}", file.string(),
                                     std::generic_category().message(error != 0 ? error : EIO)));
}

int make_draft(const std::filesystem::path& draft, const std::filesystem::path& file) {
  ::unlink(draft.c_str());
  const int descriptor = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(file, errno);
  return descriptor;
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path file)
    : file_(std::move(file)),
      draft_(file_.string() + ".part"),
      buffer_(make_draft(draft_, file_), std::ios::out | std::ios::binary),
      stream_(&buffer_) {}

OutputFile::~OutputFile() {
  if (!committed_) ::unlink(draft_.c_str());
}

void OutputFile::commit() {
  errno = 0;
  stream_.flush();
  if (!stream_ || buffer_.close() == nullptr) fail(file_, errno);
  if (::rename(draft_.c_str(), file_.c_str()) != 0) fail(file_, errno);
  committed_ = true;
}

}  // namespace pathrace::bench
