# cmake -D DIR=<folder> [-D HARNESS=<file>] -P VerilatedUnity.cmake - one file that includes all that
# Verilator wrote, whose names carry hashes and cannot be listed before it has run, and the harness.
file(GLOB sources RELATIVE ${DIR} ${DIR}/*.cpp)
list(SORT sources)
set(text "")
foreach(source IN LISTS sources)
  string(APPEND text "#include \"${source}\"\n")
endforeach()
if(HARNESS)
  string(APPEND text "#include \"${HARNESS}\"\n")
endif()
file(WRITE ${DIR}/all.cxx "${text}")
