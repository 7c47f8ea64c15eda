# Reads intro/film.conf and sets a variable for each key. Writes generated/film.h with the film's name and texts.
set(CONF ${CMAKE_CURRENT_SOURCE_DIR}/intro/film.conf)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CONF})
file(STRINGS ${CONF} lines REGEX "^[A-Z]")
foreach(line ${lines})
    if(NOT line MATCHES "^([A-Z_]+)=\"?([^\"\\\\;]*)\"?$")
        message(FATAL_ERROR "intro/film.conf: cannot use the line '${line}': write KEY=VALUE or KEY=\"VALUE\"")
    endif()
    set(${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
endforeach()
string(REPLACE " " ", " POSTER "${FILM_POSTER}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/film.h CONTENT "// Generated from intro/film.conf.
#pragma once
#define FILM_NAME \"@FILM@\"
#define FILM_ABOUT \"@FILM_ABOUT@\"
#define FILM_POSTER @POSTER@
" @ONLY)
