// Is a text well-formed XML?
#pragma once

#include <string>

namespace pathrace::testing {

/// What is wrong with an XML document of the kind that we write; empty when nothing is.
std::string xml_fault(const std::string& xml);

}  // namespace pathrace::testing
