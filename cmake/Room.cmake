# A room is a top-level folder, a static library `pathrace_<room>` and the target `pathrace::<room>`.
# Sources and headers are found in the folder, so that a new planner is one file and one line in a list.

function(pathrace_build_flags target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # g++ 12 sees overlaps in std::string that are not there
    -ffp-contract=off
    $<$<CONFIG:Release>:-O3>)
  if(PATHRACE_ARCH)
    target_compile_options(${target} PRIVATE -march=${PATHRACE_ARCH})
  endif()
  if(PATHRACE_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${PATHRACE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # false ones, once sanitizers have been woven in
    target_link_options(${target} PRIVATE -fsanitize=${PATHRACE_SANITIZE})
  endif()
endfunction()

function(pathrace_room room)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/${room})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${folder}/*.hpp)
  list(FILTER sources EXCLUDE REGEX "/bench/(main\\.cpp$|api/|cli/|micro/)")
  list(FILTER headers EXCLUDE REGEX "/(bench/cli|baselines/ompl)/")  # they need libraries that are private
  list(FILTER headers EXCLUDE REGEX "/bench/api/")  # of a library of its own
  if(NOT ompl_FOUND)
    list(FILTER sources EXCLUDE REGEX "/baselines/ompl/")
  endif()

  add_library(pathrace_${room} STATIC ${sources})
  add_library(pathrace::${room} ALIAS pathrace_${room})
  set_target_properties(pathrace_${room} PROPERTIES EXPORT_NAME ${room})
  target_sources(pathrace_${room} PUBLIC
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  target_compile_features(pathrace_${room} PUBLIC cxx_std_20)
  target_link_libraries(pathrace_${room} PUBLIC ${ARG_LIBRARIES} PRIVATE ${ARG_PRIVATE_LIBRARIES})
  pathrace_build_flags(pathrace_${room})
endfunction()
