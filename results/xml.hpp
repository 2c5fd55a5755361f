// Any text as XML text.
#pragma once

#include <string>
#include <string_view>

namespace pathrace::results {

/// Markup is escaped; control characters, which XML 1.0 does not know, and bytes that are no UTF-8 become
/// '?'. Fit for attributes in double quotes too.
std::string xml_text(std::string_view text);

}  // namespace pathrace::results
