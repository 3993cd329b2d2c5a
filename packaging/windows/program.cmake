# What Windows shows of the programs: their icon, their version, and that they know long paths and text in UTF-8.
enable_language(RC)
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
find_program(FFF_ICOTOOL icotool REQUIRED)
set(made ${CMAKE_BINARY_DIR}/packaging)
file(MAKE_DIRECTORY ${made})
set(picture ${CMAKE_CURRENT_LIST_DIR}/../linux/${FFF_APP_ID}.svg)
set(FFF_ICON ${made}/flatfitfab.ico)
set(rendered)
foreach(size 16 24 32 48 64 256)
    set(file ${made}/icon-${size}.png)
    add_custom_command(OUTPUT ${file}
        COMMAND ${RSVG_CONVERT} -w ${size} -h ${size} ${picture} -o ${file}
        DEPENDS ${picture} VERBATIM)
    if(size EQUAL 256)
        list(APPEND pictures --raw=${file}) # as it is: it would take 256 kB otherwise
    else()
        list(APPEND pictures ${file})
    endif()
    list(APPEND rendered ${file})
endforeach()
add_custom_command(OUTPUT ${FFF_ICON}
    COMMAND ${FFF_ICOTOOL} --create --output=${FFF_ICON} ${pictures}
    DEPENDS ${rendered} VERBATIM)
add_custom_target(program_icon DEPENDS ${FFF_ICON})

string(REPLACE "." "," FFF_VERSION_COMMAS ${PROJECT_VERSION})
set(FFF_MANIFEST ${CMAKE_CURRENT_LIST_DIR}/program.manifest)
foreach(FFF_PROGRAM flatfitfab-cli flatfitfab)
    if(TARGET ${FFF_PROGRAM})
        configure_file(${CMAKE_CURRENT_LIST_DIR}/program.rc.in ${made}/${FFF_PROGRAM}.rc @ONLY)
        target_sources(${FFF_PROGRAM} PRIVATE ${made}/${FFF_PROGRAM}.rc)
        add_dependencies(${FFF_PROGRAM} program_icon)
    endif()
endforeach()
