# What a run says about its build: version, state of the source tree when it was configured, flags.

find_package(Git QUIET)
set(source_state "")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty
                  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                  OUTPUT_VARIABLE source_state OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  string(APPEND flags " -O3")
endif()
if(PATHRACE_ARCH)
  string(APPEND flags " -march=${PATHRACE_ARCH}")
endif()
if(PATHRACE_SANITIZE)
  string(APPEND flags " -fsanitize=${PATHRACE_SANITIZE}")
endif()
string(STRIP "${flags} -ffp-contract=off" flags)

set_property(SOURCE bench/machine.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  PATHRACE_VERSION="${PROJECT_VERSION}" PATHRACE_SOURCE_STATE="${source_state}" PATHRACE_FLAGS="${flags}"
  PATHRACE_OMPL_VERSION="${OMPL_VERSION}")
