# The pages of the help, those of a further language in a folder of its name, and their pictures. Embedded in fff_ui
# as :/help/NAME. The pictures are made by packaging/pictures.
set(help_folder ${CMAKE_CURRENT_LIST_DIR})
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${help_folder}/pictures.txt)
file(GLOB translated_help CONFIGURE_DEPENDS ${help_folder}/*/*.md)
qt_add_resources(fff_ui help PREFIX /help BASE ${help_folder} FILES
    ${help_folder}/first_steps.md
    ${help_folder}/more.md
    ${translated_help}
    ${help_folder}/dachshund.png
    ${help_folder}/labels.png
    ${help_folder}/glass.png
    ${help_folder}/step-04.png)
