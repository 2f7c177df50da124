# Data that becomes part of the program, so that it runs without its source folder.
#
# kappabench_inside(TARGET FUNCTION FILE...) compiles into TARGET
#   std::span<const std::pair<std::string_view, std::string_view>> kappabench::FUNCTION()
# which returns the name, as messages call it (from the top folder), and the text of each file, in the order given. A
# file that changes is compiled again.
# As a script (-P, with -DOUTPUT -DFUNCTION -DROOT -DFILES) this file writes that source.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(KAPPABENCH_INSIDE_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(kappabench_inside target function)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    # The list of names is a dependency too: a file that is gone must go from the program.
    list(JOIN ARGN "\n" names)
    set(known "")
    if(EXISTS ${output}.list)
      file(READ ${output}.list known)
    endif()
    if(NOT known STREQUAL "${names}\n")  # file(CONFIGURE) would see to this, but a name may hold @...@
      file(WRITE ${output}.list "${names}\n")
    endif()
    add_custom_command(
      OUTPUT ${output}
      COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${function} -DROOT=${PROJECT_SOURCE_DIR}
              -DFILES=${output}.list -P ${KAPPABENCH_INSIDE_SCRIPT}
      DEPENDS ${ARGN} ${output}.list ${KAPPABENCH_INSIDE_SCRIPT}
      VERBATIM)
    target_sources(${target} PRIVATE ${output})
    set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endfunction()
  return()
endif()

file(STRINGS "${FILES}" files)
set(entries "")
foreach(file IN LISTS files)
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  file(READ "${file}" text)
  # A literal for every line: no compiler's limit on the length of one is met, and no delimiter has to be chosen.
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\r" "\\r" text "${text}")
  string(REPLACE "\n" "\\n\"\n     \"" text "${text}")
  string(APPEND entries "    {\"${name}\",\n     \"${text}\"},\n")
endforeach()
list(LENGTH files count)
file(WRITE ${OUTPUT}
     "// Written by datasets/inside.cmake.
#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace kappabench {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, ${count}> files{{
${entries}}};

}  // namespace

std::span<const std::pair<std::string_view, std::string_view>> ${FUNCTION}();
std::span<const std::pair<std::string_view, std::string_view>> ${FUNCTION}() { return files; }

}  // namespace kappabench
")
