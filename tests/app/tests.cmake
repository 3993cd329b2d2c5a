fff_test(app/tst_cli fff::io)
target_compile_definitions(tst_cli PRIVATE FFF_CLI="$<TARGET_FILE:flatfitfab-cli>")
add_dependencies(tst_cli flatfitfab-cli)
fff_test(app/tst_cli_assembly fff::session)
target_compile_definitions(tst_cli_assembly PRIVATE FFF_CLI="$<TARGET_FILE:flatfitfab-cli>")
add_dependencies(tst_cli_assembly flatfitfab-cli)
if(UNIX) # what the verbs print is caught
    fff_test(app/tst_faults fff_cli)
    target_compile_definitions(tst_faults PRIVATE
        FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")
endif()
if(FFF_BUILD_WINDOW)
    if(UNIX)
        fff_test(app/tst_faults_in_pictures fff_cli)
        set_tests_properties(app/tst_faults_in_pictures PROPERTIES LABELS gl
            ENVIRONMENT "QT_QPA_PLATFORM=xcb")
        if(FFF_SANITIZE)
            set_tests_properties(app/tst_faults_in_pictures PROPERTIES
                ENVIRONMENT_MODIFICATION "ASAN_OPTIONS=set:detect_leaks=0")
        endif()
    endif()
    # Pictures need a display's OpenGL.
    fff_test(app/tst_cli_steps fff::io)
    target_link_libraries(tst_cli_steps PRIVATE Qt6::Gui)
    target_compile_definitions(tst_cli_steps PRIVATE FFF_CLI="$<TARGET_FILE:flatfitfab-cli>")
    add_dependencies(tst_cli_steps flatfitfab-cli)
    set_tests_properties(app/tst_cli_steps PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
    if(FFF_SANITIZE) # as for the other tests that draw (ui/tests.cmake)
        set_tests_properties(app/tst_cli_steps PROPERTIES
            ENVIRONMENT_MODIFICATION "ASAN_OPTIONS=set:detect_leaks=0")
    endif()
endif()
