# The page of steps, embedded in fff_view as :/steps_page/NAME. The model in it is drawn by three.js as Debian has it
# (libjs-three), which is as free as our own code; nothing is fetched.
set(steps_page_folder ${CMAKE_CURRENT_LIST_DIR})
find_file(FFF_THREE_JS three.min.js PATHS /usr/share/javascript/three DOC "three.js, for the page of steps")
set(steps_page_files template.html page.css shapes.js playback.js model.js marks.js fingers.js page.js)
list(TRANSFORM steps_page_files PREPEND ${steps_page_folder}/)
qt_add_resources(fff_view steps_page PREFIX /steps_page BASE ${steps_page_folder} FILES ${steps_page_files})
if(FFF_THREE_JS)
    configure_file(${FFF_THREE_JS} ${CMAKE_CURRENT_BINARY_DIR}/steps_page/three.min.js COPYONLY)
    configure_file(${steps_page_folder}/../licences/mit.txt ${CMAKE_CURRENT_BINARY_DIR}/steps_page/mit.txt COPYONLY)
    qt_add_resources(fff_view steps_page_three PREFIX /steps_page BASE ${CMAKE_CURRENT_BINARY_DIR}/steps_page FILES
        ${CMAKE_CURRENT_BINARY_DIR}/steps_page/three.min.js ${CMAKE_CURRENT_BINARY_DIR}/steps_page/mit.txt)
else()
    message(STATUS "three.min.js was not found (Debian: libjs-three): the page of steps is made of pictures alone")
endif()
