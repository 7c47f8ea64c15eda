# Portable tools for tools/release, which also run on older systems: build/portable/NAME. They are linked from the
# objects of the ordinary programs.
add_custom_target(portable)

# portable(PROGRAM static|dynamic): links the portable program. "static": it needs no library. "dynamic", for a program
# that opens libraries by name: it needs glibc 2.31 or later; old_glibc.cpp replaces newer functions.
function(portable program how)
    add_executable(${program}-portable EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${program}>)
    add_dependencies(portable ${program}-portable)
    set_target_properties(${program}-portable PROPERTIES OUTPUT_NAME ${program}
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/portable)
    get_target_property(libraries ${program} LINK_LIBRARIES)
    target_link_libraries(${program}-portable PRIVATE ${libraries})
    target_link_options(${program}-portable PRIVATE -s -Wl,--build-id=none)
    if(how STREQUAL static)
        target_link_options(${program}-portable PRIVATE -static)
        return()
    endif()
    target_sources(${program}-portable PRIVATE ${CMAKE_SOURCE_DIR}/tools/build/portable/old_glibc.cpp)
    # Before glibc 2.34 threads and dlopen were in separate libraries
    target_link_options(${program}-portable PRIVATE -static-libstdc++ -static-libgcc
        -Wl,--no-as-needed -l:libpthread.so.0 -l:libdl.so.2 -Wl,--as-needed)
    foreach(name arc4random dlopen dlsym fstat fstat64 hypot lstat pthread_create pthread_detach pthread_getspecific pthread_join
            pthread_key_create pthread_key_delete pthread_once pthread_rwlock_rdlock
            pthread_rwlock_unlock pthread_rwlock_wrlock pthread_setspecific stat _dl_find_object
            __libc_single_threaded __libc_start_main __pthread_key_create)
        target_link_options(${program}-portable PRIVATE -Wl,--wrap=${name})
    endforeach()
endfunction()
