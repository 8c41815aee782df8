# What an installed Filum is: `filum` on the PATH, the stages out of everyone's way, and what is generated from them.
include(GNUInstallDirs)

# Manual pages and shell completion, from what each command says about itself.
set(documents ${CMAKE_BINARY_DIR}/documents)
set(pages)
foreach(name IN LISTS FILUM_COMMANDS)
    set(page ${documents}/man/filum-${name}.1)
    if(name STREQUAL "filum")
        set(page ${documents}/man/filum.1)
    endif()
    add_custom_command(
        OUTPUT ${page} ${documents}/options/${name}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${documents}/man ${documents}/options
        COMMAND $<TARGET_FILE:${name}> --print-man > ${page}
        COMMAND $<TARGET_FILE:${name}> --print-completion > ${documents}/options/${name}
        DEPENDS ${name} VERBATIM)
    list(APPEND pages ${page})
    list(APPEND options ${documents}/options/${name})
endforeach()
add_custom_command(
    OUTPUT ${documents}/completion
    COMMAND cat ${options} > ${documents}/options.txt
    COMMAND ${CMAKE_COMMAND} -D OPTIONS=${documents}/options.txt -D TO=${documents}/completion
            -D FROM=${CMAKE_SOURCE_DIR}/cmake/completion.bash -P ${CMAKE_SOURCE_DIR}/cmake/completion.cmake
    DEPENDS ${options} ${CMAKE_SOURCE_DIR}/cmake/completion.bash VERBATIM)
add_custom_target(documents ALL DEPENDS ${pages} ${documents}/completion)

set(stages ${FILUM_COMMANDS})
list(REMOVE_ITEM stages filum)
install(TARGETS filum RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${stages} RUNTIME DESTINATION libexec/filum)
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${documents}/completion DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME filum)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "*.png")
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/proto/filum DESTINATION ${CMAKE_INSTALL_DATADIR}/filum/proto FILES_MATCHING PATTERN "*.proto")
if(IS_DIRECTORY ${CMAKE_SOURCE_DIR}/profiles)
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/profiles DESTINATION ${CMAKE_INSTALL_DATADIR}/filum)
endif()
