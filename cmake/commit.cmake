# The commit that the programs are built from, beside them in share/filum/commit: what --version tells.  A file, so that
# a new commit links nothing anew.  Run as a script it writes the file TO, if it is to change, for the tree FROM.
if(CMAKE_SCRIPT_MODE_FILE)
    execute_process(COMMAND git -C ${FROM} describe --always --dirty=-changed --exclude=*
        OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(failed OR NOT EXISTS ${FROM}/.git)
        file(REMOVE ${TO})
        return()
    endif()
    file(CONFIGURE OUTPUT ${TO} CONTENT "${commit}\n" @ONLY)
    return()
endif()
add_custom_target(commit ALL
    COMMAND ${CMAKE_COMMAND} -D FROM=${CMAKE_SOURCE_DIR} -D TO=${CMAKE_BINARY_DIR}/share/filum/commit
            -P ${CMAKE_SOURCE_DIR}/cmake/commit.cmake VERBATIM)
install(FILES ${CMAKE_BINARY_DIR}/share/filum/commit DESTINATION share/filum OPTIONAL)
