# The Open Motion Planning Library, where it is installed: its planners live in baselines/ompl, the only folder
# that sees its headers. Without it the catalogue is shorter, and nothing else changes.

find_package(ompl QUIET)
if(NOT ompl_FOUND)
  message(STATUS "libompl-dev is not installed: no planners of OMPL (ompl-rrt-connect and others)")
elseif(OMPL_VERSION VERSION_LESS 1.5 OR OMPL_VERSION VERSION_GREATER_EQUAL 1.6)
  message(STATUS "OMPL ${OMPL_VERSION} is not 1.5: no planners of OMPL (ompl-rrt-connect and others)")
  set(ompl_FOUND FALSE)
endif()

# Boost and ODE, which the library's own list of libraries names, are its private matter: it brings them along.
function(pathrace_use_ompl target)
  list(GET OMPL_LIBRARIES 0 library)
  target_compile_definitions(${target} PRIVATE PATHRACE_OMPL)
  target_include_directories(${target} SYSTEM PRIVATE ${OMPL_INCLUDE_DIRS})
  target_link_libraries(${target} PRIVATE ${library})
  # The library was built for a plain x86-64, where Eigen aligns to 16 bytes; memory changes hands.
  target_compile_definitions(${target} PRIVATE EIGEN_MAX_ALIGN_BYTES=16)
endfunction()
