// Text as users give it: lines with any ending, numbers, and messages that stay one short printable line
// whatever is in the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pathrace::scenarios {

/// A value for a message: bytes other than printable ASCII as \xNN, cut with "..." after forty characters.
std::string printable(std::string_view value);

/// A file's name for a message: bytes that are no plain text as \xNN, all else as it is, never cut.
std::string printable_name(std::string_view name);

/// Throws InputError "NAME:LINE: WHAT".
[[noreturn]] void fail_at(std::string_view name, int line, std::string_view what);

/// Throws InputError "NAME: WHAT", for files without lines.
[[noreturn]] void fail_in(std::string_view name, std::string_view what);

/// Throws InputError "NAME:LINE: WHAT" for a map that OccupancyGrid does not take; without the line when it
/// is 0.
void require_map_size(std::string_view name, int line, std::int64_t width, std::int64_t height);

/// The text without UTF-8's byte order mark. Throws InputError "NAME:1: ..." for UTF-16, with its mark or
/// with every other byte zero at the beginning.
std::string_view text_of(std::string_view bytes, std::string_view name);

/// The text without blanks (spaces, tabs, carriage returns, line feeds) at its ends.
std::string_view trimmed(std::string_view text);

/// The text at each of the separators; empty pieces are kept.
std::vector<std::string_view> split_at(std::string_view text, char separator);

/// The runs of characters between blanks.
std::vector<std::string_view> split_at_blanks(std::string_view text);

/// The number that the whole text spells, if it does and fits.
std::optional<int> whole_number(std::string_view text);
std::optional<double> real_number(std::string_view text);

/// Lines one after another, counted from 1, without their endings (LF or CRLF; CR in a text without LF).
/// Blank lines at the end of the text are no lines; whether the last line has an ending makes no difference.
class Lines {
 public:
  explicit Lines(std::string_view text);

  /// The next line, or nothing at the end.
  std::optional<std::string_view> next();
  /// Of the line that next() returned last; after the end, of the line that is missing.
  int number() const { return number_; }

 private:
  std::string_view rest_;
  char ending_;
  int number_ = 0;
};

}  // namespace pathrace::scenarios
