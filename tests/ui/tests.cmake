fff_test(ui/actions/tst_action_finder fff::ui)
fff_test(ui/dialogs/tst_dialogs fff::ui)

fff_test(ui/docks/tst_operations_docks fff::ui)
fff_test(ui/files/tst_progress fff::ui)
fff_test(ui/files/tst_windows fff::ui)
fff_test(ui/properties/tst_choice_box fff::ui)
fff_test(ui/properties/tst_link_row fff::ui)
fff_test(ui/properties/tst_slider_field fff::ui)
fff_test(ui/settings/tst_settings fff::ui)
fff_test(ui/start/tst_samples fff::ui)
fff_test(ui/tst_docks fff::ui)
fff_test(ui/tst_focus fff::ui)
fff_test(ui/tst_lengths fff::ui)
fff_test(ui/tst_measures fff::ui)
fff_test(ui/tst_names_in_german fff::ui)
fff_test(ui/tst_slab_mesh fff::view)
fff_test(ui/tst_theme fff::ui)
fff_test(ui/tst_translations fff::ui)
target_compile_definitions(tst_translations PRIVATE FFF_SOURCES="${PROJECT_SOURCE_DIR}"
    FFF_LUPDATE="$<TARGET_FILE:Qt6::lupdate>")

# A real window with a real OpenGL view: needs a display, which tests/run provides.
fff_test(ui/tst_main_window fff::ui)
set_tests_properties(ui/tst_main_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
fff_test(ui/tst_drawing fff::ui)
set_tests_properties(ui/tst_drawing PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
fff_test(ui/tst_pen_window fff::ui)
set_tests_properties(ui/tst_pen_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_point_editing fff::ui)
set_tests_properties(ui/tst_point_editing PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_joints fff::ui)
set_tests_properties(ui/tst_joints PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_operations_window fff::ui)
set_tests_properties(ui/tst_operations_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_transform_window fff::ui)
set_tests_properties(ui/tst_transform_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_making_window fff::ui)
set_tests_properties(ui/tst_making_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_pens_and_fingers fff::ui)
set_tests_properties(ui/tst_pens_and_fingers PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/tst_context_menu fff::ui)
set_tests_properties(ui/tst_context_menu PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

fff_test(ui/steps/tst_steps_view fff::ui)
set_tests_properties(ui/steps/tst_steps_view PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

# Pictures without a window still need a display's OpenGL.
fff_test(ui/tst_offscreen_image fff::view)
set_tests_properties(ui/tst_offscreen_image PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
fff_test(ui/view/tst_cut_caps fff::view)
fff_test(ui/view/tst_frame_pace fff::view)
fff_test(ui/view/tst_renderer fff::view)
set_tests_properties(ui/view/tst_renderer PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
fff_test(ui/view/tst_scale_bar fff::view)
fff_test(ui/view/tst_slit_covers fff::view)
fff_test(ui/view/tst_steps_paper fff::view)

fff_test(ui/tst_script_player fff::ui)
set_tests_properties(ui/tst_script_player PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")

# The program itself, killed while it works.
fff_test(ui/tst_killed fff::session)
target_compile_definitions(tst_killed PRIVATE FFF_WINDOW="$<TARGET_FILE:flatfitfab>")
add_dependencies(tst_killed flatfitfab)
set_tests_properties(ui/tst_killed PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb" TIMEOUT 600)

# Windows of two programs on one display take the focus from each other.
set_tests_properties(ui/tst_main_window ui/tst_drawing ui/tst_joints ui/tst_operations_window ui/tst_transform_window ui/tst_making_window ui/tst_pens_and_fingers ui/tst_context_menu ui/tst_pen_window ui/tst_point_editing ui/tst_script_player ui/steps/tst_steps_view ui/tst_killed PROPERTIES RESOURCE_LOCK focus)

if(FFF_SANITIZE)
    # Graphics drivers keep some memory, and are unloaded before it could be told from ours.
    foreach(test ui/dialogs/tst_dialogs ui/tst_drawing ui/tst_joints ui/tst_main_window ui/tst_pen_window ui/tst_offscreen_image ui/tst_point_editing ui/tst_script_player ui/steps/tst_steps_view ui/view/tst_renderer)
        set_tests_properties(${test} PROPERTIES ENVIRONMENT_MODIFICATION "ASAN_OPTIONS=set:detect_leaks=0")
    endforeach()
endif()
