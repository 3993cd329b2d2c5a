# How a Linux system knows the programs: manual pages, shells' completion, and for the window its entry in menus, its
# kinds of files and their icons, pictures of models in file managers, and its page in software centres.
set(linux ${CMAKE_CURRENT_LIST_DIR})
set(made ${CMAKE_BINARY_DIR}/packaging)
find_program(FFF_GZIP gzip)

# What is compressed in an installed system; -n leaves out names and times, so that two builds are the same.
#   fff_install_compressed(FILE FOLDER)
function(fff_install_compressed file folder)
    if(FFF_GZIP)
        execute_process(COMMAND ${FFF_GZIP} -9nkf ${file} COMMAND_ERROR_IS_FATAL ANY)
        set(file ${file}.gz)
    endif()
    install(FILES ${file} DESTINATION ${folder})
endfunction()

set(pages flatfitfab-cli)
if(FFF_BUILD_WINDOW)
    list(APPEND pages flatfitfab)
endif()
foreach(page ${pages})
    configure_file(${linux}/man/${page}.1.in ${made}/${page}.1 @ONLY)
    fff_install_compressed(${made}/${page}.1 ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${linux}/completion/${page}.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${page})
    install(FILES ${linux}/completion/_${page} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
    install(FILES ${linux}/completion/${page}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endforeach()
if(NOT FFF_BUILD_WINDOW)
    return()
endif()

set(FFF_METAINFO_ADDRESSES)
if(FFF_ADDRESS)
    set(FFF_METAINFO_ADDRESSES "  <url type=\"homepage\">${FFF_ADDRESS}</url>
  <screenshots>
    <screenshot type=\"default\">
      <caption>A dachshund of ten sections</caption>
      <image>${FFF_ADDRESS}/resources/help/dachshund.png</image>
    </screenshot>
    <screenshot>
      <caption>Where a glass breaks the thin legs of its stand</caption>
      <image>${FFF_ADDRESS}/resources/help/glass.png</image>
    </screenshot>
  </screenshots>")
endif()
configure_file(${linux}/${FFF_APP_ID}.metainfo.xml.in ${made}/${FFF_APP_ID}.metainfo.xml @ONLY)
install(FILES ${made}/${FFF_APP_ID}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${linux}/${FFF_APP_ID}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${linux}/flatfitfab.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME flatfitfab.xml)
install(FILES ${linux}/flatfitfab.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)

# The program's icon, and its kinds of files with the same picture.
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
set(kinds application-x-flatfitfab x-model-x-flatfab)
set(picture ${linux}/${FFF_APP_ID}.svg)
install(FILES ${picture} DESTINATION ${icons}/scalable/apps)
foreach(kind ${kinds})
    install(FILES ${picture} DESTINATION ${icons}/scalable/mimetypes RENAME ${kind}.svg)
endforeach()
set(rendered)
foreach(size 16 24 32 48 64 128 256)
    set(file ${made}/icon-${size}.png)
    add_custom_command(OUTPUT ${file}
        COMMAND ${RSVG_CONVERT} -w ${size} -h ${size} ${picture} -o ${file}
        DEPENDS ${picture} VERBATIM)
    list(APPEND rendered ${file})
    install(FILES ${file} DESTINATION ${icons}/${size}x${size}/apps RENAME ${FFF_APP_ID}.png)
    foreach(kind ${kinds})
        install(FILES ${file} DESTINATION ${icons}/${size}x${size}/mimetypes RENAME ${kind}.png)
    endforeach()
endforeach()
add_custom_target(program_icons DEPENDS ${rendered})
add_dependencies(flatfitfab program_icons)
