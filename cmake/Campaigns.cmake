# Built-in campaigns: files of campaigns/ as entries of a C++ array, {"name", R"toml(text)toml"}.

function(pathrace_build_in_campaigns target)
  set(entries "")
  foreach(name ${ARGN})
    set(file ${PROJECT_SOURCE_DIR}/campaigns/${name}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND entries "{\"${name}\", R\"toml(${text})toml\"},\n")
  endforeach()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated)
  file(CONFIGURE OUTPUT ${folder}/bench/builtin_campaigns.inc CONTENT "@entries@" @ONLY)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
