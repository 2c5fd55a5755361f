// The bytes of a file a user named, and a clear line when there are none to be had.
//
// What the user can mend (no such file, a folder) is an InputError, what the machine refuses (permission, a
// failing disk) an EnvironmentError. Only regular files are read: a pipe could wait for ever, a device never
// end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pathrace::scenarios {

/// Size of a regular file in bytes. Throws InputError or EnvironmentError for anything else.
std::uintmax_t size_of_file(const std::filesystem::path& file);

/// The first `count` bytes of the file, in one go; fewer when it holds fewer.
std::string first_bytes(const std::filesystem::path& file, std::uintmax_t count);

/// The whole file. Throws InputError "FILE: holds N bytes, expected at most MOST" for a larger one, unread.
std::string whole_file(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace pathrace::scenarios
