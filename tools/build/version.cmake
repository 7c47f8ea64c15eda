cmake_policy(VERSION 3.25)
# Writes the version and the commit of SOURCE to OUT, with a "+" after the commit if tracked files differ from it.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
    set(commit "unknown")
else()
    execute_process(COMMAND git -C ${SOURCE} diff --quiet HEAD -- RESULT_VARIABLE changed ERROR_QUIET)
    if(changed)
        string(APPEND commit "+")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#define ODRAZ_VERSION \"@VERSION@\"\n#define ODRAZ_COMMIT \"@commit@\"\n" @ONLY)
