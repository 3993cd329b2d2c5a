# The Debian package: cpack in a build folder makes it of what is installed; packaging/make deb does all.
set(FFF_MAINTAINER "The makers of FlatFitFab <flatfitfab@example.org>" CACHE STRING
    "Who answers for the Debian package, with an address; who publishes it names his own")
set(docs ${CMAKE_INSTALL_DATADIR}/doc/flatfitfab)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${docs})
configure_file(${CMAKE_SOURCE_DIR}/CHANGELOG.md ${CMAKE_BINARY_DIR}/packaging/changelog COPYONLY)
fff_install_compressed(${CMAKE_BINARY_DIR}/packaging/changelog ${docs})
execute_process(COMMAND date -u -R -d ${FFF_RELEASE_DATE} ENCODING UTF8
    OUTPUT_VARIABLE day OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${CMAKE_BINARY_DIR}/packaging/changelog.Debian "flatfitfab (${PROJECT_VERSION}-1) stable; urgency=medium

  * Version ${PROJECT_VERSION}; changelog.gz says what is new.

 -- ${FFF_MAINTAINER}  ${day}
")
fff_install_compressed(${CMAKE_BINARY_DIR}/packaging/changelog.Debian ${docs})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME flatfitfab)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${FFF_MAINTAINER})
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What no program is linked to: the platforms that Qt loads, and the words on its own buttons.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-qpa-plugins, qt6-translations-l10n")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-wayland, libgl1-mesa-dri, fonts-noto-core")
# Japanese and Chinese; whoever has neither does without 57 MB.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "draw flat parts in 3D, see whether they hold, cut them")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "FlatFitFab draws flat parts straight in 3D and makes the slits in which
they slide into each other. It says while you draw whether the model
stands, holds together, can be put together and is strong enough.
.
It writes cutting files for laser cutters as SVG, DXF, PDF, LightBurn
projects and G-code, with every part and joint numbered.")
include(CPack)
