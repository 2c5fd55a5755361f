# Code of README.md: what the text shows is what is built.

# pathrace_readme_example(FILE FIRST_LINE): writes the block of C++ that begins with this line.
function(pathrace_readme_example file first_line)
  set(readme ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../README.md)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${readme})
  file(READ ${readme} text)
  string(FIND "${text}" "```cpp\n${first_line}\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md: no block of C++ begins with '${first_line}'")
  endif()
  math(EXPR begin "${begin} + 7")
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "```" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  file(CONFIGURE OUTPUT ${file} CONTENT "@text@" @ONLY)  # keeps the file's time when nothing changed
endfunction()
