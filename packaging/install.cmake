# What an installed FlatFitFab has. Pictures, samples, help and languages are inside the programs; the system finds
# the programs by the files that are installed here. Relocatable: nothing here or in the programs names the prefix.
include(GNUInstallDirs)
set(FFF_APP_ID org.flatfitfab.FlatFitFab)
set(FFF_ADDRESS "" CACHE STRING
    "Web address of a folder with this project's files, for the pictures in software centres; empty: none are named")

# The day of the release, as CHANGELOG.md has it: a version without a section there cannot be packed.
file(STRINGS ${CMAKE_SOURCE_DIR}/CHANGELOG.md fff_section REGEX "^## ${PROJECT_VERSION} \\([0-9-]+\\)$")
if(NOT fff_section)
    message(FATAL_ERROR "CHANGELOG.md has no section \"## ${PROJECT_VERSION} (YYYY-MM-DD)\"")
endif()
string(REGEX REPLACE ".*\\((.*)\\)" "\\1" FFF_RELEASE_DATE "${fff_section}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/CHANGELOG.md)

install(TARGETS flatfitfab-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(FFF_BUILD_WINDOW)
    install(TARGETS flatfitfab RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
# Files that a teacher hands out.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/lessons DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/flatfitfab
    FILES_MATCHING PATTERN *.fff)
if(UNIX AND NOT APPLE)
    include(${CMAKE_CURRENT_LIST_DIR}/linux/desktop.cmake)
    include(${CMAKE_CURRENT_LIST_DIR}/linux/deb.cmake)
elseif(WIN32)
    include(${CMAKE_CURRENT_LIST_DIR}/windows/program.cmake)
endif()
