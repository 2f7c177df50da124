# Writes the commit of the checkout into a header, and only when it changed: run at every build.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git rev-parse HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git status --porcelain WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changes ERROR_QUIET)
if(NOT commit)
  set(commit "unknown")
endif()
if(changes)
  set(dirty "true")
else()
  set(dirty "false")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT
"#pragma once
#define KAPPABENCH_COMMIT \"@commit@\"
#define KAPPABENCH_DIRTY \"@dirty@\"
" @ONLY)
