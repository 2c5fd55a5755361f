#include "scenarios/file_bytes.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/error.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

std::string message(const fs::path& file, std::string_view what) {
  return fmt::format("{}: {}", printable_name(file.string()), what);
}

// A name that cannot be a file's is the user's; the rest is the machine's.
[[noreturn]] void refuse(const fs::path& file, const std::error_code& why) {
  const std::string text = message(file, "cannot be read: " + why.message());
  if (why == std::errc::filename_too_long || why == std::errc::too_many_symbolic_link_levels) {
    throw InputError(text);
  }
  throw EnvironmentError(text);
}

}  // namespace

std::uintmax_t size_of_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputError(message(file, "no such file"));
  if (error) refuse(file, error);
  if (fs::is_directory(status)) throw InputError(message(file, "is a folder; expected a file"));
  if (!fs::is_regular_file(status)) throw InputError(message(file, "is not a regular file; expected one"));
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) refuse(file, error);
  return size;
}

std::string first_bytes(const fs::path& file, std::uintmax_t count) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(file, std::error_code(errno == 0 ? EIO : errno, std::generic_category()));
  std::string bytes(static_cast<std::size_t>(count), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  if (in.bad()) refuse(file, std::make_error_code(std::errc::io_error));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::string whole_file(const fs::path& file, std::uintmax_t most) {
  const std::uintmax_t size = size_of_file(file);
  if (size > most) {
    throw InputError(message(file, fmt::format("holds {} bytes; expected at most {}", size, most)));
  }
  return first_bytes(file, size);
}

}  // namespace pathrace::scenarios
