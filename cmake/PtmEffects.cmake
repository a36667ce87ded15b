# Reads testbench/plan/effects.def: options PTM_EFFECT_<ID> (ON), and what the build of each model
# takes from the rows that are ON, under ${PTM_GENERATED}:
#
#   effects/effects.def          the rows that are ON; a stage is in if a row that is ON uses it
#   effects/golden_effects.inc   for golden/effects/effect.cpp
#   effects/reference_stages.h   includes model/reference/effects/<stage>.h, lists PTM_STAGES(X)
#   effects/pipeline_stages.h    includes model/pipeline/effects/<stage>.h
#
# Lists: PTM_EFFECTS (ids that are ON), PTM_EFFECTS_OFF, PTM_STAGES (ids), PTM_STAGE_NUMBERS.
# PTM_EFFECTS_DEF may name another table (the test of a made-up effect).
set(PTM_GENERATED ${CMAKE_BINARY_DIR}/generated)
set(PTM_EFFECTS_DEF ${CMAKE_SOURCE_DIR}/testbench/plan/effects.def CACHE FILEPATH
  "The table of effects")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PTM_EFFECTS_DEF})

set(PTM_EFFECTS "")
set(PTM_EFFECTS_OFF "")
set(rows "")
set(used 0)
file(STRINGS ${PTM_EFFECTS_DEF} lines REGEX "^PTM_EFFECT\\(")
foreach(line IN LISTS lines)
  string(REGEX MATCH "^PTM_EFFECT\\(([a-z_0-9]+),.*, ([0-9]+)\\)$" matched "${line}")
  if(NOT matched)
    message(FATAL_ERROR "${PTM_EFFECTS_DEF}: no row of an effect: ${line}")
  endif()
  set(id ${CMAKE_MATCH_1})
  set(stages ${CMAKE_MATCH_2})
  string(TOUPPER ${id} upper)
  option(PTM_EFFECT_${upper} "Build the effect ${id}" ON)
  if(PTM_EFFECT_${upper})
    list(APPEND PTM_EFFECTS ${id})
    string(APPEND rows "${line}\n")
    math(EXPR used "${used} | ${stages}")
  else()
    list(APPEND PTM_EFFECTS_OFF ${id})
  endif()
endforeach()

set(PTM_STAGES "")
set(PTM_STAGE_NUMBERS "")
set(stage_rows "")
file(STRINGS ${PTM_EFFECTS_DEF} lines REGEX "^PTM_STAGE\\(")
foreach(line IN LISTS lines)
  string(REGEX MATCH "^PTM_STAGE\\(([0-9]+), ([a-z_0-9]+)\\)$" matched "${line}")
  if(NOT matched)
    message(FATAL_ERROR "${PTM_EFFECTS_DEF}: no row of a stage: ${line}")
  endif()
  math(EXPR bit "(${used} >> ${CMAKE_MATCH_1}) & 1")
  if(bit)
    list(APPEND PTM_STAGES ${CMAKE_MATCH_2})
    list(APPEND PTM_STAGE_NUMBERS ${CMAKE_MATCH_1})
    string(APPEND stage_rows "${line}\n")
  endif()
endforeach()

set(note "// Written by cmake/PtmEffects.cmake from the table of effects.\n")
set(golden "${note}")
foreach(id IN LISTS PTM_EFFECTS)
  string(APPEND golden "PTM_GOLDEN_EFFECT(${id})\n")
endforeach()
file(CONFIGURE OUTPUT ${PTM_GENERATED}/effects/effects.def CONTENT "${note}${stage_rows}${rows}")
file(CONFIGURE OUTPUT ${PTM_GENERATED}/effects/golden_effects.inc CONTENT "${golden}")
foreach(model IN ITEMS reference pipeline)
  set(includes "${note}#pragma once\n")
  set(all "")
  foreach(id IN LISTS PTM_STAGES)
    string(APPEND includes "#include \"model/${model}/effects/${id}.h\"\n")
    string(APPEND all " X(${id})")
  endforeach()
  string(TOUPPER ${model} upper)
  file(CONFIGURE OUTPUT ${PTM_GENERATED}/effects/${model}_stages.h CONTENT
    "${includes}#define PTM_${upper}_STAGES(X)${all}\n")
endforeach()
