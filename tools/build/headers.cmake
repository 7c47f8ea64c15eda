# Precompiled headers of the standard library and of GoogleTest, one set for all tools and one for all tests. Without
# them a third of the build time was spent on reading these headers.

# headers(NAME "PROCESSOR;..." "OPTION;..." HEADER...): precompiles the headers for each processor with the options, and
# sets HEADERS_NAME to the compiler options that include them first. The compiler uses the precompiled headers that
# match the options of a file; if none match, it reads the headers themselves.
function(headers name processors more)
    set(header ${GENERATED}/headers/${name}.h)
    list(TRANSFORM ARGN REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE lines)
    string(JOIN "" lines ${lines})
    file(CONFIGURE OUTPUT ${header} CONTENT "${lines}")
    get_directory_property(options COMPILE_OPTIONS)
    separate_arguments(given UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
    if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
        set(processors) # it uses none whose options differ at all
    endif()
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
