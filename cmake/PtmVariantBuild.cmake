# ptm_variant_build(file generated extra stage...) - writes what testbench/rtl/variant_build.h
# declares, for the tables of effects in `generated` and the stages named, whose files lie with ours
# or in the folder `extra`, which may be empty.
function(ptm_variant_build file generated extra)
  # A cache of compilers would hold what is built once and kept.
  set(options -G "${CMAKE_GENERATOR}" -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DPTM_SANITIZE=${PTM_SANITIZE} -DCCACHE=OFF)
  foreach(effect IN LISTS PTM_EFFECTS_OFF)
    string(TOUPPER ${effect} effect)
    list(APPEND options -DPTM_EFFECT_${effect}=OFF)
  endforeach()
  set(files generated/rtl/ptm_effect_chain.sv)
  foreach(stage IN LISTS ARGN)
    set(name rtl/effects/ptm_effect_${stage}.sv)
    if(EXISTS ${CMAKE_SOURCE_DIR}/${name})
      list(APPEND files ${name})
    endif()
    if(extra AND EXISTS ${extra}/${name})
      list(APPEND files extra/${name})
    endif()
  endforeach()
  foreach(list IN ITEMS options files)
    list(TRANSFORM ${list} REPLACE "^.+$" "\"\\0\"")
    list(JOIN ${list} ", " ${list})
  endforeach()
  execute_process(COMMAND ${VERILATOR} --version OUTPUT_VARIABLE tools
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND tools " ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")

  # The assembler takes the files in: their bytes need not be C++ then.
  set(root ${CMAKE_SOURCE_DIR})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/rtl/* ${root}/testbench/sv/*
    ${root}/testbench/rtl/*.h ${root}/testbench/rtl/*.in ${root}/testbench/rtl/variant/CMakeLists.txt
    ${root}/model/reference/*.h ${root}/model/pipeline/*.h ${root}/cmake/*.cmake)
  list(APPEND sources ${root}/CMakeLists.txt ${root}/contract/effects.def
    ${generated}/rtl/ptm_effect_chain.sv ${PTM_CONTRACT_HEADERS})
  if(extra)
    file(GLOB_RECURSE extra_sources CONFIGURE_DEPENDS ${extra}/rtl/* ${extra}/model/*.h)
    list(APPEND sources ${extra_sources} ${extra}/effects.def)
  endif()
  set(assembly "")
  set(table "")
  set(number 0)
  foreach(source IN LISTS sources)
    set(name "")
    foreach(pair IN ITEMS "${root}|" "${PTM_GENERATED}|generated/" "${generated}|generated/"
        "${extra}|extra/")
      string(REGEX MATCH "^(.*)\\|(.*)$" pair "${pair}")
      set(folder "${CMAKE_MATCH_1}")
      set(prefix "${CMAKE_MATCH_2}")
      string(FIND "${source}" "${folder}/" at)
      if(folder AND at EQUAL 0)  # the last one: a build folder may lie within the sources
        string(LENGTH "${folder}/" length)
        string(SUBSTRING "${source}" ${length} -1 name)
        string(PREPEND name "${prefix}")
      endif()
    endforeach()
    string(APPEND assembly "asm(\".pushsection .rodata\\n\"\n    \"ptm_source_${number}: .incbin "
      "\\\"${source}\\\"\\n\"\n    \"ptm_source_${number}_end: .popsection\");\n"
      "extern \"C\" __attribute__((visibility(\"hidden\"))) const char ptm_source_${number}[], "
      "ptm_source_${number}_end[];\n")
    string(APPEND table "      {\"${name}\", {ptm_source_${number}, ptm_source_${number}_end}},\n")
    math(EXPR number "${number} + 1")
  endforeach()
  configure_file(${CMAKE_SOURCE_DIR}/testbench/rtl/embedded_sources.cpp.in ${file} @ONLY)
  set_source_files_properties(${file} PROPERTIES OBJECT_DEPENDS "${sources}")
endfunction()
