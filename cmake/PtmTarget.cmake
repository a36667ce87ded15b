# Targets of this project: C++20, every warning an error, headers named from the project's root
# (`#include "golden/files/ptm_file.h"`), so that the layering test can read who includes whom.

set(PTM_WARNINGS
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion
  # GCC is the compiler of record; clang, which only the fuzz preset uses, warns of other things.
  $<$<CXX_COMPILER_ID:GNU>:-Werror>)
add_library(ptm_options INTERFACE)
target_include_directories(ptm_options INTERFACE ${CMAKE_SOURCE_DIR} ${PTM_GENERATED}
  ${PTM_EFFECTS_EXTRA})
target_compile_options(ptm_options INTERFACE ${PTM_WARNINGS})
if(PTM_SANITIZE)
  add_compile_options(-fsanitize=${PTM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${PTM_SANITIZE})
  # GCC's manual: sanitizers make it warn falsely. <regex> alone stops a build with -Werror.
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>
                      $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>)
endif()

# ptm_library(name source... ) - a static library with the project's options.
function(ptm_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC ptm_options)
endfunction()

# ptm_system_includes(target dependency...) - headers of a dependency, without its warnings.
function(ptm_system_includes target)
  foreach(dependency IN LISTS ARGN)
    get_target_property(dirs ${dependency} INTERFACE_INCLUDE_DIRECTORIES)
    if(dirs)
      target_include_directories(${target} SYSTEM PUBLIC ${dirs})
    endif()
  endforeach()
endfunction()

# ptm_precompiled(target header...) - compiles headers of the standard library and of dependencies
# once for all of a target's sources. Sources still include what they use.
function(ptm_precompiled target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  # A source with other options reads the headers themselves.
  set_target_properties(${target} PROPERTIES PCH_WARN_INVALID OFF)
endfunction()
