# What `cmake --install` puts where: two components, each a Debian package. The programs find their resources from
# any prefix, by their own place.
include(GNUInstallDirs)
set(files ${CMAKE_BINARY_DIR}/installed)
set(folder_bash ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
set(folder_zsh ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
set(folder_fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# breakaway_install(PROGRAM COMPONENT): the program, and what it tells of itself: man page and completions.
function(breakaway_install program component)
  set(bash ${program})
  set(zsh _${program})
  set(fish ${program}.fish)
  set(tell ${CMAKE_COMMAND} -E make_directory ${files})
  foreach(shell bash zsh fish)
    list(APPEND tell COMMAND ${program} --help-as ${shell} > ${files}/${${shell}}.${shell})
    install(FILES ${files}/${${shell}}.${shell} RENAME ${${shell}} DESTINATION ${folder_${shell}} COMPONENT ${component})
  endforeach()
  list(APPEND tell COMMAND ${program} --help-as man > ${files}/${program}.1
    COMMAND gzip -9nf ${files}/${program}.1)
  add_custom_command(OUTPUT ${files}/${program}.1.gz COMMAND ${tell} DEPENDS ${program} VERBATIM
    COMMENT "What ${program} tells of itself")
  add_custom_target(${program}_tells ALL DEPENDS ${files}/${program}.1.gz)
  install(TARGETS ${program} RUNTIME COMPONENT ${component})
  install(FILES ${files}/${program}.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()

breakaway_install(breakaway breakaway)
breakaway_install(breakaway-board breakaway)
install(DIRECTORY resources/examples resources/help resources/presets resources/schemas
  DESTINATION ${CMAKE_INSTALL_DATADIR}/breakaway COMPONENT breakaway)
install(FILES resources/desktop/breakaway.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
  RENAME breakaway.xml COMPONENT breakaway)
install(FILES resources/icons/breakaway.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
  COMPONENT breakaway)
if(BREAKAWAY_WINDOW)
  breakaway_install(breakaway-gui breakaway-gui)
  install(FILES resources/desktop/breakaway-gui.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications
    COMPONENT breakaway-gui)
  string(TIMESTAMP release_day "%Y-%m-%d" UTC)
  configure_file(resources/desktop/breakaway-gui.metainfo.xml ${files}/breakaway-gui.metainfo.xml @ONLY)
  install(FILES ${files}/breakaway-gui.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
    COMPONENT breakaway-gui)
endif()
include(Package)
