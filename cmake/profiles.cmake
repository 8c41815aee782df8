# Machine profiles: copied beside the executables so that the build tree finds them as an installed tree does.
file(GLOB profiles CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/lib/machine/profiles/*.toml)
set(copies)
foreach(profile IN LISTS profiles)
    get_filename_component(name ${profile} NAME)
    set(copy ${CMAKE_BINARY_DIR}/share/filum/profiles/${name})
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
