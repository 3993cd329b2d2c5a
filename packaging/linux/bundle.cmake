# A folder that runs wherever there is X or Wayland with OpenGL, also from a read-only stick, with its own Qt:
#   cmake -D BUILD=… -D FOLDER=… -P bundle.cmake
# There are no links within, so that sticks of any file system can hold it.
cmake_minimum_required(VERSION 3.25)
foreach(tool patchelf qtpaths6 strip)
    find_program(${tool} ${tool} REQUIRED)
endforeach()
execute_process(COMMAND ${qtpaths6} --query QT_INSTALL_PLUGINS
    OUTPUT_VARIABLE qt_plugins OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${qtpaths6} --query QT_INSTALL_TRANSLATIONS
    OUTPUT_VARIABLE qt_translations OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

# The system's own: the C library and the compiler's, and whatever drivers of OpenGL are linked to, which has to be what
# they were built with.
set(of_system "^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|stdc\\+\\+|gcc_s)\\.so.*)$"
    "^lib(GL|EGL|GLX|GLdispatch|GLESv2|gbm|drm|glapi)(\\.|-).*$"
    "^lib(X11|X11-xcb|xcb|Xau|Xdmcp|bsd|md|wayland-client|wayland-server|z|zstd|expat|ffi)\\.so.*$")
# What is loaded when the program runs; what is missing here (a plugin that Qt's version has not) is not needed.
set(wanted platforms/libqxcb.so platforms/libqoffscreen.so platforms/libqwayland-egl.so platforms/libqwayland-generic.so
    xcbglintegrations/libqxcb-glx-integration.so xcbglintegrations/libqxcb-egl-integration.so
    wayland-shell-integration/libxdg-shell.so wayland-decoration-client/libbradient.so
    wayland-graphics-integration-client/libqt-plugin-wayland-egl.so
    platforminputcontexts/libcomposeplatforminputcontextplugin.so
    platforminputcontexts/libibusplatforminputcontextplugin.so
    platformthemes/libqxdgdesktopportal.so imageformats/libqjpeg.so imageformats/libqgif.so)
set(needed platforms/libqxcb.so platforms/libqwayland-egl.so xcbglintegrations/libqxcb-glx-integration.so
    wayland-shell-integration/libxdg-shell.so wayland-graphics-integration-client/libqt-plugin-wayland-egl.so)

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER} --strip)
file(GLOB programs ${FOLDER}/bin/*)
foreach(program ${programs})
    get_filename_component(name ${program} NAME)
    file(RENAME ${program} ${FOLDER}/${name})
    list(APPEND executables ${FOLDER}/${name})
endforeach()
file(REMOVE_RECURSE ${FOLDER}/bin)
file(REMOVE ${FOLDER}/share/doc/flatfitfab/changelog.Debian.gz)
file(RENAME ${FOLDER}/share/doc/flatfitfab/lessons ${FOLDER}/lessons)

foreach(plugin ${wanted})
    if(EXISTS ${qt_plugins}/${plugin})
        get_filename_component(folder ${FOLDER}/plugins/${plugin} DIRECTORY)
        file(COPY ${qt_plugins}/${plugin} DESTINATION ${folder} FOLLOW_SYMLINK_CHAIN)
        list(APPEND plugins ${FOLDER}/plugins/${plugin})
    elseif(plugin IN_LIST needed)
        message(FATAL_ERROR "Qt's plugin ${plugin} is not installed (packaging/prepare package)")
    endif()
endforeach()
file(GLOB translations ${qt_translations}/qtbase_*.qm)
file(COPY ${translations} DESTINATION ${FOLDER}/translations)

file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${executables} MODULES ${plugins}
    RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing PRE_EXCLUDE_REGEXES ${of_system})
if(missing)
    message(FATAL_ERROR "not found: ${missing}")
endif()
foreach(library ${found})
    get_filename_component(name ${library} NAME)
    file(REAL_PATH ${library} real)
    configure_file(${real} ${FOLDER}/lib/${name} COPYONLY)
    list(APPEND libraries ${FOLDER}/lib/${name})
endforeach()

run(${strip} --strip-unneeded ${libraries} ${plugins})
foreach(file ${executables})
    run(${patchelf} --set-rpath $ORIGIN/lib ${file})
endforeach()
foreach(file ${libraries})
    run(${patchelf} --set-rpath $ORIGIN ${file})
endforeach()
foreach(file ${plugins})
    run(${patchelf} --set-rpath $ORIGIN/../../lib ${file})
endforeach()
file(WRITE ${FOLDER}/qt.conf "[Paths]\nPrefix=.\nPlugins=plugins\nTranslations=translations\n")
file(COPY ${CMAKE_CURRENT_LIST_DIR}/../../LICENSE DESTINATION ${FOLDER})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/../../resources/licences/ DESTINATION ${FOLDER}/licences PATTERN *.cmake EXCLUDE)
