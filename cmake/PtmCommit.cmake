# cmake -DSOURCE=folder -DHEADER=file -P PtmCommit.cmake - writes a header that says from which
# commit of git the folder is built. It is touched only when that changes, so that a build after a
# commit compiles the one source that includes it. Outside a repository of the project's own (an
# unpacked archive, also one within another repository) the commit is "unknown".
function(ask_git result)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=GIT_DIR --unset=GIT_WORK_TREE
      git -C ${SOURCE} ${ARGN}
    OUTPUT_VARIABLE text ERROR_QUIET RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    set(text "failed")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(commit unknown)
set(changed unknown)
ask_git(top rev-parse --show-toplevel)
file(REAL_PATH ${SOURCE} folder)
if(top STREQUAL folder)
  ask_git(head rev-parse --verify HEAD)
  string(LENGTH "${head}" length)
  if(head MATCHES "^[0-9a-f]+$" AND length GREATER_EQUAL 40)
    set(commit ${head})
    ask_git(status --no-optional-locks status --porcelain --untracked-files=no)
    if(status STREQUAL "")
      set(changed no)
    elseif(NOT status STREQUAL failed)
      set(changed yes)
    endif()
  endif()
endif()

set(text "// Written by cmake/PtmCommit.cmake.
#pragma once

namespace ptm::testbench {
enum class SourcesChanged { no, yes, unknown };
inline constexpr const char* kCommit = \"${commit}\";
inline constexpr SourcesChanged kChanged = SourcesChanged::${changed};
}  // namespace ptm::testbench
")
set(before "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${HEADER} "${text}")
endif()
