# The only place that calls Verilator.
find_program(VERILATOR verilator REQUIRED)
execute_process(COMMAND ${VERILATOR} --getenv VERILATOR_ROOT
  OUTPUT_VARIABLE VERILATOR_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
find_package(Threads REQUIRED)

# Verilator's runtime, once for all designs. Its own code is not held to our warnings, nor to the
# undefined-behaviour sanitizer (it reads and writes bit fields by unaligned casts).
# GCC writes neighbouring fields one by one, then reads them in wider pieces that wait for the
# stores: a fifth of the time of a compared cycle. Hoisted code spills registers: a fiftieth.
set(PTM_VERILATED_OPTIONS -w
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize$<SEMICOLON>-fno-code-hoisting>)
set(PTM_VERILATED_SMALL $<$<CXX_COMPILER_ID:GNU>:-fno-store-merging>)
# A unit's cycle is more code than a processor's first instruction cache holds, so the shortest code
# is the fastest (unit_bench): merged stores 0.96 of the time; no scheduling of single instructions
# and no padding in front of jumps' targets 0.98; in Verilator, wide operations as plain words, no
# look-up tables for case statements and no loops or order of its own 0.95.
set(PTM_VERILATED_UNIT $<$<CXX_COMPILER_ID:GNU>:-fno-schedule-insns2$<SEMICOLON>-fno-align-functions$<SEMICOLON>-fno-align-loops$<SEMICOLON>-fno-align-jumps$<SEMICOLON>-fno-align-labels>)
set(PTM_UNIT_FLAGS -fno-case -fno-table -fno-reloop -fno-reorder --expand-limit 256)
if(PTM_SANITIZE MATCHES "undefined")
  list(APPEND PTM_VERILATED_OPTIONS -fno-sanitize=undefined)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  list(APPEND PTM_VERILATED_OPTIONS -O1)  # at -O0 a test takes minutes
endif()
add_library(ptm_verilator_runtime STATIC
  ${VERILATOR_ROOT}/include/verilated.cpp ${VERILATOR_ROOT}/include/verilated_threads.cpp)
target_include_directories(ptm_verilator_runtime SYSTEM PUBLIC
  ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_compile_definitions(ptm_verilator_runtime PUBLIC
  VERILATOR=1 VM_COVERAGE=0 VM_SC=0 VM_TRACE=0 VM_TRACE_FST=0 VM_TRACE_VCD=0)
target_compile_options(ptm_verilator_runtime PRIVATE ${PTM_VERILATED_OPTIONS})
target_link_libraries(ptm_verilator_runtime PUBLIC Threads::Threads)

# ptm_verilate(target [MODULE] PREFIX V... TOP module SOURCES file... [LISTS list...]
#              [PARAMETERS Name=value...] [ASSERT] [HARNESS file])
# - a static library with the C++ class PREFIX of that module, as one translation unit.
# MODULE: one to be loaded by a running program, which has Verilator's runtime already. LISTS are
# read after rtl/files.f; stages of effects are found by name, the chain of this build's stages
# before the one of all. ASSERT builds the assertions of ptm_assert.svh in. HARNESS is C++ that joins
# the unit, so that the compiler can inline the design into what drives it.
function(ptm_verilate target)
  cmake_parse_arguments(arg "ASSERT;MODULE" "PREFIX;TOP;HARNESS" "SOURCES;LISTS;PARAMETERS"
    ${ARGN})
  set(lists "")
  if(arg_LISTS)
    set(lists -y ${PTM_GENERATED}/rtl -y rtl/effects)
    if(PTM_EFFECTS_EXTRA)
      list(APPEND lists -y ${PTM_EFFECTS_EXTRA}/rtl/effects)
    endif()
  endif()
  foreach(list IN LISTS arg_LISTS)
    list(APPEND lists -f ${list})
  endforeach()
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/${arg_PREFIX})
  list(TRANSFORM arg_PARAMETERS PREPEND -G)
  # What reset does not set is 0 unless a seed is given (testbench/rtl/initial_values.h).
  # Without -fno-const-bit-op-tree, Verilator 5.006 drops terms of some exclusive-or trees:
  # tests/rtl/rtl_xor_tree_test.cpp.
  set(flags --cc -O3 -fno-const-bit-op-tree --x-assign unique --x-initial unique
    -Wall -Wno-UNUSEDSIGNAL)  # the pins of the test bench are wider than a variant needs
  if(arg_ASSERT)
    list(APPEND flags --assert)
  endif()
  set(options ${PTM_VERILATED_OPTIONS})
  if(arg_LISTS)
    list(APPEND flags ${PTM_UNIT_FLAGS})
    list(APPEND options ${PTM_VERILATED_UNIT})
  else()
    list(APPEND options ${PTM_VERILATED_SMALL})
  endif()
  file(GLOB_RECURSE rtl_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/rtl/*.sv
    ${CMAKE_SOURCE_DIR}/rtl/*.svh ${CMAKE_SOURCE_DIR}/rtl/*.f ${CMAKE_SOURCE_DIR}/rtl/lint.vlt
    ${PTM_GENERATED}/rtl/*)
  add_custom_command(
    OUTPUT ${dir}/${arg_PREFIX}.h ${dir}/all.cxx
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${dir}
    COMMAND ${VERILATOR} ${flags} ${arg_PARAMETERS} -Irtl --top-module ${arg_TOP}
      --prefix ${arg_PREFIX} --Mdir ${dir} rtl/lint.vlt -f rtl/files.f ${lists}
      ${arg_SOURCES}
    COMMAND ${CMAKE_COMMAND} -D DIR=${dir} -D HARNESS=${arg_HARNESS}
      -P ${CMAKE_SOURCE_DIR}/cmake/VerilatedUnity.cmake
    DEPENDS ${rtl_files} ${arg_SOURCES} ${CMAKE_SOURCE_DIR}/cmake/VerilatedUnity.cmake
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "Verilating ${arg_PREFIX}" VERBATIM)
  set(kind STATIC)
  if(arg_MODULE)
    set(kind MODULE)
  endif()
  add_library(${target} ${kind} ${dir}/all.cxx ${dir}/${arg_PREFIX}.h)
  target_include_directories(${target} SYSTEM PUBLIC ${dir})
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR})
  target_compile_options(${target} PRIVATE ${options})
  if(arg_MODULE)
    target_include_directories(${target} SYSTEM PRIVATE
      $<TARGET_PROPERTY:ptm_verilator_runtime,INTERFACE_SYSTEM_INCLUDE_DIRECTORIES>)
    target_compile_definitions(${target} PRIVATE PTM_VARIANT_LIBRARY
      $<TARGET_PROPERTY:ptm_verilator_runtime,INTERFACE_COMPILE_DEFINITIONS>)
  else()
    target_link_libraries(${target} PUBLIC ptm_verilator_runtime)
  endif()
endfunction()
