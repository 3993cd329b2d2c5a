# The pages of the help, those of a further language in a folder of its name, and their pictures. Embedded in fff_ui
# as :/help/NAME. The pictures are made by packaging/pictures.
set(help_folder ${CMAKE_CURRENT_LIST_DIR})
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${help_folder}/pictures.txt)
file(GLOB help_pages CONFIGURE_DEPENDS ${help_folder}/*.md ${help_folder}/*/*.md)
# All of them but for the steps, of which one is shown.
file(GLOB help_pictures CONFIGURE_DEPENDS ${help_folder}/*.png)
list(FILTER help_pictures EXCLUDE REGEX "/step-")
qt_add_resources(fff_ui help PREFIX /help BASE ${help_folder} FILES
    ${help_pages}
    ${help_pictures}
    ${help_folder}/step-04.png)
