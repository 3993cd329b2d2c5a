# A folder that runs on Windows 10 and 11 from where it lies, with its own Qt and the compiler's libraries:
#   cmake -D BUILD=… -D SYSROOT=… -D FOLDER=… -P bundle.cmake
cmake_minimum_required(VERSION 3.25)
set(machine x86_64-w64-mingw32)
foreach(tool ${machine}-g++-posix ${machine}-objdump ${machine}-strip qtpaths6)
    find_program(${tool} ${tool} REQUIRED)
endforeach()
execute_process(COMMAND ${qtpaths6} --query QT_INSTALL_TRANSLATIONS
    OUTPUT_VARIABLE qt_translations OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${${machine}-g++-posix} -print-file-name=libstdc++-6.dll
    OUTPUT_VARIABLE compiler_library OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
get_filename_component(compiler_folder ${compiler_library} DIRECTORY)

# What every Windows has.
set(of_system "^(advapi32|api-ms-.*|authz|comdlg32|d2d1|d3d9|d3d11|d3d12|dwmapi|dwrite|dxgi|gdi32|imm32|kernel32|mpr|msvcrt|netapi32|ntdll|ole32|oleaut32|opengl32|qt6.*|rpcrt4|setupapi|shcore|shell32|shlwapi|user32|userenv|uxtheme|version|winmm|wtsapi32|ws2_32)\\.dll$")

file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(GLOB installed ${FOLDER}/bin/*)
foreach(program ${installed})
    get_filename_component(name ${program} NAME)
    file(RENAME ${program} ${FOLDER}/${name})
    list(APPEND programs ${FOLDER}/${name})
endforeach()
file(REMOVE_RECURSE ${FOLDER}/bin)
foreach(plugin platforms/qwindows.dll imageformats/qjpeg.dll imageformats/qgif.dll)
    configure_file(${SYSROOT}/plugins/${plugin} ${FOLDER}/plugins/${plugin} COPYONLY)
    list(APPEND plugins ${FOLDER}/plugins/${plugin})
endforeach()
# All that there are: CMake looks for them in lower case, which their names are not.
file(GLOB libraries ${SYSROOT}/bin/Qt6*.dll)
foreach(library ${libraries})
    configure_file(${library} ${FOLDER} COPYONLY)
endforeach()
file(GLOB libraries ${FOLDER}/Qt6*.dll)
file(GLOB translations ${qt_translations}/qtbase_*.qm)
file(COPY ${translations} DESTINATION ${FOLDER}/translations)

set(CMAKE_GET_RUNTIME_DEPENDENCIES_PLATFORM windows+pe)
set(CMAKE_GET_RUNTIME_DEPENDENCIES_TOOL objdump)
set(CMAKE_GET_RUNTIME_DEPENDENCIES_COMMAND ${${machine}-objdump})
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${programs} LIBRARIES ${libraries} MODULES ${plugins}
    DIRECTORIES ${SYSROOT}/bin ${compiler_folder} /usr/${machine}/lib
    RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing PRE_EXCLUDE_REGEXES ${of_system})
if(missing)
    message(FATAL_ERROR "not found: ${missing}")
endif()
foreach(library ${found})
    get_filename_component(name ${library} NAME)
    configure_file(${library} ${FOLDER}/${name} COPYONLY)
    list(APPEND libraries ${FOLDER}/${name})
endforeach()
execute_process(COMMAND ${${machine}-strip} --strip-unneeded ${programs} ${libraries} ${plugins} COMMAND_ERROR_IS_FATAL ANY)

file(WRITE ${FOLDER}/qt.conf "[Paths]\nPrefix=.\nPlugins=plugins\nTranslations=translations\n")
configure_file(${CMAKE_CURRENT_LIST_DIR}/../../LICENSE ${FOLDER}/LICENSE.txt COPYONLY)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/../../resources/licences/ DESTINATION ${FOLDER}/licences PATTERN *.cmake EXCLUDE)
configure_file(${CMAKE_CURRENT_LIST_DIR}/licences.txt ${FOLDER}/licences/windows.txt COPYONLY)
