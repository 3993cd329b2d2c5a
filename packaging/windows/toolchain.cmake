# Programs for 64-bit Windows, compiled with mingw-w64 against what packaging/windows/prepare made in build/windows/sysroot.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(machine x86_64-w64-mingw32)
# Threads of the standard library are POSIX's.
set(CMAKE_C_COMPILER ${machine}-gcc-posix)
set(CMAKE_CXX_COMPILER ${machine}-g++-posix)
set(CMAKE_RC_COMPILER ${machine}-windres)

get_filename_component(project ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
set(FFF_SYSROOT ${project}/build/windows/sysroot)
set(CMAKE_FIND_ROOT_PATH ${FFF_SYSROOT} /usr/${machine})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Qt's programs that run while building are this system's.
set(QT_HOST_PATH /usr)

# No times in the files, and no names of folders: two builds give the same bytes.
foreach(language C CXX)
    set(CMAKE_${language}_FLAGS_INIT "-ffile-prefix-map=${project}/=")
endforeach()
foreach(kind EXE SHARED MODULE)
    set(CMAKE_${kind}_LINKER_FLAGS_INIT "-Wl,--no-insert-timestamp")
endforeach()
