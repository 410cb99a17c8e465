# Debian packages of the two components: cpack -G DEB, or ./dev package.
install(FILES resources/desktop/70-breakaway.rules DESTINATION lib/udev/rules.d COMPONENT breakaway)
string(TIMESTAMP release_time "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(components breakaway)
if(BREAKAWAY_WINDOW)
  list(APPEND components breakaway-gui)
endif()
foreach(component ${components})
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${component})
  configure_file(cmake/package/changelog.Debian ${files}/${component}/changelog.Debian @ONLY)
  execute_process(COMMAND gzip -9nf ${files}/${component}/changelog.Debian)
  install(FILES cmake/package/copyright ${files}/${component}/changelog.Debian.gz DESTINATION ${folder}
    COMPONENT ${component})
endforeach()
configure_file(CHANGELOG.md ${files}/changelog COPYONLY)
execute_process(COMMAND gzip -9nf ${files}/changelog)
install(FILES ${files}/changelog.gz cmake/package/README.Debian DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/breakaway
  COMPONENT breakaway)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR Breakaway)
set(CPACK_PACKAGE_CONTACT "Breakaway's maintainers <maintainers@breakaway.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_BREAKAWAY_PACKAGE_NAME breakaway)
set(CPACK_DEBIAN_BREAKAWAY_PACKAGE_RECOMMENDS librsvg2-bin)
set(CPACK_DEBIAN_BREAKAWAY_PACKAGE_SUGGESTS breakaway-gui)
set(CPACK_DEBIAN_BREAKAWAY_DESCRIPTION "bench instrument for a servo motor's friction
 Measures what it takes to start a motor and to keep it moving at every angle,
 and says which physics a simulation of a recorded rig leaves out. These are the
 commands, and a board without hardware to try them on; no display is needed.")
set(CPACK_DEBIAN_BREAKAWAY-GUI_PACKAGE_NAME breakaway-gui)
set(CPACK_DEBIAN_BREAKAWAY-GUI_PACKAGE_DEPENDS
  "breakaway (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libqt6svg6, qt6-qpa-plugins, hicolor-icon-theme")
set(CPACK_DEBIAN_BREAKAWAY-GUI_PACKAGE_RECOMMENDS "fonts-dejavu-core, qt6-translations-l10n")
set(CPACK_DEBIAN_BREAKAWAY-GUI_DESCRIPTION "bench instrument for a servo motor's friction - window
 Measures what it takes to start a motor and to keep it moving at every angle,
 and says which physics a simulation of a recorded rig leaves out. This is the
 window: live signals, friction maps, tuning, and comparison of recordings.")
include(CPack)
