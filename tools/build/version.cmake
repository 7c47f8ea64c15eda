cmake_policy(VERSION 3.25)
# Writes the version and the commit of SOURCE to OUT, with a "+" after the commit if tracked files differ from it. The
# commit is "unknown" unless SOURCE is the top of a work tree.

# As tools/build/environment.sh does, forget variables that name another repository
execute_process(COMMAND git rev-parse --local-env-vars OUTPUT_VARIABLE names ERROR_QUIET)
string(REGEX MATCHALL "GIT_[A-Z_]+" names "${names}")
foreach(name ${names})
    if(NOT name MATCHES "CONFIG_")
        unset(ENV{${name}})
    endif()
endforeach()
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-prefix OUTPUT_VARIABLE prefix ERROR_VARIABLE error
    OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
if(failed AND EXISTS ${SOURCE}/.git)
    string(REGEX REPLACE "[ \t\n]+" " " error "${error}")
    message("warning: the film's version lacks its commit: ${error}")
endif()
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE no_commit)
if(failed OR no_commit OR NOT prefix STREQUAL "")
    set(commit "unknown")
else()
    execute_process(COMMAND git -C ${SOURCE} diff --quiet HEAD -- RESULT_VARIABLE changed ERROR_QUIET)
    if(changed)
        string(APPEND commit "+")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#define ODRAZ_VERSION \"@VERSION@\"\n#define ODRAZ_COMMIT \"@commit@\"\n" @ONLY)
