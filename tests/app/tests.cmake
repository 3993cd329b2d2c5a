fff_tests(tests_app LIBRARIES fff::session Polyclipping::Polyclipping TESTS
    app/tst_cli
    app/tst_cli_assembly
    app/tst_cli_cut
    app/tst_cli_cuts
    app/tst_cli_export
    app/tst_cli_facets
    app/tst_cli_input
    app/tst_cli_nest
    app/tst_cli_offcuts
    app/tst_cli_simulate
    app/tst_cli_skin
    app/tst_cli_slices
    app/tst_cli_suggest
    app/tst_lessons
    ALONE app/tst_cli_simulate)
target_compile_definitions(tests_app PRIVATE FFF_CLI="$<TARGET_FILE:flatfitfab-cli>"
    FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples"
    FFF_RESOURCES="${CMAKE_SOURCE_DIR}/resources")
add_dependencies(tests_app flatfitfab-cli)

fff_tests(tests_cli_values LIBRARIES fff_cli TESTS app/tst_cli_values)
target_compile_definitions(tests_cli_values PRIVATE FFF_CLI="$<TARGET_FILE:flatfitfab-cli>")
add_dependencies(tests_cli_values flatfitfab-cli)

# Cutting files of some samples, as other programs read them: of few and many parts, curves, marks, several sheets.
add_test(NAME app/cutting_files COMMAND ${FFF_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/check_cutting_files.py
    $<TARGET_FILE:flatfitfab-cli> ${CMAKE_SOURCE_DIR}/resources/samples/gears.fff
    ${CMAKE_SOURCE_DIR}/resources/samples/owl.fff ${CMAKE_SOURCE_DIR}/resources/samples/lamp.fff)

if(UNIX) # what the verbs print is caught
    fff_tests(tests_faults LIBRARIES fff_cli TESTS app/tst_cli_formats app/tst_faults)
    target_compile_definitions(tests_faults PRIVATE
        FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")
endif()
if(FFF_BUILD_WINDOW)
    target_compile_definitions(tests_app PRIVATE FFF_PROGRAM="$<TARGET_FILE:flatfitfab>")
    add_dependencies(tests_app flatfitfab)
    # Pictures need a display's OpenGL.
    fff_add_tests(tests_app ON_A_DISPLAY app/tst_cli_steps app/tst_help_pictures)
    if(UNIX)
        fff_add_tests(tests_faults ON_A_DISPLAY app/tst_faults_in_pictures)
    endif()
endif()

# The page of steps, in a real browser where there is one.
find_program(FFF_CHROMIUM NAMES chromium chromium-browser)
if(FFF_BUILD_WINDOW AND UNIX AND FFF_CHROMIUM AND FFF_THREE_JS)
    add_test(NAME app/steps_page COMMAND ${FFF_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/check_steps_page.py
        $<TARGET_FILE:flatfitfab-cli> ${CMAKE_SOURCE_DIR}/resources/samples/bridge.fff ${FFF_CHROMIUM})
    set_tests_properties(app/steps_page PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
endif()
