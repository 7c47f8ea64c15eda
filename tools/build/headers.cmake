# Headers of the standard library and of GoogleTest, compiled once for all tools and once for all tests. Reading them in
# every file took a third of the build time.

# headers(NAME "PROCESSOR;..." "OPTION;..." HEADER...): sets the variable HEADERS_NAME to the options that include these
# headers before all others. They are compiled for each of these processors, with these options. The compiler takes those
# that match the options of a file, and reads the headers themselves where none match.
function(headers name processors more)
    set(header ${GENERATED}/headers/${name}.h)
    list(TRANSFORM ARGN REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE lines)
    string(JOIN "" lines ${lines})
    file(CONFIGURE OUTPUT ${header} CONTENT "${lines}")
    get_directory_property(options COMPILE_OPTIONS)
    separate_arguments(given UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
    foreach(processor ${processors})
        set(compiled ${header}.gch/${processor})
        add_custom_command(OUTPUT ${compiled}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${header}.gch
            COMMAND ${CMAKE_CXX_COMPILER} ${given} -std=gnu++20 ${options} ${TOOL_FLAGS} ${more} -march=${processor}
                    -x c++-header ${header} -MD -MF ${GENERATED}/headers/${name}-${processor}.d -o ${compiled}
            DEPENDS ${header} DEPFILE ${GENERATED}/headers/${name}-${processor}.d VERBATIM)
        list(APPEND all ${compiled})
    endforeach()
    add_custom_target(headers_${name} DEPENDS ${all})
    set(HEADERS_${name} -include ${header} PARENT_SCOPE)
endfunction()
