# Machine profiles and robot models: copied beside the executables so that the build tree finds them as an installed tree
# does.
file(GLOB profiles CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/lib/motion/machine/profiles/*.toml)
file(GLOB robots CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/lib/motion/machine/robots/*.toml)
set(copies)
foreach(profile IN LISTS profiles robots)
    file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR}/lib/motion/machine ${profile})
    set(copy ${CMAKE_BINARY_DIR}/share/filum/${name})
    add_custom_command(
        OUTPUT ${copy}
        COMMAND ${CMAKE_COMMAND} -E copy_if_different ${profile} ${copy}
        DEPENDS ${profile}
        VERBATIM)
    list(APPEND copies ${copy})
endforeach()
add_custom_target(profiles ALL DEPENDS ${copies})
if(TARGET filum_machine)
    add_dependencies(filum_machine profiles)
endif()
install(FILES ${profiles} DESTINATION share/filum/profiles)
install(FILES ${robots} DESTINATION share/filum/robots)
