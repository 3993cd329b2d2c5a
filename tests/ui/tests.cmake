fff_tests(tests_view LIBRARIES fff::view fff::session
    TESTS
        ui/tst_slab_mesh
        ui/view/tst_cut_caps
        ui/view/tst_frame_pace
        ui/view/tst_moved_scene
        ui/view/tst_scale_bar
        ui/view/tst_signs
        ui/view/tst_slit_covers
        ui/view/tst_steps_page
        ui/view/tst_steps_paper
        ui/view/tst_stress_marks
    ON_A_DISPLAY # pictures need its OpenGL
        ui/tst_offscreen_image
        ui/view/tst_field_painter
        ui/view/tst_renderer
        ui/view/tst_skin_scene
        ui/view/tst_things
    ALONE ui/view/tst_renderer)
target_compile_definitions(tests_view PRIVATE FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")

fff_tests(tests_ui LIBRARIES fff::ui TESTS
    ui/actions/tst_action_finder
    ui/actions/tst_menu_keys
    ui/actions/tst_menus
    ui/actions/tst_own_tool
    ui/base/tst_message_bar
    ui/bench/tst_first_sections
    ui/bench/tst_marked_scene
    ui/bench/tst_skin_picture
    ui/dialogs/tst_dialogs
    ui/dialogs/tst_export_dialog
    ui/dialogs/tst_export_files
    ui/dialogs/tst_export_looks
    ui/dialogs/tst_export_place
    ui/dialogs/tst_sheet_paths
    ui/dialogs/tst_stock_sheets
    ui/docks/tst_followed_fields
    ui/docks/tst_movement_rows
    ui/docks/tst_operations_docks
    ui/docks/tst_property_pages
    ui/docks/tst_stage_failures
    ui/docks/tst_trying_out
    ui/docks/tst_value_presets
    ui/docks/tst_value_trials
    ui/docks/tst_values_dock
    ui/docks/tst_weight_docks
    ui/files/tst_format_filters
    ui/files/tst_progress
    ui/files/tst_windows
    ui/help/tst_help
    ui/properties/tst_choice_box
    ui/properties/tst_link_row
    ui/properties/tst_slider_field
    ui/settings/tst_log
    ui/settings/tst_places
    ui/settings/tst_languages
    ui/settings/tst_settings
    ui/sheets/tst_sheet_properties
    ui/sheets/tst_sheets_dock
    ui/start/tst_samples
    ui/start/tst_start_page
    ui/tst_docks
    ui/tst_focus
    ui/tst_lengths
    ui/tst_measures
    ui/tst_names_in_german
    ui/tst_contrast
    ui/tst_everything_is_told
    ui/tst_nothing_is_cut
    ui/tst_plain_words
    ui/tst_stress_picture
    ui/tst_theme
    ui/tst_translations
    ui/tst_words_in_view
    ui/window/tst_badges
    ui/window/tst_dock_tabs
    ALONE ui/tst_translations)
target_compile_definitions(tests_ui PRIVATE FFF_SOURCES="${PROJECT_SOURCE_DIR}"
    FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples"
    FFF_LUPDATE="$<TARGET_FILE:Qt6::lupdate>")
if(FFF_SANITIZE) # dialogs load what draws, as on a display
    set_tests_properties(ui/dialogs/tst_dialogs PROPERTIES ENVIRONMENT_MODIFICATION "ASAN_OPTIONS=set:detect_leaks=0")
endif()

# A real window with a real OpenGL view.
set(windows
    ui/steps/tst_steps_view
    ui/tst_check_links
    ui/tst_context_menu
    ui/tst_drawing
    ui/tst_joints
    ui/tst_killed
    ui/tst_main_window
    ui/tst_making_window
    ui/tst_operations_window
    ui/tst_pen_window
    ui/tst_pens_and_fingers
    ui/tst_picture_window
    ui/tst_point_editing
    ui/tst_script_player
    ui/tst_template_window
    ui/tst_transform_window
    ui/tour/tst_tour
    ui/tst_weight_keys
    ui/window/tst_adjusting
    ui/window/tst_simple_window
    ui/window/tst_room_for_panels
    ui/window/tst_start_window
    ui/tst_by_keys)
fff_tests(tests_window LIBRARIES fff::ui ON_A_DISPLAY ${windows})
# The program itself, killed while it works.
target_compile_definitions(tests_window PRIVATE FFF_WINDOW="$<TARGET_FILE:flatfitfab>")
add_dependencies(tests_window flatfitfab)
set_tests_properties(ui/tst_killed PROPERTIES TIMEOUT 600)
# Windows of two programs on one display take the focus from each other.
set_tests_properties(${windows} PROPERTIES RESOURCE_LOCK focus)
