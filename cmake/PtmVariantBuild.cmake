# ptm_variant_build(file generated extra stage...) - writes what testbench/rtl/variant_build.h
# declares, for the tables of effects in `generated` and the stages named, whose files lie with ours
# or in the folder `extra`, which may be empty.
function(ptm_variant_build file generated extra)
  set(options -G "${CMAKE_GENERATOR}" -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DPTM_SANITIZE=${PTM_SANITIZE}
    -DPTM_EFFECTS_EXTRA=${extra})
  foreach(effect IN LISTS PTM_EFFECTS_OFF)
    string(TOUPPER ${effect} effect)
    list(APPEND options -DPTM_EFFECT_${effect}=OFF)
  endforeach()
  set(files ${generated}/rtl/ptm_effect_chain.sv)
  foreach(stage IN LISTS ARGN)
    foreach(folder IN ITEMS ${CMAKE_SOURCE_DIR} ${extra})
      if(EXISTS ${folder}/rtl/effects/ptm_effect_${stage}.sv)
        list(APPEND files ${folder}/rtl/effects/ptm_effect_${stage}.sv)
      endif()
    endforeach()
  endforeach()
  foreach(list IN ITEMS options files)
    list(TRANSFORM ${list} REPLACE "^.+$" "\"\\0\"")
    list(JOIN ${list} ", " ${list})
  endforeach()
  execute_process(COMMAND ${VERILATOR} --version OUTPUT_VARIABLE tools
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND tools " ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  configure_file(${CMAKE_SOURCE_DIR}/testbench/rtl/variant_build.cpp.in ${file} @ONLY)
endfunction()
